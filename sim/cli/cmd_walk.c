/* SPDX-License-Identifier: MIT
 *
 * `limner walk MODEL -o FILE.cam`: a walk through a scene as cameras, a line a frame; walls, steps and falls are those
 * of firmware/collide.h. */
#include "base/arguments.h"
#include "base/parse.h"
#include "base/printable.h"
#include "cameras/walk_path.h"
#include "cli/commands.h"
#include "compiler/compile.h"
#include "levels/level_cameras.h"
#include "levels/level_path.h"
#include "outputs/outputs.h"
#include "scene/scene_files.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES_DEFAULT = 256, FRAMES_MAX = 100000 };
static const double STRIDE_M = 0.25, LENGTH_MAX_M = 1000.0, PI = 3.14159265358979323846;

/* Of people; and of a player of Doom in a map of 32 units a metre. */
static const struct walk_body PERSON = {.eye_m = 1.6, .height_m = 1.75, .radius_m = 0.25, .step_m = 0.4};
static const struct walk_body PLAYER = {.eye_m = 1.28, .height_m = 1.75, .radius_m = 0.5, .step_m = 0.75};

struct walking {
    const char *model, *out_path;
    struct compile_options compile;
    struct walk_wish wish;
    struct compiled scene;
    struct camera_path path;
    struct walk_found found;
    struct outputs outputs;
};

/* Options ------------------------------------------------------------------------------------ */

static bool take_length(struct arguments *arguments, const char *option, double *out_m, struct error *err)
{
    const char *text = NULL;
    if (!arguments_value(arguments, option, &text, err)) return false;
    if (!text) return true;
    return parse_number(option, text, out_m, err) &&
           ((*out_m > 0 && *out_m < LENGTH_MAX_M) ||
            error_set(err, "%s %s: must be metres above 0, and below %g", option, text, LENGTH_MAX_M));
}

/* X,Y,Z */
static bool take_from(struct arguments *arguments, struct walk_wish *wish, struct error *err)
{
    const char *text = NULL;
    int end = 0;
    if (!arguments_value(arguments, "--from", &text, err)) return false;
    if (!text) return true;
    double *at_m = wish->from_m;
    wish->has_from = sscanf(text, "%lf,%lf,%lf%n", &at_m[0], &at_m[1], &at_m[2], &end) == 3 && !text[end] &&
                     isfinite(at_m[0]) && isfinite(at_m[1]) && isfinite(at_m[2]);
    return wish->has_from || error_set(err, "--from %s: must be the eye's X,Y,Z in metres", text);
}

static bool take_heading(struct arguments *arguments, struct walk_wish *wish, struct error *err)
{
    const char *text = NULL;
    if (!arguments_value(arguments, "--heading", &text, err)) return false;
    if (!text) return true;
    if (!wish->has_from) return error_set(err, "--heading %s: belongs to --from", text);
    return parse_number("--heading", text, &wish->heading_deg, err) &&
           (fabs(wish->heading_deg) <= 360.0 || error_set(err, "--heading %s: must be -360 to 360 degrees", text));
}

static bool take_frames(struct arguments *arguments, struct walk_wish *wish, struct error *err)
{
    const char *text = NULL;
    uint32_t count = FRAMES_DEFAULT;
    if (!arguments_value(arguments, "--frames", &text, err) ||
        (text && !parse_whole("--frames", text, 1, FRAMES_MAX, &count, err)))
        return false;
    wish->frames = count;
    return true;
}

static bool take_body(struct arguments *arguments, struct walk_body *body, struct error *err)
{
    if (!take_length(arguments, "--eye", &body->eye_m, err) ||
        !take_length(arguments, "--height", &body->height_m, err) ||
        !take_length(arguments, "--radius", &body->radius_m, err) ||
        !take_length(arguments, "--step", &body->step_m, err))
        return false;
    if (body->eye_m >= body->height_m)
        return error_set(err, "--eye %g: must be below the walker's height of %g m", body->eye_m, body->height_m);
    return body->step_m < body->height_m ||
           error_set(err, "--step %g: must be below the walker's height of %g m", body->step_m, body->height_m);
}

static bool take_orientation(struct arguments *arguments, struct compile_options *compile, struct error *err)
{
    const char *up = NULL;
    if (!arguments_value(arguments, "--up", &up, err) ||
        (up && !orientation_parse(ORIENTATION_UP, up, &compile->orientation, err)))
        return false;
    if (arguments_flag(arguments, "--reverse-faces") &&
        !orientation_parse(ORIENTATION_REVERSE_FACES, NULL, &compile->orientation, err))
        return false;
    if (arguments_flag(arguments, "--two-sided") &&
        !orientation_parse(ORIENTATION_TWO_SIDED, NULL, &compile->orientation, err))
        return false;
    compile->drop_small = arguments_flag(arguments, "--drop-small");
    return true;
}

/* What no option took. */
static bool take_model(struct walking *walking, const struct arguments *arguments, struct error *err)
{
    int first = 1;
    for (int i = 1; i < arguments->count && strcmp(arguments->items[i], "--") != 0; i++)
        if (arguments->items[i][0] == '-') return error_no_option(err, arguments->items[i]);
    if (first < arguments->count && strcmp(arguments->items[first], "--") == 0) first++;
    if (first >= arguments->count) return error_set(err, "walk: needs a model");
    if (first + 1 < arguments->count)
        return error_set(err, "walk: one model at a time, what is '%s'?", arguments->items[first + 1]);
    walking->model = arguments->items[first];
    return walking->out_path || error_set(err, "walk: -o FILE.cam says where to");
}

/* Which body is usual hangs on the model, which is not known yet. */
static bool names_map(const struct arguments *arguments)
{
    bool names = false;
    for (int i = 1; i < arguments->count; i++)
        names = names || level_path_parse(arguments->items[i], NULL);
    return names;
}

static bool parse(struct walking *walking, struct arguments *arguments, struct error *err)
{
    walking->compile =
        (struct compile_options){.tolerance_units = 0.5, .splitter = "fewest", .tree = TREE_BSP, .unlit = true};
    walking->wish.body = names_map(arguments) ? PLAYER : PERSON;
    walking->wish.stride_m = STRIDE_M;
    return arguments_value(arguments, "-o", &walking->out_path, err) && take_frames(arguments, &walking->wish, err) &&
           take_from(arguments, &walking->wish, err) && take_heading(arguments, &walking->wish, err) &&
           take_length(arguments, "--stride", &walking->wish.stride_m, err) &&
           take_body(arguments, &walking->wish.body, err) && take_orientation(arguments, &walking->compile, err) &&
           take_model(walking, arguments, err);
}

/* The walk ----------------------------------------------------------------------------------- */

/* A map's first player stands where it begins. */
static bool begin_as_player(struct walking *walking, struct error *err)
{
    struct walk_wish *wish = &walking->wish;
    struct level_camera *cameras;
    size_t count;
    if (wish->has_from || !level_path_parse(walking->model, NULL)) return true;
    if (!level_cameras_read(walking->model, &cameras, &count, err)) return false;
    memcpy(wish->from_m, cameras[0].eye_m, sizeof wish->from_m);
    wish->heading_deg =
        atan2(cameras[0].eye_m[0] - cameras[0].target_m[0], cameras[0].eye_m[2] - cameras[0].target_m[2]) * 180 / PI;
    wish->has_from = true;
    free(cameras);
    return true;
}

static bool load(struct walking *walking, struct error *err)
{
    return (lim_file_is_named(walking->model)
                ? lim_file_read(walking->model, &walking->scene, err)
                : compile_model(walking->model, &walking->compile, &walking->scene, err)) &&
           begin_as_player(walking, err) &&
           walk_path(&walking->scene, walking->model, &walking->wish, &walking->path, &walking->found, err);
}

static bool write_path(struct walking *walking, struct error *err)
{
    const struct walk_body *body = &walking->wish.body;
    FILE *file = outputs_open(&walking->outputs, walking->out_path, err);
    if (!file) return false;
    printable_print(file,
                    "# A walk through %s: %zu frames of %g m; an eye at %g m, %g m high, %g m wide, steps of %g m.\n",
                    walking->model, walking->path.count, walking->wish.stride_m, body->eye_m, body->height_m,
                    2 * body->radius_m, body->step_m);
    for (size_t i = 0; i < walking->path.count; i++)
        viewpoint_write(&walking->path.frames[i], file);
    return outputs_close(file, walking->out_path, err);
}

static void print_found(const struct walking *walking)
{
    const struct walk_found *found = &walking->found;
    printable_print(
        stdout, "%s: %zu frames, %.0f m; of %zu places half a metre apart that can be reached %zu are seen, %.0f %%\n",
        walking->model, walking->path.count, found->way_m, found->places, found->seen,
        100.0 * (double)found->seen / (double)found->places);
}

int cmd_walk(int argc, char **argv)
{
    struct walking walking = {.out_path = NULL};
    struct arguments arguments = {argv, argc};
    struct error err;
    bool ok = parse(&walking, &arguments, &err) && load(&walking, &err) && write_path(&walking, &err);
    ok = ok && outputs_keep(&walking.outputs, &err);
    if (ok) print_found(&walking);
    outputs_discard(&walking.outputs);
    camera_path_free(&walking.path);
    compiled_free(&walking.scene);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
