/* SPDX-License-Identifier: MIT
 *
 * Options are checked here for their form and range; what depends on the scene (lens, camera) where it is known. */
#include "cli/options.h"

#include "base/grow.h"
#include "base/parse.h"
#include "compiler/compile.h"
#include "compiler/order_choice.h"
#include "core/core.h"
#include "core/core_parse.h"
#include "displays/module_choice.h"
#include "levels/level_path.h"
#include "outputs/outputs.h"
#include "render/caption.h"
#include "scene/scene_files.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { ORBIT_FRAMES = 16, UNSAID_SIZE_PX = 240, MOST_RUNS = 60000, MOST_FRAMES = 100000 };

enum option_code {
    OPTION_OUT = 'o',
    OPTION_GIF = 256,
    OPTION_SHEET,
    OPTION_IDS,
    OPTION_STATS,
    OPTION_BRIEF,
    OPTION_COMPARE,
    OPTION_CHECK,
    OPTION_WRITE_HASHES,
    OPTION_WRITE_CAMERAS,
    OPTION_CAMERA,
    OPTION_SIZE,
    OPTION_PANEL,
    OPTION_ROTATE,
    OPTION_METHOD,
    OPTION_TOLERANCE,
    OPTION_BACKGROUND,
    OPTION_WIREFRAME,
    OPTION_ANTIALIAS,
    OPTION_DELTA,
    OPTION_OVERLAY,
    OPTION_PRECISION,
    OPTION_NEWELL,
    OPTION_MOVERS,
    OPTION_MOVER_LIGHT,
    OPTION_FPS,
    OPTION_FRAMES,
    OPTION_RAM
};

/* Those that only `render` has come first. */
enum { RENDER_ONLY_OPTIONS = 16 };
static const struct option OPTIONS[] = {
    {"gif", required_argument, NULL, OPTION_GIF},
    {"sheet", required_argument, NULL, OPTION_SHEET},
    {"ids", required_argument, NULL, OPTION_IDS},
    {"stats", no_argument, NULL, OPTION_STATS},
    {"brief", no_argument, NULL, OPTION_BRIEF},
    {"compare", no_argument, NULL, OPTION_COMPARE},
    {"check", required_argument, NULL, OPTION_CHECK},
    {"write-hashes", required_argument, NULL, OPTION_WRITE_HASHES},
    {"write-cameras", required_argument, NULL, OPTION_WRITE_CAMERAS},
    {"newell", required_argument, NULL, OPTION_NEWELL},
    {"movers", required_argument, NULL, OPTION_MOVERS},
    {"mover-light", required_argument, NULL, OPTION_MOVER_LIGHT},
    {"overlay", required_argument, NULL, OPTION_OVERLAY},
    {"fps", required_argument, NULL, OPTION_FPS},
    {"frames", required_argument, NULL, OPTION_FRAMES},
    {"ram", required_argument, NULL, OPTION_RAM},
    {"camera", required_argument, NULL, OPTION_CAMERA},
    {"size", required_argument, NULL, OPTION_SIZE},
    {"panel", required_argument, NULL, OPTION_PANEL},
    {"rotate", required_argument, NULL, OPTION_ROTATE},
    {"method", required_argument, NULL, OPTION_METHOD},
    {"precision", required_argument, NULL, OPTION_PRECISION},
    {"tolerance", required_argument, NULL, OPTION_TOLERANCE},
    {"background", required_argument, NULL, OPTION_BACKGROUND},
    COMPILE_MODEL_OPTIONS,
    COMPILE_TREE_OPTIONS,
    {"wireframe", optional_argument, NULL, OPTION_WIREFRAME},
    {"antialias", no_argument, NULL, OPTION_ANTIALIAS},
    {"delta", optional_argument, NULL, OPTION_DELTA},
    {NULL, 0, NULL, 0},
};

static bool parse_panel(const char *text, struct options *out, struct error *err)
{
    out->setup.panel = strcmp(text, "memory") == 0        ? SIMULATOR_MEMORY
                       : strcmp(text, "framebuffer") == 0 ? SIMULATOR_FRAMEBUFFER
                                                          : SIMULATOR_PANEL;
    return out->setup.panel != SIMULATOR_PANEL || panel_choice_parse(text, "memory, and framebuffer", &out->panel, err);
}

static bool parse_method(const char *text, struct options *out, struct error *err)
{
    if (!compile_method_parse(text, &out->compile, err)) return false;
    out->setup.method = out->compile.method->draws;
    return true;
}

/* most=N, N above 0. */
static bool parse_most(const char *text, size_t length, uint32_t *out)
{
    uint32_t value = 0;

    if (length < 6 || length > 13 || strncmp(text, "most=", 5) != 0) return false;
    for (size_t i = 5; i < length; i++) {
        if (text[i] < '0' || text[i] > '9') return false;
        value = 10 * value + (uint32_t)(text[i] - '0');
    }
    *out = value;
    return value > 0;
}

/* Names, divided by commas. */
static bool parse_newell(const char *text, struct lim_newell_options *out, struct error *err)
{
    while (*text) {
        const size_t length = strcspn(text, ",");
        if (length == 6 && strncmp(text, "planes", length) == 0)
            out->planes_first = true;
        else if (length == 3 && strncmp(text, "one", length) == 0)
            out->split_one = true;
        else if (!parse_most(text, length, &out->most))
            return error_set(err, "--newell %.*s: no such choice; there are planes, one and most=COMPARISONS",
                             (int)length, text);
        text += length + (text[length] == ',');
    }
    return true;
}

static bool parse_fps(const char *text, struct options *out, struct error *err)
{
    const double *rate = &out->frames_per_s;
    out->has_rate = true;
    if (!parse_number("--fps", text, &out->frames_per_s, err)) return false;
    return (*rate > 0.0 && *rate <= 1000.0) || error_set(err, "--fps %s: above 0, and at most 1000", text);
}

static bool parse_frames(const char *text, size_t *out, struct error *err)
{
    uint32_t frames = 0;
    if (!parse_whole("--frames", text, 1, MOST_FRAMES, &frames, err)) return false;
    *out = frames;
    return true;
}

/* Nothing: as many as there may be. */
static bool parse_runs(const char *text, uint16_t *out, struct error *err)
{
    uint32_t runs = MOST_RUNS;
    if (text && !parse_whole("--delta", text, 1, MOST_RUNS, &runs, err)) return false;
    *out = (uint16_t)runs;
    return true;
}

/* What an option without a value sets. */
static bool *flag_of(int code, struct options *out)
{
    switch (code) {
    case OPTION_ANTIALIAS:
        return &out->compile.antialias;
    case OPTION_STATS:
        return &out->stats;
    case OPTION_BRIEF:
        return &out->brief;
    case OPTION_COMPARE:
        return &out->compare;
    default:
        return NULL;
    }
}

/* Where an option's value is kept as it is. */
static const char **text_of(int code, struct options *out)
{
    switch (code) {
    case OPTION_GIF:
        return &out->gif_path;
    case OPTION_SHEET:
        return &out->sheet_path;
    case OPTION_IDS:
        return &out->ids_path;
    case OPTION_CHECK:
        return &out->check_path;
    case OPTION_WRITE_HASHES:
        return &out->hashes_path;
    case OPTION_WRITE_CAMERAS:
        return &out->cameras_path;
    default:
        return NULL;
    }
}

/* One GIF is all frames. */
static bool parse_out(const char *text, struct options *out, struct error *err)
{
    const char *suffix = strrchr(text, '.');
    if (suffix && strcasecmp(suffix, ".gif") == 0 && output_is_one(text)) {
        out->gif_path = text;
        return true;
    }
    out->frame_pattern = text;
    return parse_picture_path("-o", text, ".png", err) && (output_is_one(text) || output_pattern_check(text, err));
}

static bool parse_option(int code, const char *text, struct options *out, struct error *err)
{
    bool *const flag = flag_of(code, out);
    const char **const kept = text_of(code, out);
    if (flag) return *flag = true;
    if (compile_options_know(code)) return compile_options_take(code, text, &out->compile, err);
    if (kept) {
        *kept = text;
        return (code != OPTION_GIF || parse_picture_path("--gif", text, ".gif", err)) &&
               (code != OPTION_SHEET || parse_picture_path("--sheet", text, ".png", err));
    }
    switch (code) {
    case OPTION_CAMERA:
        return camera_choice_parse(text, &out->cameras, err);
    case OPTION_SIZE:
        return parse_size(text, &out->setup.w_px, &out->setup.h_px, err);
    case OPTION_PANEL:
        return parse_panel(text, out, err);
    case OPTION_ROTATE:
        return panel_rotation_parse(text, &out->rotation, err);
    case OPTION_METHOD:
        return parse_method(text, out, err);
    case OPTION_NEWELL:
        return parse_newell(text, &out->newell, err);
    case OPTION_MOVERS:
        return moving_mode_parse(text, &out->movers.mode, err);
    case OPTION_MOVER_LIGHT:
        return moving_light_parse(text, &out->movers.light, err);
    case OPTION_FPS:
        return parse_fps(text, out, err);
    case OPTION_RAM:
        return parse_ram(text, &out->ram.bytes, &out->ram.percent, err);
    case OPTION_FRAMES:
        return parse_frames(text, &out->frames, err);
    case OPTION_PRECISION:
        return parse_precision(text, &out->setup.core, err);
    case OPTION_BACKGROUND:
        return parse_background(text, &out->compile.background, err);
    case OPTION_WIREFRAME:
        out->compile.wireframe = true;
        return parse_wireframe(text, &out->wireframe, err);
    case OPTION_DELTA:
        out->compile.delta = true;
        return parse_runs(text, &out->delta_runs, err);
    case OPTION_OVERLAY:
        out->compile.overlay = true;
        out->overlay_text = text;
        return caption_check(text, err);
    case OPTION_TOLERANCE:
        return parse_tolerance(text, &out->compile.tolerance_units, err);
    case OPTION_OUT:
        return parse_out(text, out, err);
    default:
        return false;
    }
}

static bool unusable_option(int code, char **argv, struct error *err)
{
    const char *given = argv[optind - 1];
    if (code == ':') return error_set(err, "%s: needs a value", given);
    return error_no_option(err, given);
}

static enum option_files files_of(int code, const char *value)
{
    struct camera_choice cameras;
    struct error ignored;
    switch (code) {
    case OPTION_CAMERA:
        return camera_choice_parse(value, &cameras, &ignored) && cameras.random_count ? OPTION_NAMES_NONE
                                                                                      : OPTION_READS_CAMERAS;
    case COMPILE_PATH:
        return OPTION_READS_CAMERAS;
    case OPTION_OUT:
    case OPTION_GIF:
    case OPTION_SHEET:
    case OPTION_IDS:
    case OPTION_CHECK:
    case OPTION_WRITE_HASHES:
    case OPTION_WRITE_CAMERAS:
        return OPTION_NAMES_FILE;
    default:
        return OPTION_NAMES_NONE;
    }
}

bool options_split(int argc, char **argv, struct given_option **given, size_t *count, const char **scene,
                   struct error *err)
{
    *given = grow_zeroed((size_t)argc, sizeof **given);
    *count = 0;
    opterr = 0;
    optind = 1;
    int code, index = -1;
    while ((code = getopt_long(argc, argv, ":o:", OPTIONS, &index)) != -1) {
        if (code == ':' || code == '?') return unusable_option(code, argv, err);
        (*given)[(*count)++] =
            (struct given_option){code == OPTION_OUT ? "o" : OPTIONS[index].name, optarg, files_of(code, optarg)};
    }
    *scene = argv[optind];
    return optind + 1 >= argc || error_set(err, "one scene at a time, what is '%s'?", argv[optind + 1]);
}

/* One file of an orbit is its first frame. */
static bool settle_frames(struct options *options, struct error *err)
{
    if (options_one_file(options) && !options->frames && !options->cameras.text) options->frames = 1;
    if (options->cameras.random_count > 0 && options->frames) options->cameras.random_count = options->frames;
    const size_t count = options->frames ? options->frames : options->cameras.random_count;
    if (!options_one_file(options) || count <= 1) return true;
    return error_set(err, "-o '%s': one file for %zu frames; %%d numbers them, as in 'out/%%03d.png'",
                     options->frame_pattern, count);
}

static void settle_glass(struct options *options)
{
    struct simulator_setup *setup = &options->setup;
    if (setup->w_px) return;
    setup->w_px = setup->h_px = UNSAID_SIZE_PX;
    if (setup->panel == SIMULATOR_PANEL) module_usual_size(&options->panel, &setup->w_px, &setup->h_px);
}

/* Without --size a panel has its usual glass. A picture that is turned by a quarter has the glass's sides exchanged. */
static void settle_size(struct options *options)
{
    struct simulator_setup *setup = &options->setup;
    settle_glass(options);
    options->panel.rotation = options->rotation;
    if (!panel_rotation_exchanges(options->rotation)) return;
    const unsigned w_px = setup->w_px;
    setup->w_px = setup->h_px;
    setup->h_px = w_px;
}

/* A panel is emulated wherever its memory holds the picture. */
static bool choose_panel(struct options *out, struct error *err)
{
    struct error reason;
    const bool holds = simulator_panel_holds(&out->panel, out->setup.w_px, out->setup.h_px, &reason);
    if (out->setup.panel == SIMULATOR_PANEL && !holds) return error_set(err, "%s", reason.text);
    if (out->setup.panel == SIMULATOR_ANY) out->setup.panel = holds ? SIMULATOR_PANEL : SIMULATOR_MEMORY;
    return true;
}

void options_settle_panel(struct options *options, const struct panel_choice *panel)
{
    options->compile.mono = panel_choice_is_mono(panel);
    if (options->wireframe.on && !options->wireframe.one_colour) options->wireframe = panel_choice_outlines(panel);
}

static bool asks_for_output(const struct options *options)
{
    return options->frame_pattern || options->gif_path || options->sheet_path || options->ids_path ||
           options->check_path || options->hashes_path || options->cameras_path || options->stats || options->compare;
}

/* Whether a method draws all that is asked for. */
static bool draws_what_is_asked(enum lim_method draws, const struct options *options, const struct lim_scene *scene)
{
    const struct compile_options *compile = &options->compile;
    struct error ignored;
    return (!options->wireframe.on || method_draws_wireframe(draws, &ignored)) &&
           (!compile->antialias || method_antialiases(draws, options->wireframe.on, &ignored)) &&
           method_scans(draws, order_needs_nearest(compile, scene), &ignored);
}

/* A file is drawn by the method that it is for, unless another is named, or what that method does not draw is asked
 * for. What cannot be read, or not be drawn, is refused where it is loaded. */
static void settle_file(struct options *out)
{
    struct compile_options *compile = &out->compile;
    struct compiled scene;
    struct error ignored;
    if (compile->method || compile->tree != TREE_AUTO || !options_scene_is_compiled(out)) return;
    if (!lim_file_read(out->scene_path, &scene, &ignored)) return;
    if (draws_what_is_asked(scene.report.draws, out, &scene.scene)) compile->method = method_that(scene.report.draws);
    compiled_free(&scene);
}

bool options_parse(int argc, char **argv, enum options_set set, struct options *out, struct error *err)
{
    const bool is_render = set == OPTIONS_RENDER;
    *out = (struct options){.setup = {0, 0, LIM_NEAREST_FIRST, SIMULATOR_ANY, &core_fast},
                            .orbit_frames = ORBIT_FRAMES,
                            .frames_per_s = 15.0,
                            .compile = compile_options_usual()};
    opterr = 0;
    optind = 1;
    const struct option *known = OPTIONS + (is_render ? 0 : RENDER_ONLY_OPTIONS);
    int code, index = 0;
    while ((code = getopt_long(argc, argv, is_render ? ":o:" : ":", known, &index)) != -1) {
        if (code == ':' || code == '?') return unusable_option(code, argv, err);
        if (!parse_option(code, optarg, out, err)) return false;
        if (code != OPTION_OUT && code != OPTION_FPS) idle_options_add(&out->idle, known[index].name);
    }
    if (optind >= argc) return error_set(err, "%s: needs a model or a .lim file", argv[0]);
    if (optind + 1 < argc) return error_set(err, "%s: one scene at a time, what is '%s'?", argv[0], argv[optind + 1]);
    out->scene_path = argv[optind];
    out->cameras.takes_times = is_render;
    if (level_path_parse(out->scene_path, NULL)) out->cameras.level = out->scene_path;
    if (is_render && !asks_for_output(out)) out->frame_pattern = "out/%03d.png";
    settle_file(out);
    if (!compile_options_settle(&out->compile, err)) return false;
    out->setup.method = compile_options_draws(&out->compile);
    if (out->setup.method != LIM_NEWELL && (out->newell.planes_first || out->newell.split_one || out->newell.most))
        return error_set(err, "--newell: goes with --method newell");
    if (out->wireframe.on && !method_draws_wireframe(out->setup.method, err)) return false;
    if (out->compile.antialias && !method_antialiases(out->setup.method, out->wireframe.on, err)) return false;
    if (out->delta_runs && !method_scans(out->setup.method, "--delta is", err)) return false;
    settle_size(out);
    if (out->setup.panel == SIMULATOR_PANEL) options_settle_panel(out, &out->panel);
    if (!settle_frames(out, err)) return false;
    if (out->has_rate && !out->gif_path) idle_options_add(&out->idle, "fps");
    out->compile.keep_faces = out->ids_path != NULL;
    out->compile.framebuffer = out->compile.framebuffer_by_lines = out->setup.panel == SIMULATOR_FRAMEBUFFER;
    out->compile.w_px = out->setup.w_px;
    out->compile.h_px = out->setup.h_px;
    out->compile.core = out->setup.core;
    return choose_panel(out, err);
}
