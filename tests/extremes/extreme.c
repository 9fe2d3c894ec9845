/* SPDX-License-Identifier: MIT
 *
 * The rig behind extreme.h. */
#include "extreme.h"

#include "compiler/compile_mesh.h"
#include "compiler/coordinates.h"
#include "compiler/faithful.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { HOLES_ENOUGH = 1000 }; /* to say that a profile is broken */
enum { LEAST_PX = 1000 };     /* of a screen that has more than edges */

/* The nearest near plane that the renderer has, in units, with some room. */
static double least_near_units(const struct lens *lens)
{
    return 2.1 / (lens_is_long(lens) ? 0.5 : fmin(1, fmin(lens->tan_x, lens->tan_y)));
}

static void open_lens(struct extreme *extreme)
{
    const struct extreme_picture *picture = &extreme->picture;
    struct error err;

    if (!lens_init(&extreme->lens, picture->fov_deg, picture->near_m, picture->w_px, picture->h_px, &err))
        fail_msg("%s", err.text);
    extreme->lens.near_m = fmax(picture->near_m, least_near_units(&extreme->lens) / extreme->scene.grid.units_per_m);
}

/* Of a long scene the reference has the model's own points, unrounded. */
static bool clean(struct extreme *extreme, const struct model *model, const struct compile_options *options,
                  bool is_long, struct error *err)
{
    const struct extreme_picture *picture = &extreme->picture;
    struct mesh fine;

    if (!is_long)
        return mesh_clean(model, &extreme->mesh, err) &&
               reference_init(&extreme->reference, &extreme->mesh, picture->w_px, picture->h_px, err);
    if (!coordinates_clean(model, options, &extreme->mesh, err) ||
        !mesh_clean_fine(model, &extreme->mesh.grid, &fine, err))
        return false;
    const bool ok = reference_init(&extreme->reference, &fine, picture->w_px, picture->h_px, err);
    mesh_free(&fine);
    return ok;
}

static void open_extreme(struct extreme *extreme, const struct model *model, const struct core *profile,
                         const struct extreme_picture *picture, bool is_long)
{
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "fewest",
                                            .keep_faces = true,
                                            .core = profile,
                                            .w_px = picture->w_px,
                                            .h_px = picture->h_px,
                                            .coordinates = is_long ? COORDINATES_32 : COORDINATES_16};
    const struct simulator_setup setup = {.w_px = picture->w_px, .h_px = picture->h_px, .core = profile};
    struct error err;

    *extreme = (struct extreme){.profile = profile, .picture = *picture};
    if (!clean(extreme, model, &options, is_long, &err) || !mesh_insert_t_vertices(&extreme->mesh, &err) ||
        !compile_mesh(&extreme->mesh, &options, &extreme->scene, &err) ||
        !ids_init(&extreme->ids, &extreme->scene, &setup, &err))
        fail_msg("%s", err.text);
    assert_int_equal(extreme->scene.grid.is_long, is_long);
    open_lens(extreme);
}

void extreme_open(struct extreme *extreme, const struct model *model, const struct core *profile,
                  const struct extreme_picture *picture)
{
    open_extreme(extreme, model, profile, picture, false);
}

void extreme_open_long(struct extreme *extreme, const struct model *model, const struct core *profile,
                       const struct extreme_picture *picture)
{
    open_extreme(extreme, model, profile, picture, true);
}

void extreme_close(struct extreme *extreme)
{
    extreme_picture_free(&extreme->best);
    ids_free(&extreme->ids);
    compiled_free(&extreme->scene);
    reference_free(&extreme->reference);
    mesh_free(&extreme->mesh);
}

static struct viewpoint viewpoint_of(const double eye_m[3], const double target_m[3])
{
    struct viewpoint viewpoint = {.line = 1};

    memcpy(viewpoint.eye_m, eye_m, sizeof viewpoint.eye_m);
    memcpy(viewpoint.target_m, target_m, sizeof viewpoint.target_m);
    return viewpoint;
}

struct lim_camera extreme_aim(const struct extreme *extreme, const double eye_m[3], const double target_m[3])
{
    struct viewpoint viewpoint = viewpoint_of(eye_m, target_m);
    const struct camera_path path = {"extreme", &viewpoint, 1};
    struct lim_camera camera;
    struct error err;

    if (!camera_path_to_camera(&path, 0, &extreme->lens, &extreme->scene.grid, &camera, &err)) fail_msg("%s", err.text);
    return camera;
}

size_t extreme_camera(struct extreme *extreme, const struct lim_camera *camera)
{
    struct error err;

    if (!ids_frame(&extreme->ids, camera, &err)) fail_msg("%s", err.text);
    return simulator_stats(&extreme->ids.simulator)->pixels_background;
}

/* One profile's picture stands for all. */
static bool is_shown(const struct extreme *extreme)
{
    return extreme->profile->profile == LIM_PROFILE_FAST && extreme_picture_is_wanted();
}

void extreme_frame(struct extreme *extreme, const double eye_m[3], const double target_m[3])
{
    const struct viewpoint viewpoint = viewpoint_of(eye_m, target_m);
    const struct lim_camera camera = extreme_aim(extreme, eye_m, target_m);

    extreme_camera(extreme, &camera);
    reference_draw(&extreme->reference, &viewpoint, &extreme->lens);
    holes_add(&extreme->sum, extreme->profile, extreme->ids.faces, &extreme->reference,
              1 / extreme->scene.grid.units_per_m);
    if (is_shown(extreme))
        extreme_picture_consider(&extreme->best, extreme->ids.faces, extreme->reference.depths_m,
                                 extreme->reference.faces, extreme->picture.w_px, extreme->picture.h_px);
}

void extreme_show(struct extreme *extreme, const char *name)
{
    const struct extreme_picture *picture = &extreme->picture;

    if (!is_shown(extreme)) return;
    extreme_picture_consider(&extreme->best, extreme->ids.faces, NULL, NULL, picture->w_px, picture->h_px);
    extreme_picture_write(&extreme->best, name, picture->w_px, picture->h_px);
}

void extreme_about(const char *name, const char *about)
{
    printf("# extreme-about %s %s\n", name, about);
}

void extreme_row(const char *name, const char *profile, const char *promised, const char *measured, ...)
{
    va_list arguments;

    printf("# extreme %s %s promised %s measured ", name, profile, promised);
    va_start(arguments, measured);
    vprintf(measured, arguments);
    va_end(arguments);
    putchar('\n');
}

/* What a profile promises of ordinary scenes, in percent of the pixels; in those of many scales more of them are edges.
 */
static double most_wrong_percent(const struct core *profile, bool is_long)
{
    switch (profile->profile) {
    case LIM_PROFILE_FAST:
        return is_long ? 0.1 : 0.05;
    case LIM_PROFILE_FINE:
        return is_long ? 0.05 : 0.03;
    default:
        return is_long ? 0.01 : 0.003;
    }
}

static void promise_print(char *text, size_t text_b, bool exact, double most_percent)
{
    if (most_percent > 0)
        snprintf(text, text_b, "0 holes, order exact, <= %g %% wrong", most_percent);
    else
        snprintf(text, text_b, exact ? "0 holes, order exact" : "0 holes");
}

void extreme_judge(const struct extreme *extreme, const char *name, bool order)
{
    const struct holes *sum = &extreme->sum;
    const bool exact = order && extreme->profile->sub_bits > 0;
    const bool is_ordinary = exact && extreme->picture.w_px * extreme->picture.h_px >= LEAST_PX;
    const double most_percent = is_ordinary ? most_wrong_percent(extreme->profile, extreme->scene.grid.is_long) : 0;
    char promise[64];

    promise_print(promise, sizeof promise, exact, most_percent);
    extreme_row(name, extreme->profile->name, promise,
                "%zu holes, %zu misplaced, %.4f %% wrong in %zu pixels of %zu frames", sum->holes, sum->misplaced,
                holes_wrong_percent(sum), sum->pixels, sum->frames);
    assert_int_equal(sum->holes, 0);
    if (exact) assert_int_equal(sum->misplaced, 0);
    if (is_ordinary) assert_true(holes_wrong_percent(sum) <= most_percent);
}

static void run(const struct extreme_plan *plan, bool is_long)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    struct model model = {0};

    assert_true(count >= 2);
    plan->build(&model);
    extreme_about(plan->name, plan->about);
    for (size_t k = 0; k < count; k++) {
        struct random random = {71};
        struct extreme extreme;
        open_extreme(&extreme, &model, profiles[k], &plan->picture, is_long);
        if (!is_long) assert_true(extreme.scene.grid.units_per_m == 1);
        for (int f = 0; f < effort(plan->frames) && extreme.sum.holes <= HOLES_ENOUGH; f++)
            plan->look(&extreme, &random);
        extreme_picture_write(&extreme.best, plan->name, plan->picture.w_px, plan->picture.h_px);
        extreme_judge(&extreme, plan->name, plan->order);
        extreme_close(&extreme);
    }
    model_free(&model);
}

void extreme_run(const struct extreme_plan *plan)
{
    run(plan, false);
}

void extreme_run_long(const struct extreme_plan *plan)
{
    run(plan, true);
}
