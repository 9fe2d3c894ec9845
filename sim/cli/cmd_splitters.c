/* SPDX-License-Identifier: MIT
 *
 * `limner splitters MODEL`: the same model with every heuristic of the tree builder, a row each: depth, splits, nodes,
 * bytes, and what a frame costs on cameras sampled in the scene's free space. What moves in it is left out, as the
 * tree of a scene holds what stands still. */
#include "base/deadline.h"
#include "base/parse.h"
#include "base/printable.h"
#include "cli/commands.h"
#include "compiler/compile.h"
#include "compiler/faithful.h"
#include "model/baked_light.h"
#include "model/model_part.h"
#include "readers/model_read.h"
#include "scene/compiled.h"
#include "trees/splitter.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum option_code { OPTION_TREE = 256, OPTION_TOLERANCE, OPTION_SIZE, OPTION_KEEP_FACES };

static const struct option OPTIONS[] = {
    {"tree", required_argument, NULL, OPTION_TREE},
    {"tolerance", required_argument, NULL, OPTION_TOLERANCE},
    {"size", required_argument, NULL, OPTION_SIZE},
    {"keep-faces", no_argument, NULL, OPTION_KEEP_FACES},
    COMPILE_MODEL_OPTIONS,
    {NULL, 0, NULL, 0},
};

static bool parse_option(int code, char **argv, struct compile_options *out, struct error *err)
{
    if (compile_options_know(code)) return compile_options_take(code, optarg, out, err);
    switch (code) {
    case OPTION_TREE:
        return tree_kind_parse(optarg, &out->tree, err);
    case OPTION_TOLERANCE:
        return parse_tolerance(optarg, &out->tolerance_units, err);
    case OPTION_SIZE:
        return parse_size(optarg, &out->w_px, &out->h_px, err);
    case OPTION_KEEP_FACES:
        out->keep_faces = true;
        return true;
    case ':':
        return error_set(err, "%s: needs a value", argv[optind - 1]);
    default:
        return error_no_option(err, argv[optind - 1]);
    }
}

static bool parse(int argc, char **argv, struct compile_options *out, const char **model, struct error *err)
{
    *out = (struct compile_options){.tolerance_units = 0.5, .tree = TREE_BSP, .w_px = 240, .h_px = 240};
    opterr = 0;
    optind = 1;
    for (int code; (code = getopt_long(argc, argv, ":", OPTIONS, NULL)) != -1;)
        if (!parse_option(code, argv, out, err)) return false;
    if (out->tree == TREE_NONE || out->tree == TREE_MESH)
        return error_set(err, "splitters: a %s has no planes to choose", out->tree == TREE_NONE ? "set" : "mesh");
    if (optind >= argc) return error_set(err, "splitters: needs a model");
    if (optind + 1 < argc) return error_set(err, "splitters: one model at a time, what is '%s'?", argv[optind + 1]);
    *model = argv[optind];
    return true;
}

static void print_row(const char *name, const struct compiled *scene)
{
    const struct compile_report *report = &scene->report;
    printf("| %-8s | %-11s | %5zu | %6zu | %8zu | %5u | %6zu |", name, report->splitter, report->depth, report->splits,
           report->polygons_out, (unsigned)scene->scene.node_count, report->flash_b);
    if (isnan(report->instructions))
        printf(" %12s |\n", "-");
    else
        printf(" %12.0f |\n", report->instructions);
}

/* What stands still, with its light; and how many objects do not. */
static bool read_still(const char *path, const struct compile_options *options, struct model *still, uint32_t **numbers,
                       size_t *movers, struct error *err)
{
    struct model model;
    *numbers = NULL;
    if (!model_read(path, &options->orientation, &model, err)) return false;
    model_tell(path, &model);
    (options->unlit ? light_none : light_bake)(&model);
    *movers = model.mover_count;
    *still = model;
    if (!*movers) return true;
    model_part(&model, 0, true, still, numbers);
    model_free(&model);
    if (still->face_count) return true;
    model_free(still);
    free(*numbers);
    return error_set(err, "%s: everything in it is animated; nothing stands still", path);
}

static void print_head(const char *path, const struct compiled *scene, const struct compile_options *options,
                       size_t movers)
{
    printable_print(stdout, "%s, tree %s; instructions a frame on Cortex-M0+, predicted, %ux%u pixels\n", path,
                    tree_names[scene->report.tree], options->w_px, options->h_px);
    if (movers) printf("What stands still alone; objects that move: %zu\n", movers);
    printf("\n| splitter | taken       | depth | splits | polygons | nodes |  bytes | instructions |\n"
           "|---|---|---|---|---|---|---|---|\n");
}

/* A heuristic may fail where another one does not: its tree becomes too large. */
static bool print_rows(const char *path, const struct model *still, size_t movers, struct compile_options *options,
                       struct error *err)
{
    bool any = false;
    for (size_t i = 0; i < splitter_name_count; i++) {
        struct compiled scene;
        options->splitter = splitter_names[i];
        const bool ok = compile_part(still, NULL, options, &scene, err);
        if (!ok) {
            error_prefix(err, path);
            if (deadline_passed() && (!any)) return false;
            if (any) printf("| %-8s | %s |\n", splitter_names[i], err->text);
            continue;
        }
        if (!any) faithful_note(&scene);
        if (!any) print_head(path, &scene, options, movers);
        print_row(splitter_names[i], &scene);
        compiled_free(&scene);
        any = true;
    }
    if (any) deadline_say("the rows that have figures");
    return any;
}

static bool run(const char *path, struct compile_options *options, struct error *err)
{
    struct model still;
    uint32_t *numbers;
    size_t movers;
    if (!read_still(path, options, &still, &numbers, &movers, err)) return false;
    const bool ok = print_rows(path, &still, movers, options, err);
    model_free(&still);
    free(numbers);
    return ok;
}

int cmd_splitters(int argc, char **argv)
{
    struct compile_options options;
    struct error err;
    const char *model = NULL;
    const bool ok = parse(argc, argv, &options, &model, &err) && run(model, &options, &err);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
