/* SPDX-License-Identifier: MIT
 *
 * Extremes of the lens and of the display: fields of view from 1 to 150 degrees, pictures from a pixel to
 * 1024x600 of them, and of a single line or column. */
#include "extreme.h"
#include "rigs/boxes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LENSES = 11, CORNER_FRAMES = 300, CORNERS_SIDE_PX = 240 };

/* Nearer by, half the eye's last place is more of the picture than what is measured here. */
static const double FAR_ENOUGH_M = 1000;

static const int lenses_deg[LENSES] = {1, 2, 3, 5, 10, 22, 45, 60, 90, 120, 150};

static void look_from_anywhere(struct extreme *extreme, struct random *random)
{
    double eye_m[3], target_m[3];

    boxes_random_point(random, BOXES_END_M, 1.0 / 256, eye_m);
    boxes_random_point(random, BOXES_END_M, 1, target_m);
    extreme_frame(extreme, eye_m, target_m);
}

static void every_field_of_view_from_1_to_150_degrees(void **state)
{
    char name[32], about[64];

    (void)state;
    for (size_t i = 0; i < LENSES; i++) {
        const struct extreme_plan plan = {
            name, about, {120, 120, lenses_deg[i], 4}, boxes_add_jumble, look_from_anywhere, 100, true};
        snprintf(name, sizeof name, "fov-%d", lenses_deg[i]);
        snprintf(about, sizeof about, "The lens sees %d degree%s from top to bottom", lenses_deg[i],
                 lenses_deg[i] == 1 ? "" : "s");
        extreme_run(&plan);
    }
}

/* Where corners are ------------------------------------------------------------------------------------------------ */

/* At a corner of a face, so that a long lens sees edges. Every other eye is in the room that is as large as the grid;
 * the others are outside of it, up to seven times as far away. */
static void look_at_corner(struct random *random, const struct mesh *mesh, bool from_outside, double eye_m[3],
                           double target_m[3])
{
    const size_t corner = (size_t)random_in(random, 0, (int64_t)mesh->polygon_count * 3 - 1);
    const struct mesh_polygon *polygon = &mesh->polygons[corner / 3];
    const double range_m = from_outside ? 7.0 * BOXES_END_M : BOXES_END_M;

    memcpy(target_m, mesh->points[mesh->corners[polygon->first + corner % 3]], 3 * sizeof *target_m);
    do
        boxes_random_point(random, range_m, 1.0 / 256, eye_m);
    while (memcmp(eye_m, target_m, 3 * sizeof *eye_m) == 0);
}

/* Where a point is on the screen, in pixels, the centre of the first at 0; false: it is not on it. */
static bool corner_on_screen(const struct extreme *extreme, const struct viewpoint *viewpoint, const double point_m[3],
                             double at_px[2])
{
    struct view_axes axes;
    double right_m = 0, up_m = 0, ahead_m = 0;

    viewpoint_axes(viewpoint, &axes);
    for (int i = 0; i < 3; i++) {
        right_m += (point_m[i] - viewpoint->eye_m[i]) * axes.right[i];
        up_m += (point_m[i] - viewpoint->eye_m[i]) * axes.up[i];
        ahead_m += (point_m[i] - viewpoint->eye_m[i]) * axes.forward[i];
    }
    const double x = right_m / ahead_m / extreme->lens.tan_x, y = up_m / ahead_m / extreme->lens.tan_y;
    at_px[0] = (1 + x) / 2 * extreme->picture.w_px - 0.5;
    at_px[1] = (1 - y) / 2 * extreme->picture.h_px - 0.5;
    return ahead_m >= FAR_ENOUGH_M && fabs(x) <= 1 && fabs(y) <= 1;
}

/* How far a corner on the screen is off at most, in pixels, in a frame. */
static double most_off_px(struct extreme *extreme, const double eye_m[3], const double target_m[3])
{
    const struct lim_camera camera = extreme_aim(extreme, eye_m, target_m);
    const struct lim_scene *scene = &extreme->scene.scene;
    struct viewpoint viewpoint = {.line = 1};
    double most_px = 0;

    memcpy(viewpoint.eye_m, eye_m, sizeof viewpoint.eye_m);
    memcpy(viewpoint.target_m, target_m, sizeof viewpoint.target_m);
    extreme_camera(extreme, &camera);
    for (lim_index i = 0; i < scene->vertex_count; i++) {
        const double point_m[3] = {scene->vertices[i].x, scene->vertices[i].y, scene->vertices[i].z};
        double true_px[2], at_px[2];
        if (!corner_on_screen(extreme, &viewpoint, point_m, true_px) ||
            !extreme->profile->project(extreme->ids.simulator.lim, i, at_px))
            continue;
        most_px = fmax(most_px, hypot(at_px[0] - true_px[0], at_px[1] - true_px[1]));
    }
    return most_px;
}

/* In one lens, by one profile. */
static double corners_through(const struct model *model, const struct core *profile, int fov_deg, bool from_outside)
{
    const struct extreme_picture picture = {CORNERS_SIDE_PX, CORNERS_SIDE_PX, fov_deg, 4};
    struct random random = {73};
    struct extreme extreme;
    double most_px = 0;

    extreme_open(&extreme, model, profile, &picture);
    for (int f = 0; f < effort(CORNER_FRAMES); f++) {
        double eye_m[3], target_m[3];
        look_at_corner(&random, &extreme.mesh, from_outside, eye_m, target_m);
        most_px = fmax(most_px, most_off_px(&extreme, eye_m, target_m));
    }
    extreme_close(&extreme);
    return most_px;
}

/* Half a step to each side, and what quotients and rows leave. */
static double most_promised_px(const struct core *profile)
{
    switch (profile->profile) {
    case LIM_PROFILE_DRAFT:
        return 0.75;
    case LIM_PROFILE_FAST:
        return 0.04;
    case LIM_PROFILE_FINE:
        return 0.002;
    default:
        return 0.0003;
    }
}

static void corners_row(const struct model *model, const char *name, const struct core *profile, bool from_outside)
{
    const double promised_px = most_promised_px(profile);
    char promise[64], measured[32 * LENSES] = "";

    for (size_t i = 0; i < LENSES; i++) {
        const double most_px = corners_through(model, profile, lenses_deg[i], from_outside);
        const size_t used = strlen(measured);
        snprintf(measured + used, sizeof measured - used, "%s%d: %.2g", i ? ", " : "", lenses_deg[i], most_px);
        assert_true(most_px <= promised_px);
    }
    snprintf(promise, sizeof promise, "at most %g px off", promised_px);
    extreme_row(name, profile->name, promise, "%s px", measured);
}

static void corners_are_as_exact_through_every_lens(const char *name, const char *about, bool from_outside)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    struct model model = {0};

    boxes_add_jumble(&model);
    extreme_about(name, about);
    for (size_t k = 0; k < count; k++)
        corners_row(&model, name, profiles[k], from_outside);
    model_free(&model);
}

static void corners_are_as_exact_through_every_lens_from_within(void **state)
{
    (void)state;
    corners_are_as_exact_through_every_lens(
        "corners", "Corners through lenses of 1 to 150 degrees, 240 pixels high, seen from within the scene", false);
}

static void corners_are_as_exact_through_every_lens_from_afar(void **state)
{
    (void)state;
    corners_are_as_exact_through_every_lens(
        "corners-from-afar", "The same from outside of the scene, up to seven times as far away as its end is", true);
}

/* Displays --------------------------------------------------------------------------------------------------------- */

static void every_display_from_a_pixel_to_1024x600(void **state)
{
    static const struct {
        unsigned w_px, h_px;
        double fov_deg;
    } sizes[] = {{1, 1, 60},     {8, 8, 60},      {84, 48, 60},   {320, 480, 60},
                 {480, 320, 60}, {1024, 600, 60}, {200, 1, 0.33}, {1, 200, 60}};
    char name[32], about[64];

    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const unsigned w_px = sizes[i].w_px, h_px = sizes[i].h_px;
        const int frames = w_px * h_px < 10000 ? 400 : w_px * h_px < 200000 ? 15 : 5;
        const struct extreme_plan plan = {
            name, about, {w_px, h_px, sizes[i].fov_deg, 4}, boxes_add_jumble, look_from_anywhere, frames, true};
        snprintf(name, sizeof name, "display-%ux%u", w_px, h_px);
        snprintf(about, sizeof about, "The display has %u x %u pixels", w_px, h_px);
        extreme_run(&plan);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_field_of_view_from_1_to_150_degrees),
        cmocka_unit_test(corners_are_as_exact_through_every_lens_from_within),
        cmocka_unit_test(corners_are_as_exact_through_every_lens_from_afar),
        cmocka_unit_test(every_display_from_a_pixel_to_1024x600),
    };

    return cmocka_run_group_tests_name("extremes of lens and display", tests, NULL, NULL);
}
