/* SPDX-License-Identifier: MIT
 *
 * limner compile MODEL... -o NAME: writes NAME.c, NAME.h and NAME.lim, all or none, and says what the
 * scene costs. Of several models each becomes NAME_MODEL.c and .lim; they share NAME.h. What is said is a summary that
 * ends with what to do next, or with --report all that there is to say. */
#include "base/printable.h"
#include "cli/commands.h"
#include "cli/compile_request.h"
#include "outputs/written.h"

#include <stdio.h>
#include <stdlib.h>

static bool put_scene(const struct named_scene *scene, const char *header, struct outputs *outputs, struct error *err)
{
    char path[C_PATH_MAX_B];
    return c_path(path, scene->name, ".lim", err) && c_source_put(scene, header, outputs, err) &&
           lim_file_put(scene->scene, path, outputs, err) &&
           (!scene->moving || (c_movers_put(scene, header, outputs, err) && lim_movers_put(scene, outputs, err)));
}

static bool write_files(const struct compile_result *result, const char *name, char written[WRITTEN_B],
                        struct error *err)
{
    struct outputs outputs = {0};
    bool ok = c_header_put(result->named, result->count, name, &outputs, err);
    for (size_t i = 0; ok && i < result->count; i++)
        ok = put_scene(&result->named[i], name, &outputs, err);
    if (ok) return outputs_keep_untold(&outputs, written, err);
    outputs_discard(&outputs);
    return false;
}

static bool moves(const struct compile_result *result)
{
    for (size_t i = 0; i < result->count; i++)
        if (result->moving[i].count) return true;
    return false;
}

/* A .lim file holds what stands still alone. */
static void print_next(const struct compile_request *request, const struct compile_result *result)
{
    const char *scene = moves(result) ? request->models[0] : result->names[0];
    printable_print(stdout, "  %-14s limner render %s%s --gif %s.gif shows it\n", "next", scene,
                    moves(result) ? "" : ".lim", result->names[0]);
    printable_print(
        stdout, "  %-14s limner export %s --for pico -o FOLDER makes a project of it; --report tells all the rest\n",
        "", request->models[0]);
}

static void report(const struct compile_request *request, const struct compile_result *result, const char *written)
{
    if (request->report) written_say(written);
    compile_result_report(request, result);
    if (request->report) return;
    printf("  %s\n", written);
    print_next(request, result);
}

static bool run(struct compile_request *request, struct error *err)
{
    struct compile_result result;
    char written[WRITTEN_B] = "";
    request->has_lim = request->name != NULL;
    bool ok = compile_request_run(request, &result, err) &&
              (!request->name || write_files(&result, request->name, written, err));
    if (ok) report(request, &result, written);
    compile_result_free(&result);
    return ok;
}

static bool is_asked(const struct compile_request *request, struct error *err)
{
    return request->name || request->report || error_set(err, "compile: needs -o NAME, or --report alone");
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
