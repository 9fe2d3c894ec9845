/* SPDX-License-Identifier: MIT
 *
 * Extremes of the near plane: walls that it just does not reach, at every alignment, and polygons that
 * fill the screen though they have vertices behind the eye. */
#include "extreme.h"
#include "rigs/boxes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random_camera.h"

#include <math.h>

enum { BOXES = 12, BOX_FRAMES = 1500, CELL_FRAMES = 400 };

/* Some units further from the walls than the near plane reaches, and no more along most axes. */
static struct lim_camera camera_beside_walls(const int32_t half_units[3], struct random *random)
{
    struct lim_camera camera = {.yaw = random_angle(random),
                                .pitch = random_angle(random),
                                .roll = random_angle(random),
                                .tan_x_q28 = random_tan_q28(random),
                                .near_q8 = (int32_t)random_in(random, 1, 1024)};

    camera.tan_y_q28 = random_u64(random) % 2 ? camera.tan_x_q28 : random_tan_q28(random);
    const int32_t margin = (int32_t)ceil(near_reach_units(&camera)) + 2;
    for (int i = 0; i < 3; i++) {
        const int32_t most = half_units[i] > margin ? half_units[i] - margin : 0;
        const int32_t at = random_u64(random) % 3 ? most : (int32_t)random_in(random, 0, most);
        camera.eye_q8[i] = 256 * (random_u64(random) % 2 ? at : -at);
    }
    return camera;
}

/* A room of its own: as large as the grid along one axis at least, centred on 0. */
static void build_room(struct model *model, struct random *random, int32_t half_units[3])
{
    const int longest = (int)(random_u64(random) % 3);
    double low_m[3], high_m[3];

    for (int i = 0; i < 3; i++) {
        half_units[i] = i == longest ? BOXES_END_M : (int32_t)random_in(random, 700, BOXES_END_M);
        high_m[i] = half_units[i];
        low_m[i] = -high_m[i];
    }
    boxes_add_room(model, low_m, high_m);
}

static void graze(const struct core *profile, struct random *random, size_t *background, size_t *clipped)
{
    static const struct extreme_picture picture = {16, 12, 60, 4};
    struct model model = {0};
    struct extreme extreme;
    int32_t half_units[3];

    build_room(&model, random, half_units);
    extreme_open(&extreme, &model, profile, &picture);
    assert_true(extreme.scene.grid.units_per_m == 1);
    for (int f = 0; f < BOX_FRAMES; f++) {
        const struct lim_camera camera = camera_beside_walls(half_units, random);
        *background += extreme_camera(&extreme, &camera);
        *clipped += simulator_stats(&extreme.ids.simulator)->clipped;
    }
    extreme_show(&extreme, "near-grazing");
    extreme_close(&extreme);
    model_free(&model);
}

/* Whatever the camera, a room seen from inside fills the picture, as long as the near plane does not reach
 * its walls. */
static void a_near_plane_that_grazes_walls_at_every_alignment(void **state)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);

    (void)state;
    for (size_t k = 0; k < count; k++) {
        struct random random = {75};
        if (k == 0) extreme_about("near-grazing", "The near plane all but touches the walls, at every angle");
        size_t background = 0, clipped = 0;
        for (int b = 0; b < BOXES; b++)
            graze(profiles[k], &random, &background, &clipped);
        extreme_row("near-grazing", profiles[k]->name, "0 pixels of background",
                    "%zu pixels of background in %d frames, %zu polygons clipped", background, BOXES * BOX_FRAMES,
                    clipped);
        assert_int_equal(background, 0);
        assert_true(clipped > BOXES * BOX_FRAMES);
    }
}

/* Four triangles from end to end of the grid: from inside every one in view has vertices behind. */
static const double CELL_M[4][3] = {{BOXES_END_M, BOXES_END_M, BOXES_END_M},
                                    {-BOXES_END_M, -BOXES_END_M, BOXES_END_M},
                                    {-BOXES_END_M, BOXES_END_M, -BOXES_END_M},
                                    {BOXES_END_M, -BOXES_END_M, -BOXES_END_M}};

static void build_cell(struct model *model)
{
    boxes_add_tetrahedron(model, CELL_M, true);
}

/* Weights of the corners: near a face all but one of them make up nearly everything. */
static void point_in_cell(struct random *random, double least, double out_m[3])
{
    double weight[4], sum = 0;

    for (int c = 0; c < 4; c++)
        sum += weight[c] = -log(1 - random_unit(random));
    for (int i = 0; i < 3; i++) {
        out_m[i] = 0;
        for (int c = 0; c < 4; c++)
            out_m[i] += CELL_M[c][i] * (least + (1 - 4 * least) * weight[c] / sum);
    }
}

/* Down at the face from a few units above it, so that it is all there is to see, or anywhere else. */
static void look_from_face(struct extreme *extreme, struct random *random)
{
    double eye_m[3], target_m[3];

    point_in_cell(random, 0.0005, eye_m);
    point_in_cell(random, 0, target_m);
    if (random_u64(random) % 2) {
        const size_t out = (size_t)(random_u64(random) % 4);
        for (int i = 0; i < 3; i++) {
            const double off_m = random_unit(random) * 200 - 100;
            eye_m[i] = -CELL_M[out][i] / 3 * 0.999 + off_m / 10;
            target_m[i] = -CELL_M[out][i] / 3 + off_m;
        }
    }
    extreme_frame(extreme, eye_m, target_m);
}

static void polygons_with_vertices_behind_the_eye_fill_the_screen(void **state)
{
    const struct extreme_plan plan = {"vertex-behind-eye",
                                      "Faces fill the screen though they have vertices behind the eye",
                                      {120, 120, 90, 4},
                                      build_cell,
                                      look_from_face,
                                      CELL_FRAMES,
                                      true};

    (void)state;
    extreme_run(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_near_plane_that_grazes_walls_at_every_alignment),
        cmocka_unit_test(polygons_with_vertices_behind_the_eye_fill_the_screen),
    };

    return cmocka_run_group_tests_name("extremes of the near plane", tests, NULL, NULL);
}
