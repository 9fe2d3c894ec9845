/* SPDX-License-Identifier: MIT */
#include "cli/compile_request.h"

#include "base/grow.h"
#include "base/notice.h"
#include "base/parse.h"
#include "cli/options.h"
#include "compiler/compile.h"
#include "core/core_parse.h"
#include "levels/level_path.h"
#include "measure/worst_views.h"
#include "scene/mem_parts.h"
#include "scene/moving.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

enum { UNSAID_SIZE_PX = 240 };

enum option_code {
    OPTION_TOLERANCE = 256,
    OPTION_METHOD,
    OPTION_KEEP_FACES,
    OPTION_BACKGROUND,
    OPTION_WIREFRAME,
    OPTION_ANTIALIAS,
    OPTION_DELTA,
    OPTION_ROUND,
    OPTION_FILL,
    OPTION_FRAMEBUFFER,
    OPTION_SIZE,
    OPTION_PANEL,
    OPTION_PRECISION,
    OPTION_MAX_ERROR,
    OPTION_MAX_VERTEX_ERROR,
    OPTION_CAMERA,
    OPTION_CORE,
    OPTION_MOVERS,
    OPTION_MOVER_LIGHT,
    OPTION_REPORT,
    OPTION_OVERLAY,
    OPTION_WORST
};

static const struct option OPTIONS[] = {
    {"tolerance", required_argument, NULL, OPTION_TOLERANCE},
    {"method", required_argument, NULL, OPTION_METHOD},
    {"keep-faces", no_argument, NULL, OPTION_KEEP_FACES},
    {"background", required_argument, NULL, OPTION_BACKGROUND},
    COMPILE_MODEL_OPTIONS,
    COMPILE_TREE_OPTIONS,
    {"wireframe", no_argument, NULL, OPTION_WIREFRAME},
    {"antialias", no_argument, NULL, OPTION_ANTIALIAS},
    {"delta", no_argument, NULL, OPTION_DELTA},
    {"overlay", no_argument, NULL, OPTION_OVERLAY},
    {"round", no_argument, NULL, OPTION_ROUND},
    {"fill", no_argument, NULL, OPTION_FILL},
    {"framebuffer", no_argument, NULL, OPTION_FRAMEBUFFER},
    {"precision", required_argument, NULL, OPTION_PRECISION},
    {"max-error", required_argument, NULL, OPTION_MAX_ERROR},
    {"max-vertex-error", required_argument, NULL, OPTION_MAX_VERTEX_ERROR},
    {"camera", required_argument, NULL, OPTION_CAMERA},
    {"core", required_argument, NULL, OPTION_CORE},
    {"size", required_argument, NULL, OPTION_SIZE},
    {"panel", required_argument, NULL, OPTION_PANEL},
    {"mover-light", required_argument, NULL, OPTION_MOVER_LIGHT},
    {"movers", required_argument, NULL, OPTION_MOVERS},
    {"worst", optional_argument, NULL, OPTION_WORST},
    {"report", no_argument, NULL, OPTION_REPORT},
    {NULL, 0, NULL, 0},
};

static bool has_bound(const struct compile_request *request)
{
    return request->bound.wrong_percent >= 0.0 || request->bound.vertex_px >= 0.0;
}

/* What an option without a value sets. */
static bool *flag_of(int code, struct compile_request *out)
{
    switch (code) {
    case OPTION_KEEP_FACES:
        return &out->compile.keep_faces;
    case OPTION_WIREFRAME:
        return &out->compile.wireframe;
    case OPTION_ANTIALIAS:
        return &out->compile.antialias;
    case OPTION_DELTA:
        return &out->compile.delta;
    case OPTION_OVERLAY:
        return &out->compile.overlay;
    case OPTION_ROUND:
        return &out->compile.round;
    case OPTION_FILL:
        return &out->compile.fill;
    case OPTION_FRAMEBUFFER:
        return &out->compile.framebuffer;
    case OPTION_REPORT:
        return &out->report;
    default:
        return NULL;
    }
}

/* Before it is told: what it is called then. */
static void map_name(char *name)
{
    char *given = strdup(name);
    if (c_name_map(name) && given) notice("%s: files are called %s: C cannot name the other", given, name);
    free(given);
}

static bool take_name(char *name, struct compile_request *out, struct error *err)
{
    out->name = name;
    if (!*name) return error_set(err, "-o: needs a name");
    map_name(name);
    return true;
}

static bool parse_option(int code, char **argv, struct compile_request *out, struct error *err)
{
    bool *const flag = flag_of(code, out);
    if (flag) return *flag = true;
    if (compile_options_know(code)) return compile_options_take(code, optarg, &out->compile, err);
    switch (code) {
    case 'o':
        return take_name(optarg, out, err);
    case OPTION_TOLERANCE:
        return parse_tolerance(optarg, &out->compile.tolerance_units, err);
    case OPTION_METHOD:
        return compile_method_parse(optarg, &out->compile, err);
    case OPTION_BACKGROUND:
        return parse_background(optarg, &out->compile.background, err);
    case OPTION_PRECISION:
        return parse_precision(optarg, &out->compile.core, err);
    case OPTION_SIZE:
        return parse_size(optarg, &out->compile.w_px, &out->compile.h_px, err);
    case OPTION_PANEL:
        return panel_choice_parse(optarg, NULL, &out->panel, err);
    case OPTION_MAX_ERROR:
        return parse_bound("--max-error", optarg, "%", &out->bound.wrong_percent, err);
    case OPTION_MAX_VERTEX_ERROR:
        return parse_bound("--max-vertex-error", optarg, "px", &out->bound.vertex_px, err);
    case OPTION_CAMERA:
        return camera_choice_parse(optarg, &out->bound.cameras, err);
    case OPTION_CORE:
        return measure_cpu_parse(optarg, &out->bound.cpu, err);
    case OPTION_WORST:
        return worst_tries_parse(optarg, &out->compile.worst_tries, err);
    case OPTION_MOVERS:
        return moving_mode_parse(optarg, &out->movers.mode, err);
    case OPTION_MOVER_LIGHT:
        return moving_light_parse(optarg, &out->movers.light, err);
    case ':':
        return error_set(err, "%s: needs a value", argv[optind - 1]);
    default:
        return error_no_option(err, argv[optind - 1]);
    }
}

static bool check_bound(const struct compile_request *request, struct error *err)
{
    if (!has_bound(request))
        return (!request->bound.cameras.text && !request->bound.cpu) ||
               error_set(err, "%s: --camera and --core go with --max-error or --max-vertex-error", request->command);
    if (request->compile.core)
        return error_set(err, "%s: --precision leaves --max-error nothing to choose", request->command);
    return request->model_count == 1 || error_set(err, "%s: --max-error takes one model at a time", request->command);
}

/* What the panel says that nothing else has said. */
static void settle_panel(struct compile_request *request)
{
    struct compile_options *compile = &request->compile;
    const bool has_panel = request->panel.family != NULL, has_size = compile->w_px > 0;
    if (has_panel) compile->mono = panel_choice_is_mono(&request->panel);
    if (has_size) return;
    compile->w_px = compile->h_px = UNSAID_SIZE_PX;
    if (has_panel) module_usual_size(&request->panel, &compile->w_px, &compile->h_px);
}

bool compile_request_parse(int argc, char **argv, struct compile_request *out, struct error *err)
{
    *out = (struct compile_request){.command = argv[0], .compile = compile_options_usual()};
    out->compile.predict = true;
    out->bound = (struct choice_bound){.wrong_percent = -1.0, .vertex_px = -1.0};
    opterr = 0;
    optind = 1;
    for (int code, index = 0; (code = getopt_long(argc, argv, ":o:", OPTIONS, &index)) != -1;) {
        if (!parse_option(code, argv, out, err)) return false;
        if (code != 'o') idle_options_add(&out->idle, OPTIONS[index].name);
    }
    if (optind >= argc) return error_set(err, "%s: needs a model", out->command);
    out->models = &argv[optind];
    out->model_count = (size_t)(argc - optind);
    settle_panel(out);
    return check_bound(out, err) && compile_options_settle(&out->compile, err);
}

/* NAME for a single model; NAME_hall for house/hall.obj and NAME_E1M1 for doom.wad:E1M1 where there are others. */
static bool name_scene(const struct compile_request *request, size_t i, char name[C_PATH_MAX_B], struct error *err)
{
    if (request->model_count == 1) return c_path(name, request->name, "", err);
    char suffix[C_NAME_MAX_B] = "_";
    if (level_path_stem(request->models[i], suffix + 1, sizeof suffix - 1) >= C_NAME_MAX_B - 1)
        return error_set(err, "%s: the name is too long for C symbols", request->models[i]);
    if (!c_path(name, request->name, suffix, err)) return false;
    if (request->has_lim) map_name(name);
    return true;
}

static bool names_differ(const struct compile_result *result, size_t i, const char *model, struct error *err)
{
    struct c_name mine, other;
    if (!c_name_init(&mine, result->names[i], err)) return false;
    for (size_t k = 0; k < i; k++) {
        if (!c_name_init(&other, result->names[k], err)) return false;
        if (strcmp(mine.macro, other.macro) == 0)
            return error_set(err, "%s: a scene of that name is there already", model);
    }
    return true;
}

/* The scene's header includes these two by name. */
static bool header_differs(const char *path, struct error *err)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    return (strcmp(name, "config") != 0 && strcmp(name, "limner") != 0) ||
           error_set(err, "-o '%s': the renderer has a header of that name; another one helps", path);
}

/* Names first: what cannot be written is not worth compiling. */
static bool name_all(const struct compile_request *request, struct compile_result *result, struct error *err)
{
    if (request->has_lim && !header_differs(request->name, err)) return false;
    for (size_t i = 0; i < request->model_count; i++)
        if (!name_scene(request, i, result->names[i], err) || !names_differ(result, i, request->models[i], err))
            return false;
    return true;
}

static bool compile_all(const struct compile_request *request, struct compile_result *result, struct error *err)
{
    for (size_t i = 0; i < request->model_count; i++) {
        struct moving *moving = &result->moving[i];
        result->count++;
        if (!moving_compile(request->models[i], &request->compile, &request->movers, &result->scenes[i], moving, err))
            return false;
        model_tell(request->models[i], &moving->model);
        if (moving->count && !method_moves(result->scenes[i].report.draws, err)) return false;
        if (request->compile.near_m <= 0.0) lens_note_near(request->models[i], &result->scenes[i].grid);
        result->named[i] =
            (struct named_scene){&result->scenes[i], result->names[i], moving->count ? moving : NULL, NULL};
    }
    return true;
}

/* What moves one model may do nothing to another. */
static void note_idle(const struct compile_request *request, const struct compile_result *result)
{
    size_t moving = 0, stopped = 0;
    for (size_t i = 0; i < result->count; i++) {
        moving += result->moving[i].count;
        stopped += result->moving[i].stopped;
    }
    idle_options_note_scene(&request->idle,
                            &(struct idle_scene){.name = result->count == 1 ? request->models[0] : "these models",
                                                 .is_set = request->compile.tree == TREE_NONE,
                                                 .is_mesh = request->compile.tree == TREE_MESH,
                                                 .is_still = !moving,
                                                 .is_unlit = request->compile.unlit,
                                                 .was_still = !moving && !stopped});
}

static void print_summaries(const struct compile_request *request, const struct compile_result *result)
{
    for (size_t i = 0; i < result->count; i++)
        compile_summary_print(&result->scenes[i], &result->moving[i],
                              request->name ? result->names[i] : request->models[i]);
}

static void print_reports(const struct compile_request *request, const struct compile_result *result)
{
    for (size_t i = 0; i < result->count; i++) {
        const struct compiled *scene = &result->scenes[i];
        compile_report_print(scene, request->name ? result->names[i] : request->models[i]);
        if (result->moving[i].count)
            moving_report_print(&result->moving[i], scene, request->has_lim ? result->names[i] : NULL);
    }
}

static double seconds(struct timeval time)
{
    return (double)time.tv_sec + 1e-6 * (double)time.tv_usec;
}

/* What the program took, its children included: imports are theirs. */
static void print_effort(void)
{
    struct rusage own, children;
    if (getrusage(RUSAGE_SELF, &own) != 0 || getrusage(RUSAGE_CHILDREN, &children) != 0) return;
    const long most_kb = own.ru_maxrss > children.ru_maxrss ? own.ru_maxrss : children.ru_maxrss;
    printf("%-30s %8ld MB\n", "memory for compiling, at most", most_kb / 1024);
    printf("%-30s %8.1f s\n", "processor time for compiling",
           seconds(own.ru_utime) + seconds(own.ru_stime) + seconds(children.ru_utime) + seconds(children.ru_stime));
}

static bool has_budget(void)
{
    const struct model_options *given = model_options_given();
    for (size_t i = 0; i < given->count; i++)
        if (strcmp(given->items[i].name, "texture-budget") == 0) return true;
    return false;
}

/* Who has given textures a budget knows what they take. */
static void note_textures(const struct compile_request *request, const struct compile_result *result)
{
    size_t textures_b = 0, flash_b = 0;
    for (size_t i = 0; i < result->count; i++) {
        textures_b += texture_memory_b(&result->scenes[i].scene);
        flash_b += result->scenes[i].report.flash_b;
    }
    if (2 * textures_b <= flash_b || has_budget()) return;
    notice("%s: textures take %zu of the scene's %zu bytes of flash: --textures flat spares these %zu, by one colour a "
           "face; "
           "--texture-budget KB makes them smaller",
           result->count == 1 ? request->models[0] : "these models", textures_b, flash_b, textures_b);
}

void compile_result_report(const struct compile_request *request, const struct compile_result *result)
{
    note_idle(request, result);
    note_textures(request, result);
    if (!request->report) {
        print_summaries(request, result);
        return;
    }
    print_reports(request, result);
    print_effort();
}

static bool choose_among_cores(struct compile_request *request, struct error *err)
{
    struct choice choice;
    const bool ok = choose_core(request->models[0], &request->compile, &request->bound, &choice, err);
    if (choice.frames) choice_print(&choice, &request->bound, stdout);
    fflush(stdout); /* the import forks */
    request->compile.core = choice.core;
    return ok;
}

/* The precision that the bound asks for, and more bits where none will do; evidence goes to standard output. */
static bool choose(struct compile_request *request, struct error *err)
{
    if (!has_bound(request)) return true;
    request->compile.wrong_percent = fmax(request->bound.wrong_percent, 0.0);
    if (choose_among_cores(request, err)) return true;
    if (request->compile.coordinates != COORDINATES_AUTO) return false;
    struct error ignored;
    request->compile.coordinates = COORDINATES_32;
    if (choose_among_cores(request, &ignored)) {
        notice("%s: coordinates have 32 bits: with 16 no precision errs as little", request->models[0]);
        return true;
    }
    request->compile.coordinates = COORDINATES_AUTO;
    return false;
}

bool compile_request_run(struct compile_request *request, struct compile_result *out, struct error *err)
{
    const size_t count = request->model_count;
    *out = (struct compile_result){grow_zeroed(count, sizeof *out->scenes), grow_zeroed(count, sizeof *out->moving),
                                   grow_zeroed(count, sizeof *out->named), grow_zeroed(count, sizeof *out->names), 0};
    return (!request->name || name_all(request, out, err)) && choose(request, err) && compile_all(request, out, err);
}

void compile_result_free(struct compile_result *result)
{
    for (size_t i = 0; i < result->count; i++) {
        compiled_free(&result->scenes[i]);
        moving_free(&result->moving[i]);
    }
    free(result->moving);
    free(result->scenes);
    free(result->named);
    free(result->names);
}
