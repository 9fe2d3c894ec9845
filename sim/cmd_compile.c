/* SPDX-License-Identifier: MIT
 *
 * limner compile MODEL -o NAME: writes NAME.c, NAME.h and NAME.lim, all or none, and says what the
 * scene costs. */
#include "commands.h"
#include "parse.h"
#include "scene_files.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum option_code {
    OPTION_TOLERANCE = 256,
    OPTION_SPLITTER,
    OPTION_KEEP_FACES,
    OPTION_UNLIT,
    OPTION_SIZE,
    OPTION_PRECISION,
    OPTION_REPORT
};

static const struct option OPTIONS[] = {
    {"tolerance", required_argument, NULL, OPTION_TOLERANCE},
    {"splitter", required_argument, NULL, OPTION_SPLITTER},
    {"keep-faces", no_argument, NULL, OPTION_KEEP_FACES},
    {"unlit", no_argument, NULL, OPTION_UNLIT},
    {"precision", required_argument, NULL, OPTION_PRECISION},
    {"size", required_argument, NULL, OPTION_SIZE},
    {"report", no_argument, NULL, OPTION_REPORT},
    {NULL, 0, NULL, 0},
};

struct request {
    const char *model, *name; /* what to compile, and the path to write to, without suffix */
    struct compile_options compile;
    bool report_only;
};

static bool parse_option(int code, char **argv, struct request *out, struct error *err)
{
    switch (code) {
    case 'o':
        out->name = optarg;
        return *optarg || error_set(err, "-o: needs a name");
    case OPTION_TOLERANCE:
        return parse_tolerance(optarg, &out->compile.tolerance_units, err);
    case OPTION_SPLITTER:
        out->compile.splitter = optarg;
        return true;
    case OPTION_KEEP_FACES:
        out->compile.keep_faces = true;
        return true;
    case OPTION_UNLIT:
        out->compile.unlit = true;
        return true;
    case OPTION_PRECISION:
        return parse_precision(optarg, &out->compile.core, err);
    case OPTION_SIZE:
        return parse_size(optarg, &out->compile.w_px, &out->compile.h_px, err);
    case OPTION_REPORT:
        out->report_only = true;
        return true;
    case ':':
        return error_set(err, "%s: needs a value", argv[optind - 1]);
    default:
        return error_set(err, "%s: no such option here; `limner help` lists them", argv[optind - 1]);
    }
}

static bool parse(int argc, char **argv, struct request *out, struct error *err)
{
    *out = (struct request){
        .compile = {.tolerance_units = 0.5, .splitter = "auto", .w_px = 240, .h_px = 240, .predict = true}};
    out->compile.progress = isatty(STDERR_FILENO);
    opterr = 0;
    optind = 1;
    for (int code; (code = getopt_long(argc, argv, ":o:", OPTIONS, NULL)) != -1;)
        if (!parse_option(code, argv, out, err)) return false;
    if (optind >= argc) return error_set(err, "compile: needs a model");
    if (optind + 1 < argc) return error_set(err, "compile: one model at a time, what is '%s'?", argv[optind + 1]);
    out->model = argv[optind];
    return out->name || out->report_only || error_set(err, "compile: needs -o NAME, or --report alone");
}

static bool write_files(const struct compiled *scene, const char *name, struct error *err)
{
    char path[1024];
    struct outputs outputs = {0};
    if (snprintf(path, sizeof path, "%s.lim", name) >= (int)sizeof path)
        return error_set(err, "-o '%.64s...': the path is too long", name);
    bool ok = c_source_put(scene, name, &outputs, err) && lim_file_put(scene, path, &outputs, err);
    return scene_files_finish(&outputs, ok, err);
}

static bool run(const struct request *request, struct error *err)
{
    struct compiled scene;
    if (!compile_model(request->model, &request->compile, &scene, err)) return false;
    bool ok = !request->name || write_files(&scene, request->name, err);
    if (ok) compile_report_print(&scene, request->name ? request->name : request->model);
    compiled_free(&scene);
    return ok;
}

int cmd_compile(int argc, char **argv)
{
    struct request request;
    struct error err;
    bool ok = parse(argc, argv, &request, &err) && run(&request, &err);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
