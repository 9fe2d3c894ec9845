/* SPDX-License-Identifier: MIT
 *
 * Options and their lists of names, divided by commas. */
#include "measure/measure_request.h"

#include "base/child.h"
#include "base/parse.h"
#include "base/printable.h"
#include "base/progress.h"
#include "compiler/compile.h"
#include "core/core.h"
#include "levels/level_path.h"
#include "scene/scene_files.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum option_code {
    OPTION_CAMERA = 256,
    OPTION_SIZE,
    OPTION_PRECISION,
    OPTION_SUB_BITS,
    OPTION_CORE,
    OPTION_OPTIMISE,
    OPTION_NO_COST,
    OPTION_KEEP_FACES,
    OPTION_METHOD,
    OPTION_ANTIALIAS,
    OPTION_DELTA,
    OPTION_OVERLAY,
    OPTION_FRAMEBUFFER,
    OPTION_FRAMES,
    OPTION_COST_FRAMES,
    OPTION_SEED,
    OPTION_TRIES,
    OPTION_SECONDS,
    OPTION_WORST,
    OPTION_RESULT
};

enum { COST_FRAMES = 4, FRAMES_MAX = 1000000 };

static const struct option OPTIONS[] = {
    {"out", required_argument, NULL, 'o'},
    {"camera", required_argument, NULL, OPTION_CAMERA},
    {"size", required_argument, NULL, OPTION_SIZE},
    {"precision", required_argument, NULL, OPTION_PRECISION},
    {"sub-bits", no_argument, NULL, OPTION_SUB_BITS},
    {"core", required_argument, NULL, OPTION_CORE},
    {"optimise", required_argument, NULL, OPTION_OPTIMISE},
    {"no-cost", no_argument, NULL, OPTION_NO_COST},
    {"keep-faces", no_argument, NULL, OPTION_KEEP_FACES},
    COMPILE_MODEL_OPTIONS,
    COMPILE_TREE_OPTIONS,
    {"method", required_argument, NULL, OPTION_METHOD},
    {"antialias", no_argument, NULL, OPTION_ANTIALIAS},
    {"delta", no_argument, NULL, OPTION_DELTA},
    {"overlay", no_argument, NULL, OPTION_OVERLAY},
    {"framebuffer", no_argument, NULL, OPTION_FRAMEBUFFER},
    {"frames", required_argument, NULL, OPTION_FRAMES},
    {"cost-frames", required_argument, NULL, OPTION_COST_FRAMES},
    {"seed", required_argument, NULL, OPTION_SEED},
    {"tries", required_argument, NULL, OPTION_TRIES},
    {"seconds", required_argument, NULL, OPTION_SECONDS},
    {"result", required_argument, NULL, OPTION_RESULT},
    {"worst", optional_argument, NULL, OPTION_WORST},
    {NULL, 0, NULL, 0},
};

/* Of one scene, not of several that are compared. */
static bool is_of_one(enum measure_of of)
{
    return of == MEASURE_WORST || of == MEASURE_PAGE;
}

/* Some only make sense for some of them. */
static bool has_option(enum measure_of of, int code)
{
    switch (code) {
    case OPTION_METHOD:
    case COMPILE_TREE:
    case COMPILE_MESH_LEAVES:
    case COMPILE_PORTALS:
        return of != MEASURE_METHODS;
    case OPTION_SUB_BITS:
    case OPTION_RESULT:
    case OPTION_OPTIMISE:
        return of == MEASURE_PRECISIONS;
    case OPTION_FRAMES:
    case OPTION_COST_FRAMES:
        return of == MEASURE_METHODS;
    case OPTION_SEED:
    case OPTION_TRIES:
    case OPTION_SECONDS:
        return is_of_one(of);
    case OPTION_CAMERA:
        return of != MEASURE_WORST;
    case OPTION_NO_COST:
    case OPTION_DELTA:
        return !is_of_one(of);
    default:
        return true;
    }
}

/* Calls `add` for each name of a list. */
static bool parse_list(const char *option, const char *text, struct measure_request *out,
                       bool (*add)(struct measure_request *out, const char *name, struct error *err), struct error *err)
{
    for (;;) {
        char name[32];
        const size_t length = strcspn(text, ",");
        if (length == 0 || length >= sizeof name) return error_set(err, "%s: names, divided by commas", option);
        snprintf(name, sizeof name, "%.*s", (int)length, text);
        if (!add(out, name, err)) return false;
        if (!text[length]) return true;
        text += length + 1;
    }
}

static bool has_core(const struct measure_request *request, const char *name)
{
    for (size_t i = 0; i < request->core_count; i++)
        if (strcmp(request->cores[i]->name, name) == 0) return true;
    for (size_t i = 0; i < request->variant_count; i++)
        if (strcmp(request->variants[i], name) == 0) return true;
    return false;
}

static bool add_core(struct measure_request *out, const char *name, struct error *err)
{
    const struct core *core = core_find(name);
    if (!core && !sub_bits_check_name(name, err)) return false;
    if (has_core(out, name)) return error_set(err, "--precision %s: named twice", name);
    if (out->core_count + out->variant_count == MEASURE_CORES_MAX) return error_set(err, "--precision: too many");
    if (core)
        out->cores[out->core_count++] = core;
    else
        snprintf(out->variants[out->variant_count++], sizeof *out->variants, "%s", name);
    return true;
}

static bool add_cpu(struct measure_request *out, const char *name, struct error *err)
{
    const struct measure_cpu *cpu;
    if (!measure_cpu_parse(name, &cpu, err)) return false;
    for (size_t i = 0; i < out->cpu_count; i++)
        if (out->cpus[i] == cpu) return error_set(err, "--core %s: named twice", name);
    if (out->cpu_count == MEASURE_REQUEST_CPUS_MAX) return error_set(err, "--core: too many");
    out->cpus[out->cpu_count++] = cpu;
    return out->is_cost_asked = true;
}

static bool parse_count(const char *option, const char *text, size_t *out, struct error *err)
{
    double number;
    if (!parse_number(option, text, &number, err)) return false;
    *out = number >= 1.0 && number <= FRAMES_MAX ? (size_t)number : 0;
    return (*out > 0 && (double)*out == number) ||
           error_set(err, "%s %s: how many frames, 1 to %d", option, text, FRAMES_MAX);
}

static bool no_such_option(const char *given, struct error *err)
{
    return error_no_option(err, given);
}

static bool refuse_option(int code, struct error *err)
{
    char given[32];
    size_t i = 0;
    while (OPTIONS[i].val != code)
        i++;
    snprintf(given, sizeof given, "--%s", OPTIONS[i].name);
    return no_such_option(given, err);
}

static bool parse_search(int code, const char *text, struct worst_options *out, struct error *err)
{
    uint32_t tries;
    if (code == OPTION_SEED) return parse_whole("--seed", text, 0, UINT32_MAX, &out->seed, err);
    if (code == OPTION_SECONDS)
        return parse_number("--seconds", text, &out->seconds, err) &&
               ((out->seconds >= 0.0 && isfinite(out->seconds)) ||
                error_set(err, "--seconds %s: how long to search, or 0 for no bound but --tries", text));
    if (!parse_whole("--tries", text, 1, WORST_TRIES_MAX, &tries, err)) return false;
    out->tries = tries;
    return true;
}

/* What an option sets that has no value; NULL: it has one. */
static bool *flag_of(int code, struct measure_request *out, bool *no_cost)
{
    switch (code) {
    case OPTION_SUB_BITS:
        return &out->sub_bits;
    case OPTION_KEEP_FACES:
        return &out->compile.keep_faces;
    case OPTION_ANTIALIAS:
        return &out->compile.antialias;
    case OPTION_DELTA:
        return &out->compile.delta;
    case OPTION_OVERLAY:
        return &out->compile.overlay;
    case OPTION_FRAMEBUFFER:
        return &out->compile.framebuffer;
    case OPTION_NO_COST:
        return no_cost;
    default:
        return NULL;
    }
}

/* One that flag_of() does not know. */
static bool parse_option(int code, char **argv, struct measure_request *out, struct error *err)
{
    if (compile_options_know(code)) return compile_options_take(code, optarg, &out->compile, err);
    switch (code) {
    case 'o':
        out->folder = optarg;
        return *optarg || error_set(err, "-o: needs a %s", is_of_one(out->of) ? "name" : "folder");
    case OPTION_RESULT:
        out->result = optarg;
        return *optarg || error_set(err, "--result: needs a file");
    case OPTION_WORST:
        return worst_tries_parse(optarg, &out->compile.worst_tries, err);
    case OPTION_SEED:
    case OPTION_TRIES:
    case OPTION_SECONDS:
        return parse_search(code, optarg, &out->worst, err);
    case OPTION_CAMERA:
        return camera_choice_parse(optarg, &out->cameras, err);
    case OPTION_SIZE:
        return parse_size(optarg, &out->w_px, &out->h_px, err);
    case OPTION_PRECISION:
        return parse_list("--precision", optarg, out, add_core, err);
    case OPTION_CORE:
        return parse_list("--core", optarg, out, add_cpu, err);
    case OPTION_OPTIMISE:
        out->optimise = optarg;
        out->is_cost_asked = true;
        return measure_optimise_check(optarg, err);
    case OPTION_METHOD:
        return compile_method_parse(optarg, &out->compile, err);
    case OPTION_FRAMES:
        return parse_count("--frames", optarg, &out->frames, err);
    case OPTION_COST_FRAMES:
        return parse_count("--cost-frames", optarg, &out->cost_frames, err);
    case ':':
        return error_set(err, "%s: needs a value", argv[optind - 1]);
    default:
        return no_such_option(argv[optind - 1], err);
    }
}

static bool take_model(int argc, char **argv, struct measure_request *out, struct error *err)
{
    if (optind >= argc) return error_set(err, "%s: needs a model", argv[0]);
    if (optind + 1 < argc) return error_set(err, "%s: one model at a time, what is '%s'?", argv[0], argv[optind + 1]);
    out->model = argv[optind];
    if (level_path_parse(out->model, NULL)) out->cameras.level = out->model;
    if (lim_file_is_named(out->model))
        return error_set(err, "%s: accuracy is measured against the model, not against a compiled scene", out->model);
    level_path_stem(out->model, out->name, sizeof out->name);
    printable(out->name);
    return true;
}

static void add_usual_variants(struct measure_request *out)
{
    struct error ignored;
    for (size_t i = 0; sub_bits_usual[i]; i++)
        if (!has_core(out, sub_bits_usual[i])) (void)add_core(out, sub_bits_usual[i], &ignored);
}

static void fill_in(enum measure_of of, bool no_cost, struct measure_request *out)
{
    const bool is_methods = of == MEASURE_METHODS, is_one = is_of_one(of);
    if ((is_methods || is_one) && !out->core_count) out->cores[out->core_count++] = &core_fast;
    if (!out->core_count && !out->variant_count)
        for (size_t i = 0; cores[i] && i < MEASURE_CORES_MAX; i++)
            out->cores[out->core_count++] = cores[i];
    if (out->sub_bits) add_usual_variants(out);
    if (!out->cpu_count && !no_cost && !is_one)
        for (size_t i = 0; i < measure_cpu_count; i++)
            if (!is_methods || strcmp(measure_cpus[i].name, "m0plus") == 0 || strcmp(measure_cpus[i].name, "m4") == 0)
                out->cpus[out->cpu_count++] = &measure_cpus[i];
    out->compile.w_px = out->w_px;
    out->compile.h_px = out->h_px;
    if (is_methods || is_one) out->compile.core = out->cores[0];
    /* --tries alone is a bound that is the same on every machine. */
    if (out->worst.seconds < 0.0) out->worst.seconds = out->worst.tries ? 0.0 : worst_seconds_unsaid();
    if (!out->worst.tries) out->worst.tries = WORST_TRIES;
}

bool measure_request_parse(int argc, char **argv, enum measure_of of, struct measure_request *out, struct error *err)
{
    bool no_cost = false;
    *out = (struct measure_request){.of = of,
                                    .worst = {.seconds = -1.0},
                                    .w_px = 240,
                                    .h_px = 240,
                                    .compile = compile_options_usual(),
                                    .frames = FRAMES_MAX,
                                    .cost_frames = COST_FRAMES};
    if (of == MEASURE_METHODS) out->compile.portals = PORTALS_OFF; /* one of the methods has them */
    opterr = 0;
    optind = 1;
    for (int code; (code = getopt_long(argc, argv, ":o:", OPTIONS, NULL)) != -1;) {
        bool *const flag = flag_of(code, out, &no_cost);
        if (!has_option(of, code)) return refuse_option(code, err);
        if (flag)
            *flag = true;
        else if (!parse_option(code, argv, out, err))
            return false;
    }
    if (!take_model(argc, argv, out, err)) return false;
    if (no_cost && out->cpu_count) return error_set(err, "%s: --core and --no-cost exclude each other", argv[0]);
    if (no_cost && out->optimise) return error_set(err, "%s: --optimise and --no-cost exclude each other", argv[0]);
    if (of != MEASURE_PRECISIONS && out->core_count > 1)
        return error_set(err, "%s: one --precision at a time", argv[0]);
    if (of != MEASURE_PRECISIONS && out->variant_count)
        return error_set(err, "%s: --precision %s: no such profile", argv[0], out->variants[0]);
    fill_in(of, no_cost, out);
    return compile_options_settle(&out->compile, err);
}

bool measure_request_order(int argc, char **argv, int *words_from, struct error *err)
{
    opterr = 0;
    optind = 1;
    for (int code; (code = getopt_long(argc, argv, ":o:", OPTIONS, NULL)) != -1;) {
        if (code == ':') return error_set(err, "%s: needs a value", argv[optind - 1]);
        if (code == '?') return no_such_option(argv[optind - 1], err);
        if (!has_option(MEASURE_PRECISIONS, code)) return refuse_option(code, err);
    }
    *words_from = optind;
    return true;
}

bool measure_request_load(struct measure_request *request, struct measure_source *source, struct lens *lens,
                          struct camera_path *path, struct error *err)
{
    if (!compile_options_cameras(&request->compile, &request->cameras, path, err)) return false;
    if (!measure_source_read(source, request->model, &request->compile, request->w_px, request->h_px, err))
        return false;
    return lens_for_grid(lens, request->compile.fov_deg, request->compile.near_m, &source->mesh.grid, request->w_px,
                         request->h_px, err);
}

bool measure_request_cameras(const struct measure_request *request, const struct compiled *scene,
                             const struct lens *lens, struct camera_path *path, struct error *err)
{
    struct camera_path few = {0};
    if (request->compile.near_m <= 0.0) lens_note_near(request->model, &scene->grid);
    const bool ok = camera_choice_plan(&request->cameras, scene, lens, MEASURE_ORBIT_FRAMES, path, err) &&
                    camera_path_few(path, request->frames, &few, err);
    camera_path_free(path);
    *path = few;
    return ok;
}

bool measure_request_check(const struct measure_request *request, struct error *err)
{
    for (size_t i = 0; i < request->cpu_count; i++)
        if (!measure_cpu_check(request->cpus[i], err)) return false;
    if (request->variant_count && !sub_bits_check_tools(err)) return false;
    const bool plots = request->folder && request->cpu_count && !request->no_plot && !is_of_one(request->of);
    if (!plots || child_exists("gnuplot")) return true;
    return error_set(err, "gnuplot: not found; the plot needs Debian's package gnuplot-nox (or leave out -o)");
}

bool measure_request_load_variants(struct measure_request *request, const char *folder, struct error *err)
{
    for (size_t i = 0; i < request->variant_count; i++) {
        progress_bar(i, request->variant_count, "compiling %s", request->variants[i]);
        if (!sub_bits_load(request->variants[i], folder, &request->cores[request->core_count], err)) return false;
        request->core_count++;
    }
    request->variant_count = 0;
    return true;
}
