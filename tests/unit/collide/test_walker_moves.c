/* SPDX-License-Identifier: MIT
 *
 * A walker in a hall that was built for it: it stands, slides, climbs what it should, falls, keeps out of what it
 * should; and at random, through buildings and a level, it is never in a wall. */
#include "levels/level_cameras.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/room_scene.h"
#include "unit/collide/solid_stage.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double RADIUS_M = 0.3, HEIGHT_M = 1.7, STEP_M = 0.3, STRIDE_M = 0.05;
static const double UNIT_M = 1 / 3276.0; /* of the hall's grid, about */

struct stage {
    struct solid_stage in;
    struct lim_walker walker;
};

static double q8_of(const struct stage *stage, double length_m)
{
    return length_m * stage->in.scene.grid.units_per_m * 256;
}

static double place_m(const struct stage *stage, int axis)
{
    return stage->walker.at_q8[axis] / 256.0 / stage->in.scene.grid.units_per_m + stage->in.scene.grid.origin_m[axis];
}

static void put_walker(struct stage *stage, double x_m, double y_m, double z_m)
{
    const double at_m[3] = {x_m, y_m, z_m};

    stage->walker = (struct lim_walker){.radius_q8 = (int32_t)q8_of(stage, RADIUS_M),
                                        .height_q8 = (int32_t)q8_of(stage, HEIGHT_M),
                                        .step_q8 = (int32_t)q8_of(stage, STEP_M),
                                        .gravity_q8 = (int32_t)q8_of(stage, 0.01)};
    solid_place_q8(&stage->in.scene, at_m, stage->walker.at_q8);
}

static bool is_walker_in(const struct stage *stage)
{
    const struct lim_walker *walker = &stage->walker;
    const int32_t half_q8[3] = {walker->radius_q8, walker->height_q8 / 2, walker->radius_q8};
    const int32_t at_q8[3] = {walker->at_q8[0], walker->at_q8[1] + half_q8[1], walker->at_q8[2]};

    for (size_t k = 0; k < stage->in.list.count; k++)
        if (solid_overlaps(&stage->in.list, &stage->in.list.polygons[k], at_q8, half_q8)) return true;
    return false;
}

static void move(struct stage *stage, double x_m, double z_m)
{
    assert_int_equal(
        lim_walker_move(&stage->in.solid, &stage->walker, (int32_t)q8_of(stage, x_m), (int32_t)q8_of(stage, z_m)),
        LIM_OK);
    assert_false(is_walker_in(stage));
}

static void walk(struct stage *stage, double x_m, double z_m, int moves)
{
    const double length = hypot(x_m, z_m);

    for (int i = 0; i < moves; i++)
        move(stage, length > 0 ? STRIDE_M * x_m / length : 0, length > 0 ? STRIDE_M * z_m / length : 0);
}

/* From the floor at a place along x. */
static void walk_from(struct stage *stage, double x_m, double z_m, int moves)
{
    put_walker(stage, x_m, 0.01, z_m);
    walk(stage, 1, 0, moves);
}

static void add_box(struct room_scene *room, double x0, double x1, double y0, double y1, double z0, double z1)
{
    room_scene_box(room, (const double[3]){x0, y0, z0}, (const double[3]){x1, y1, z1}, 0x808080);
}

/* A box turned about z, so that its upper side is a slope upwards along x. */
static void add_slope(struct room_scene *room, double x_m, double z_m, double degrees)
{
    const double turn = degrees * 3.14159265358979 / 180, c = cos(turn), s = sin(turn);
    const double m[3][3] = {{c, -s, 0}, {s, c, 0}, {0, 0, 1}}, back_x = c * x_m, back_y = -s * x_m;

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            room->turn[i][k] = m[i][k];
    add_box(room, back_x, back_x + 3, back_y - 3, back_y, z_m, z_m + 2);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            room->turn[i][k] = i == k;
}

/* 20 x 20 m, 4 m high, seen from within; floor at 0. */
static void make_hall(struct room_scene *room)
{
    const double side[2] = {0, 20}, height[2] = {0, 4};

    room_scene_begin(room);
    room_scene_floor(room, side, side, 4, 0x404040);
    room_scene_quad(room, 0, 0, 1, height, side, 0x606060);
    room_scene_quad(room, 0, 20, -1, height, side, 0x606060);
    room_scene_quad(room, 2, 0, 1, side, height, 0x707070);
    room_scene_quad(room, 2, 20, -1, side, height, 0x707070);
    add_box(room, 8, 9, 0, 0.25, 2, 4);              /* lower than a step */
    add_box(room, 8, 9, 0, 0.3, 5, 7);               /* as high */
    add_box(room, 8, 9, 0, 0.3 + 6 * UNIT_M, 8, 10); /* higher by a little */
    for (int i = 0; i < 6; i++)                      /* stairs up along x */
        add_box(room, 12 + 0.4 * i, 16, 0.25 * i, 0.25 * (i + 1), 2, 4);
    add_box(room, 12, 13, 1.2, 2, 8, 10);    /* too low to go under */
    add_box(room, 12, 13, 1.8, 2.5, 11, 13); /* high enough */
    add_box(room, 5, 5.5, 0, 3, 12, 14);     /* a gap of 0.7 m in z */
    add_box(room, 5, 5.5, 0, 3, 14.7, 15.5);
    add_box(room, 5, 5.5, 0, 3, 16, 18); /* and one of 0.5 m */
    add_slope(room, 15, 14, 30);
    add_slope(room, 15, 17, 60);
}

static int set_up(void **state)
{
    struct stage *stage = calloc(1, sizeof *stage);
    struct room_scene room;
    struct error err;

    make_hall(&room);
    if (!room_scene_compile(&room, PORTALS_OFF, NULL, &stage->in.scene, &err)) fail_msg("%s", err.text);
    room_scene_free(&room);
    solid_stage_begin(&stage->in, 1);
    *state = stage;
    return 0;
}

static int tear_down(void **state)
{
    struct stage *stage = *state;

    solid_stage_end(&stage->in);
    free(stage);
    return 0;
}

static void assert_near(double is, double should, double units)
{
    if (!(fabs(is - should) <= units * UNIT_M)) fail_msg("%.5f m, and not %.5f", is, should);
}

static void it_falls_and_stands(void **state)
{
    struct stage *stage = *state;
    double last_m = 2, last_fall_m = 0;

    put_walker(stage, 3, 2, 3);
    for (int i = 0; i < 30 && !stage->walker.stands; i++) {
        move(stage, 0, 0);
        const double fall_m = last_m - place_m(stage, 1);
        if (!stage->walker.stands) assert_near(fall_m - last_fall_m, 0.01, 0.1);
        last_m = place_m(stage, 1);
        last_fall_m = fall_m;
    }
    assert_true(stage->walker.stands);
    assert_near(place_m(stage, 1), 0.0, 3);
    assert_true(place_m(stage, 1) > 0);
    assert_int_equal(stage->walker.fall_q8, 0);
    const int32_t stood_q8 = stage->walker.at_q8[1];
    walk(stage, 0, 0, 10);
    assert_int_equal(stage->walker.at_q8[1], stood_q8);
}

static void it_jumps(void **state)
{
    struct stage *stage = *state;
    double highest_m = 0;

    put_walker(stage, 3, 0.01, 3);
    walk(stage, 0, 0, 5);
    assert_true(stage->walker.stands);
    stage->walker.fall_q8 = -(int32_t)q8_of(stage, 0.105);
    for (int i = 0; i < 30; i++) {
        move(stage, 0, 0);
        highest_m = fmax(highest_m, place_m(stage, 1));
    }
    assert_near(highest_m, 0.095 + 0.085 + 0.075 + 0.065 + 0.055 + 0.045 + 0.035 + 0.025 + 0.015 + 0.005, 5);
    assert_true(stage->walker.stands);
    stage->walker.fall_q8 = -(int32_t)q8_of(stage, 1); /* against the ceiling */
    for (int i = 0; i < 12; i++)
        move(stage, 0, 0);
    walk(stage, 0, 0, 60);
    assert_true(stage->walker.stands);
}

static void it_stops_at_walls_and_slides_along_them(void **state)
{
    struct stage *stage = *state;

    put_walker(stage, 3, 0.01, 3);
    walk(stage, -1, 0, 100);
    assert_near(place_m(stage, 0), RADIUS_M, 3);
    assert_true(place_m(stage, 0) > RADIUS_M);
    assert_near(place_m(stage, 2), 3, 3);
    const double before_m = place_m(stage, 2);
    walk(stage, -1, 1, 40); /* half of its way is along the wall */
    assert_near(place_m(stage, 0), RADIUS_M, 8);
    assert_near(place_m(stage, 2) - before_m, 40 * STRIDE_M * sqrt(0.5), 40);
    walk(stage, -1, -1, 200); /* into the corner, and it stays there */
    assert_near(place_m(stage, 0), RADIUS_M, 8);
    assert_near(place_m(stage, 2), RADIUS_M, 8);
    walk(stage, -1, -0.2, 50);
    walk(stage, -0.1, -1, 50);
    assert_near(place_m(stage, 0), RADIUS_M, 8);
    assert_near(place_m(stage, 2), RADIUS_M, 8);
}

static void it_climbs_steps_up_to_its_step(void **state)
{
    struct stage *stage = *state;

    walk_from(stage, 6, 3, 50);
    assert_near(place_m(stage, 1), 0.25, 3);
    walk(stage, 1, 0, 40);
    assert_near(place_m(stage, 1), 0, 3);
    assert_near(place_m(stage, 0), 6 + 90 * STRIDE_M, 10);
    walk_from(stage, 6, 6, 50);
    assert_near(place_m(stage, 1), 0.3, 3);
    walk_from(stage, 6, 9, 50);
    assert_near(place_m(stage, 1), 0, 3);
    assert_near(place_m(stage, 0), 8 - RADIUS_M, 3);
}

static void it_climbs_stairs_and_comes_down(void **state)
{
    struct stage *stage = *state;

    walk_from(stage, 11, 3, 1);
    for (int i = 0; i < 70; i++) {
        walk(stage, 1, 0, 1);
        assert_true(stage->walker.stands);
    }
    assert_near(place_m(stage, 1), 1.5, 3);
    assert_near(place_m(stage, 0), 11 + 71 * STRIDE_M, 10);
    for (int i = 0; i < 70; i++) {
        walk(stage, -1, 0, 1);
        assert_true(stage->walker.stands);
    }
    assert_near(place_m(stage, 1), 0, 3);
    put_walker(stage, 15, 1.51, 3); /* over the edge of 1.5 m it falls */
    walk(stage, 1, 0, 1);
    walk(stage, 1, 0, 26);
    assert_false(stage->walker.stands);
    walk(stage, 1, 0, 20);
    assert_true(stage->walker.stands);
    assert_near(place_m(stage, 1), 0, 3);
}

static void it_goes_where_it_fits(void **state)
{
    struct stage *stage = *state;

    walk_from(stage, 10, 9, 100);
    assert_near(place_m(stage, 0), 12 - RADIUS_M, 3); /* its head does not */
    walk_from(stage, 10, 12, 80);
    assert_near(place_m(stage, 0), 14, 10);
    walk_from(stage, 3, 14.35, 80);
    assert_near(place_m(stage, 0), 7, 10);
    walk_from(stage, 3, 15.75, 80);
    assert_near(place_m(stage, 0), 5 - RADIUS_M, 3);
}

static void it_climbs_slopes_that_are_not_steep(void **state)
{
    struct stage *stage = *state;

    walk_from(stage, 13, 15, 80);
    assert_true(place_m(stage, 1) > 0.8);
    assert_true(stage->walker.stands);
    walk_from(stage, 13, 18, 80);
    assert_true(place_m(stage, 1) < STEP_M);
}

static void it_never_stands_still_in_the_open(void **state)
{
    struct stage *stage = *state;
    struct random random = {5};

    put_walker(stage, 3, 0.01, 8);
    walk(stage, 0, 0, 3);
    for (int i = 0; i < 2000; i++) {
        const double angle = random_unit(&random) * 6.2831853, x_m = place_m(stage, 0), z_m = place_m(stage, 2);
        walk(stage, sin(angle), cos(angle), 1);
        if (x_m > 1 && x_m < 4 && z_m > 1 && z_m < 11)
            assert_near(hypot(place_m(stage, 0) - x_m, place_m(stage, 2) - z_m), STRIDE_M, 1);
    }
}

static void what_is_out_of_range_is_refused(void **state)
{
    struct stage *stage = *state;

    put_walker(stage, 3, 0.01, 3);
    const struct lim_walker walker = stage->walker;
    struct lim_walker other = walker;
    assert_int_equal(lim_walker_move(&stage->in.solid, &other, 1 << 20, 0), LIM_ERR_CAMERA);
    assert_memory_equal(&other, &walker, sizeof other);
    other.at_q8[2] = INT32_MAX;
    assert_int_equal(lim_walker_move(&stage->in.solid, &other, 0, 1), LIM_ERR_CAMERA);
    other = walker;
    other.radius_q8 = 0;
    assert_int_equal(lim_walker_move(&stage->in.solid, &other, 1, 0), LIM_ERR_CAMERA);
    other = walker;
    other.step_q8 = other.height_q8;
    assert_int_equal(lim_walker_move(&stage->in.solid, &other, 1, 0), LIM_ERR_CAMERA);
    other = walker;
    other.at_q8[1] = 1 - LIM_BODY_MAX_Q8; /* below everything: it falls out of the range and stays */
    other.fall_q8 = LIM_FALL_MAX_Q8;
    other.at_q8[0] = LIM_BODY_MAX_Q8 - 1;
    assert_int_equal(lim_walker_move(&stage->in.solid, &other, 1, 0), LIM_ERR_CAMERA);
    assert_int_equal(other.at_q8[0], LIM_BODY_MAX_Q8 - 1);
}

/* From a thing of the map to anywhere: closed sectors, so it is in no polygon, ever. */
static void it_is_never_in_a_wall_of_a_level(void **state)
{
    struct stage stage = {0};
    struct random random = {17};
    struct level_camera *cameras;
    struct error err;
    size_t count, moves = 0, in = 0, began_in = 0;
    double gone_m = 0;

    (void)state;
    solid_stage_model(&stage.in, SOLID_E1M1, TREE_BSP, MESH_LEAVES_NONE);
    if (!level_cameras_read(SOLID_E1M1, &cameras, &count, &err)) fail_msg("%s", err.text);
    for (int k = 0; k < effort(60); k++) {
        const struct level_camera *camera = &cameras[(size_t)k * 7 % count];
        double angle = random_unit(&random) * 6.2831853;
        put_walker(&stage, camera->eye_m[0], camera->eye_m[1] - 1.2, camera->eye_m[2]);
        if (is_walker_in(&stage)) {
            began_in++;
            continue;
        }
        for (int i = 0; i < 150; i++) {
            const double x_m = place_m(&stage, 0), z_m = place_m(&stage, 2), stride_m = 0.3;
            if (lim_walker_move(&stage.in.solid, &stage.walker, (int32_t)q8_of(&stage, stride_m * sin(angle)),
                                (int32_t)q8_of(&stage, stride_m * cos(angle))))
                fail_msg("it left the range");
            const double way_m = hypot(place_m(&stage, 0) - x_m, place_m(&stage, 2) - z_m);
            gone_m += way_m;
            moves++;
            in += is_walker_in(&stage);
            if (way_m < 0.1) angle = random_unit(&random) * 6.2831853;
        }
    }
    printf("# %zu moves in E1M1, %.0f m, %zu in walls; %zu places too narrow to begin\n", moves, gone_m, in, began_in);
    assert_int_equal(in, 0);
    assert_true(moves > (size_t)effort(30) * 150);
    free(cameras);
    solid_stage_end(&stage.in);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_falls_and_stands),
        cmocka_unit_test(it_jumps),
        cmocka_unit_test(it_stops_at_walls_and_slides_along_them),
        cmocka_unit_test(it_climbs_steps_up_to_its_step),
        cmocka_unit_test(it_climbs_stairs_and_comes_down),
        cmocka_unit_test(it_goes_where_it_fits),
        cmocka_unit_test(it_climbs_slopes_that_are_not_steep),
        cmocka_unit_test(it_never_stands_still_in_the_open),
        cmocka_unit_test(what_is_out_of_range_is_refused),
        cmocka_unit_test(it_is_never_in_a_wall_of_a_level),
    };

    return cmocka_run_group_tests_name("walker moves", tests, set_up, tear_down);
}
