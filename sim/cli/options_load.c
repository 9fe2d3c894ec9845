/* SPDX-License-Identifier: MIT
 *
 * From options to a scene and its cameras. */
#include "base/notice.h"
#include "cameras/facing.h"
#include "cli/options.h"
#include "compiler/order_choice.h"
#include "outputs/outputs.h"
#include "scene/scene_files.h"

#include <math.h>
#include <stdio.h>

enum { MOST_LOOP_FRAMES = 600 };

bool options_one_file(const struct options *options)
{
    return options->frame_pattern && output_is_one(options->frame_pattern);
}

/* A file's cameras: the first ones, if fewer are wanted. */
static bool take_frames(const struct options *options, struct camera_path *path, struct error *err)
{
    if (options->frames > path->count)
        return error_set(err, "--frames %zu: %s has %zu", options->frames, options->cameras.text, path->count);
    if (options->frames) path->count = options->frames;
    return !options_one_file(options) || path->count == 1 ||
           error_set(err, "-o '%s': one file for the %zu frames of %s; --frames 1 is the first, or %%d numbers them",
                     options->frame_pattern, path->count, options->cameras.text);
}

bool options_scene_is_compiled(const struct options *options)
{
    return lim_file_is_named(options->scene_path);
}

static bool load_scene(const struct options *options, struct compiled *scene, struct moving *moving, struct error *err)
{
    if (options_scene_is_compiled(options)) {
        const bool any_does = method_needs_no_tree(options->setup.method) || options->compile.portals == PORTALS_ON;
        if (options->compile.tree != TREE_AUTO && !any_does)
            return error_set(err, "%s: has its tree already; give the model for another one", options->scene_path);
        return lim_file_read(options->scene_path, scene, err) &&
               method_suits(options->setup.method, options->scene_path, &scene->scene, err) &&
               method_scans(options->setup.method, order_needs_nearest(&options->compile, &scene->scene), err) &&
               (options->compile.portals != PORTALS_ON || scene->scene.place_count ||
                error_set(err, "%s: --method portals needs a scene compiled with --portals on", options->scene_path));
    }
    if (!moving) return compile_model(options->scene_path, &options->compile, scene, err);
    if (!moving_compile(options->scene_path, &options->compile, &options->movers, scene, moving, err)) return false;
    model_tell(options->scene_path, &moving->model);
    return true;
}

void options_note_stopped(const struct options *options, const struct moving *moving)
{
    if (moving->stopped)
        notice("%s: objects stand still; methods nearest, scanline and bsp move them", options->scene_path);
}

/* Who hands over no *moving has taken no options of movers. */
static void note_idle(const struct options *options, const struct moving *moving)
{
    const bool is_still = moving && !moving->count;
    idle_options_note_scene(&options->idle, &(struct idle_scene){.name = options->scene_path,
                                                                 .is_compiled = options_scene_is_compiled(options),
                                                                 .is_set = options->compile.tree == TREE_NONE,
                                                                 .is_mesh = options->compile.tree == TREE_MESH,
                                                                 .is_still = is_still,
                                                                 .is_unlit = options->compile.unlit,
                                                                 .has_background = options->wireframe.one_colour,
                                                                 .was_still = is_still && !moving->stopped});
}

bool options_loop(const struct options *options, const struct moving *moving)
{
    return moving && moving->count && !options->cameras.text && !(options->frames && options->has_rate);
}

/* A short animation is shown as often as makes an orbit of it. */
static double loop_length_s(const struct options *options, const struct moving *moving)
{
    const double length_s = moving_length_s(moving), orbit_s = (double)options->orbit_frames / options->frames_per_s;
    return length_s > 0 ? length_s * fmax(1, ceil(orbit_s / length_s)) : orbit_s;
}

static size_t orbit_frames(const struct options *options, const struct moving *moving)
{
    if (options->frames) return options->frames;
    if (!options_loop(options, moving)) return options->orbit_frames;
    return (size_t)fmin(MOST_LOOP_FRAMES, round(loop_length_s(options, moving) * options->frames_per_s));
}

double options_rate(const struct options *options, const struct moving *moving, size_t count)
{
    return options_loop(options, moving) ? (double)count / loop_length_s(options, moving) : options->frames_per_s;
}

/* What moves turns its faces. */
static void note_backs(const struct options *options, const struct moving *moving, const struct camera_path *path)
{
    if (!moving || moving->count || options_scene_is_compiled(options) || facing_any(&moving->model, path)) return;
    notice(
        "%s: all its faces turn their backs to every camera, and backs are not drawn: --two-sided or --reverse-faces",
        options->scene_path);
}

bool options_load(struct options *options, struct compiled *scene, struct moving *moving, struct lens *lens,
                  struct camera_path *path, struct error *err)
{
    if (!compile_options_cameras(&options->compile, &options->cameras, path, err)) return false;
    if ((path->count && !take_frames(options, path, err)) || !load_scene(options, scene, moving, err)) return false;
    if (!options_scene_is_compiled(options)) options->setup.method = scene->report.draws;
    note_idle(options, moving);
    if (!lens_for_grid(lens, options->compile.fov_deg, options->compile.near_m, &scene->grid, options->setup.w_px,
                       options->setup.h_px, err))
        return false;
    if (options->compile.near_m <= 0.0) lens_note_near(options->scene_path, &scene->grid);
    if (!camera_choice_plan(&options->cameras, scene, lens, orbit_frames(options, moving), path, err)) return false;
    note_backs(options, moving, path);
    return true;
}
