/* SPDX-License-Identifier: MIT
 *
 * limner compile MODEL... -o NAME: writes NAME.c, NAME.h and NAME.lim, all or none, and says what the
 * scene costs. Of several models each becomes NAME_MODEL.c and .lim; they share NAME.h. */
#include "cli/commands.h"
#include "cli/compile_request.h"

#include <stdio.h>
#include <stdlib.h>

static bool put_scene(const struct named_scene *scene, const char *header, struct outputs *outputs, struct error *err)
{
    char path[C_PATH_MAX_B];
    return c_path(path, scene->name, ".lim", err) && c_source_put(scene, header, outputs, err) &&
           lim_file_put(scene->scene, path, outputs, err) &&
           (!scene->moving || (c_movers_put(scene, header, outputs, err) && lim_movers_put(scene, outputs, err)));
}

static bool write_files(const struct compile_result *result, const char *name, struct error *err)
{
    struct outputs outputs = {0};
    bool ok = c_header_put(result->named, result->count, name, &outputs, err);
    for (size_t i = 0; ok && i < result->count; i++)
        ok = put_scene(&result->named[i], name, &outputs, err);
    return scene_files_finish(&outputs, ok, err);
}

static bool run(struct compile_request *request, struct error *err)
{
    struct compile_result result;
    request->has_lim = request->name != NULL;
    bool ok =
        compile_request_run(request, &result, err) && (!request->name || write_files(&result, request->name, err));
    if (ok) compile_result_report(request, &result);
    compile_result_free(&result);
    return ok;
}

static bool is_asked(const struct compile_request *request, struct error *err)
{
    return request->name || request->report_only || error_set(err, "compile: needs -o NAME, or --report alone");
}

int cmd_compile(int argc, char **argv)
{
    struct compile_request request;
    struct error err;
    bool ok = compile_request_parse(argc, argv, &request, &err) && is_asked(&request, &err) && run(&request, &err);
    compile_options_free(&request.compile);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
