/* SPDX-License-Identifier: MIT
 *
 * A board's buttons and the keys of `limner view` in a hall: neither leaves it, and its near plane stays before the
 * walls. */
#include "board.h"
#include "cli/fly.h"
#include "rigs/cmocka_ready.h"
#include "rigs/room_scene.h"
#include "walker.h"

#include <math.h>
#include <stdlib.h>

static const double SIDE_M = 6, HEIGHT_M = 8, NEAR_M = 0.1;

struct stage {
    struct room_scene room;
    struct compiled scene;
    struct lim_solid solid;
    lim_index *stack;
    struct lim_camera camera;
    struct random random;
};

static int set_up(void **state)
{
    struct stage *stage = calloc(1, sizeof *stage);
    const double side[2] = {0, SIDE_M}, height[2] = {0, HEIGHT_M};
    struct error err;

    room_scene_begin(&stage->room);
    room_scene_floor(&stage->room, side, side, HEIGHT_M, 0x404040);
    room_scene_quad(&stage->room, 0, 0, 1, height, side, 0x606060);
    room_scene_quad(&stage->room, 0, SIDE_M, -1, height, side, 0x606060);
    room_scene_quad(&stage->room, 2, 0, 1, side, height, 0x707070);
    room_scene_quad(&stage->room, 2, SIDE_M, -1, side, height, 0x707070);
    room_scene_box(&stage->room, (const double[3]){2, 0, 2}, (const double[3]){3, 0.2, 3}, 0x808080); /* a step */
    if (!room_scene_compile(&stage->room, PORTALS_OFF, NULL, &stage->scene, &err)) fail_msg("%s", err.text);
    stage->stack = calloc(stage->scene.scene.limits.depth, sizeof *stage->stack);
    assert_int_equal(lim_solid_init(&stage->solid, &stage->scene.scene, stage->stack,
                                    stage->scene.scene.limits.depth * sizeof *stage->stack),
                     LIM_OK);
    stage->random = (struct random){8};
    *state = stage;
    return 0;
}

static int tear_down(void **state)
{
    struct stage *stage = *state;

    compiled_free(&stage->scene);
    room_scene_free(&stage->room);
    free(stage->stack);
    free(stage);
    return 0;
}

static void put_camera(struct stage *stage, double x_m, double y_m, double z_m)
{
    const double at_m[3] = {x_m, y_m, z_m};
    const struct grid *grid = &stage->scene.grid;

    stage->camera = (struct lim_camera){.tan_x_q28 = UINT32_C(1) << 28,
                                        .tan_y_q28 = UINT32_C(1) << 28,
                                        .near_q8 = (int32_t)(NEAR_M * grid->units_per_m * 256)};
    for (int i = 0; i < 3; i++)
        stage->camera.eye_q8[i] = (int32_t)lround((at_m[i] - grid->origin_m[i]) * grid->units_per_m * 256);
}

static double eye_m(const struct stage *stage, int axis)
{
    return stage->camera.eye_q8[axis] / 256.0 / stage->scene.grid.units_per_m + stage->scene.grid.origin_m[axis];
}

static void assert_within(const struct stage *stage)
{
    const double most_m[3] = {SIDE_M, HEIGHT_M, SIDE_M};

    for (int i = 0; i < 3; i++)
        assert_true(eye_m(stage, i) >= 2 * NEAR_M && eye_m(stage, i) <= most_m[i] - 2 * NEAR_M);
}

/* Straight on until it is stopped, a turn, and on. Returns how far it went in all. */
static double walk_about(struct stage *stage, struct walker *walker)
{
    double gone_m = 0;

    walker_frame(walker, 0, &stage->camera);
    for (int k = 0; k < 60; k++) {
        const int turns = (int)random_in(&stage->random, 0, 100);
        for (int i = 0; i < turns; i++)
            walker_frame(walker, BOARD_LEFT, &stage->camera);
        for (int i = 0; i < 150; i++) {
            const double x_m = eye_m(stage, 0), z_m = eye_m(stage, 2);
            walker_frame(walker, random_u64(&stage->random) % 8 ? BOARD_UP : BOARD_DOWN | BOARD_RIGHT, &stage->camera);
            gone_m += hypot(eye_m(stage, 0) - x_m, eye_m(stage, 2) - z_m);
            assert_within(stage);
        }
    }
    return gone_m;
}

static void buttons_stay_in_the_hall_on_foot(void **state)
{
    struct stage *stage = *state;
    struct walker walker = {.walking = false};
    double highest_m = 0;

    walker_set_solid(&walker, &stage->solid);
    put_camera(stage, 1, 1.6, 1);
    assert_true(walk_about(stage, &walker) > 60);
    assert_true(fabs(eye_m(stage, 1) - 1.6) < 0.01 || fabs(eye_m(stage, 1) - 1.8) < 0.01);
    put_camera(stage, 2.5, 1.6, 5); /* forward is -z: over the step, and down again */
    walker.walking = false;
    for (int i = 0; i < 170; i++) {
        walker_frame(&walker, BOARD_UP, &stage->camera);
        highest_m = fmax(highest_m, eye_m(stage, 1));
    }
    assert_true(fabs(highest_m - 1.8) < 0.01 && fabs(eye_m(stage, 1) - 1.6) < 0.01);
}

static void buttons_stay_in_the_hall_where_no_floor_is_near(void **state)
{
    struct stage *stage = *state;
    struct walker walker = {.walking = false};

    walker_set_solid(&walker, &stage->solid);
    put_camera(stage, 1, 6, 1);
    assert_true(walk_about(stage, &walker) > 60);
    assert_true(fabs(eye_m(stage, 1) - 6) < 0.01);
}

/* Nothing is drawn. */
static void keys_stay_in_the_hall(void **state)
{
    struct stage *stage = *state;
    struct flight flight;
    struct error err;

    put_camera(stage, 1, 1.6, 1);
    if (!flight_init(&flight, NULL, &stage->scene.scene, &stage->camera, &stage->scene.grid, NULL, &err))
        fail_msg("%s", err.text);
    for (int k = 0; k < 3000; k++) {
        const enum fly_key key = (enum fly_key)random_in(&stage->random, FLY_FORWARD, FLY_LOOK_DOWN);
        for (int i = 0; i < 12; i++)
            flight_key(&flight, key);
        stage->camera = flight.camera;
        assert_within(stage);
    }
    flight_key(&flight, FLY_WALLS);
    for (int i = 0; i < 200; i++)
        flight_key(&flight, FLY_UP);
    stage->camera = flight.camera;
    assert_true(eye_m(stage, 1) > HEIGHT_M + 1);
    flight_free(&flight);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(buttons_stay_in_the_hall_on_foot),
        cmocka_unit_test(buttons_stay_in_the_hall_where_no_floor_is_near),
        cmocka_unit_test(keys_stay_in_the_hall),
    };

    return cmocka_run_group_tests_name("walls and keys", tests, set_up, tear_down);
}
