/* SPDX-License-Identifier: MIT
 *
 * Dense objects that move as mesh leaves, and what moves around a mesh leaf that stands still: before, behind and
 * astride a wall, in a doorway, through one another, against the reference. */
#include "core/core.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mover_rig.h"
#include "rigs/tiny_model.h"

#include <math.h>

#define PI 3.14159265358979323846

enum { RINGS = 12, AROUND = 20, BALL_FACES = 2 * AROUND * (RINGS - 1) };

static const double UPRIGHT[3] = {0, 1, 0}, SLANTED[3] = {0.3, 1, 0.2};

static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_SCANLINE};
enum { ORDERS = sizeof orders / sizeof *orders };

/* Whose dense parts are mesh leaves. */
static void add_rooms(struct mover_rig *rig, bool doorway)
{
    rig->mesh_leaves = MESH_LEAVES_ALL;
    mover_rig_add_rooms(rig, doorway);
}

static void ball_point(double radius_m, const double at_m[3], int ring, int turn, double out[3])
{
    const double up = PI * ring / RINGS, around = 2 * PI * turn / AROUND, r = radius_m * (1 + 0.1 * sin(3 * around));

    out[0] = at_m[0] + r * sin(up) * sin(around);
    out[1] = at_m[1] + r * cos(up);
    out[2] = at_m[2] + r * sin(up) * cos(around);
}

/* A dented ball of BALL_FACES triangles. */
static void add_ball(struct model *model, double radius_m, const double at_m[3])
{
    for (int i = 0; i < RINGS; i++)
        for (int j = 0; j < AROUND; j++) {
            const int next = (j + 1) % AROUND;
            double lower[3][3], upper[3][3];
            ball_point(radius_m, at_m, i, j, lower[0]);
            ball_point(radius_m, at_m, i + 1, j, lower[1]);
            ball_point(radius_m, at_m, i + 1, next, lower[2]);
            memcpy(upper[0], lower[0], sizeof *upper);
            memcpy(upper[1], lower[2], sizeof *upper);
            ball_point(radius_m, at_m, i, next, upper[2]);
            if (i + 1 < RINGS) tiny_add(model, 3, (const double(*)[3])lower);
            if (i) tiny_add(model, 3, (const double(*)[3])upper);
        }
}

static void add_moving_ball(struct mover_rig *rig, double radius_m, const struct model_pose *pose)
{
    add_ball(&rig->model, radius_m, (const double[3]){0, 0, 0});
    mover_rig_moves(rig, pose);
}

static void assert_is_leaf(const struct mover_rig *rig, size_t mover)
{
    const struct lim_scene *object = &rig->moving.objects[mover].scene.scene;

    assert_int_equal(object->node_count, 1);
    assert_true(object->limits.leaf_polygons > 0 && object->limits.leaf_vertices > 0);
    assert_int_equal(object->polygon_count, BALL_FACES);
}

static void view_around(struct mover_rig *rig, double away_m, double high_m)
{
    for (int i = 0; i < 12; i++) {
        const double angle = i * PI / 6 + 0.1;
        mover_rig_view(rig, (double[3]){away_m * sin(angle), high_m, away_m * cos(angle)}, (double[3]){0, 1, 0});
    }
}

/* A ball of 60 cm at z, in a closed half of the room, seen from z = 3. */
static size_t ball_pixels(enum lim_method method, double z_m)
{
    struct mover_rig rig = {0};
    const struct model_pose pose = mover_rig_pose(0.3, 1.2, z_m, SLANTED, 0.4);

    add_rooms(&rig, false);
    add_moving_ball(&rig, 0.3, &pose);
    mover_rig_compile(&rig, method, NULL);
    assert_is_leaf(&rig, 0);
    mover_rig_view(&rig, (double[3]){-0.6, 1.9, 3}, (double[3]){0, 1.2, 0});
    const size_t pixels = mover_rig_pixels(&rig, 1);
    mover_rig_assert_right(&rig, 500);
    mover_rig_free(&rig);
    return pixels;
}

static void a_wall_hides_it_or_cuts_it(void **state)
{
    (void)state;
    for (int m = 0; m < ORDERS; m++) {
        const size_t before = ball_pixels(orders[m], 1), astride = ball_pixels(orders[m], 0);
        assert_true(before > 500);
        assert_true(astride > 100 && astride < before);
        assert_int_equal(ball_pixels(orders[m], -1), 0);
    }
}

static void in_a_doorway_it_is_seen_from_both_sides(void **state)
{
    (void)state;
    for (int m = 0; m < ORDERS; m++) {
        struct mover_rig rig = {0};
        const struct model_pose pose = mover_rig_pose(0.3, 1, 0.05, SLANTED, 0.7);
        add_rooms(&rig, true);
        add_moving_ball(&rig, 0.45, &pose); /* reaches into the door's post */
        mover_rig_compile(&rig, orders[m], NULL);
        assert_is_leaf(&rig, 0);
        view_around(&rig, 3, 1.6);
        mover_rig_assert_right(&rig, 500);
        mover_rig_free(&rig);
    }
}

/* No plane parts them: their polygons are compared one by one, line by line. */
static void through_one_another_each_is_where_it_is(void **state)
{
    (void)state;
    for (int m = 0; m < ORDERS; m++) {
        struct mover_rig rig = {0};
        const struct model_pose one = mover_rig_pose(0, 1.2, 1.5, SLANTED, 0.9);
        const struct model_pose two = mover_rig_pose(0.05, 1.2, 1.5, SLANTED, 2.5);
        add_rooms(&rig, true);
        add_moving_ball(&rig, 0.3, &one);
        mover_rig_add_box(&rig, 0.7, 0.12, 0.1, &two);
        mover_rig_compile(&rig, orders[m], NULL);
        assert_is_leaf(&rig, 0);
        for (int i = 0; i < 6; i++)
            mover_rig_view(&rig, (double[3]){2 * sin(i + 0.1), 1.6, 1.5 + 2 * cos(i + 0.1)}, (double[3]){0, 1.2, 1.5});
        mover_rig_assert_right(&rig, 1000);
        mover_rig_free(&rig);
    }
}

/* A plane parts their boxes, or their middles tell. */
static void around_a_leaf_that_stands_still_they_are_before_or_behind(void **state)
{
    static const double places[][3] = {{0.9, 0.8, 2}, {-0.9, 1.2, 2.1}, {0, 1.9, 2}, {0.1, 0.8, 2.9}, {-0.2, 0.8, 1}};
    (void)state;
    for (int m = 0; m < ORDERS; m++)
        for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
            struct mover_rig rig = {0};
            const struct model_pose pose = mover_rig_pose(places[i][0], places[i][1], places[i][2], UPRIGHT, 0.3);
            add_rooms(&rig, true);
            add_ball(&rig.model, 0.5, (const double[3]){0, 0.8, 2});
            mover_rig_stands(&rig);
            mover_rig_add_box(&rig, 0.2, 0.2, 0.2, &pose);
            mover_rig_compile(&rig, orders[m], NULL);
            assert_true(rig.scene.scene.limits.leaf_polygons > 0);
            for (int k = 0; k < 8; k++)
                mover_rig_view(&rig, (double[3]){1.9 * sin(k + 0.1), 1.5, 2 + 1.9 * cos(k + 0.1)},
                               (double[3]){0, 0.9, 2});
            mover_rig_assert_right(&rig, 500);
            mover_rig_free(&rig);
        }
}

/* It is left out, and said so; and with room for few of its polygons at once the picture is the same. */
static void room_for_too_few(void **state)
{
    struct mover_rig rig = {0};
    const struct model_pose pose = mover_rig_pose(0.3, 1.2, 1, SLANTED, 0.4);
    (void)state;

    add_rooms(&rig, false);
    add_moving_ball(&rig, 0.3, &pose);
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
    struct lim_movers_limits limits = rig.moving.limits;
    limits.leaf_polygons = 7;
    mover_rig_limit(&rig, &limits);
    mover_rig_view(&rig, (double[3]){-0.6, 1.9, 3}, (double[3]){0, 1.2, 0});
    assert_true(mover_rig_pixels(&rig, 1) > 500);
    mover_rig_assert_right(&rig, 500);
    limits.leaf_vertices--;
    mover_rig_limit(&rig, &limits);
    mover_rig_view(&rig, (double[3]){-0.6, 1.9, 3}, (double[3]){0, 1.2, 0});
    assert_int_equal(mover_rig_pixels(&rig, 1), 0);
    assert_int_equal(mover_rig_stats(&rig)->movers.left_out, 1);
    mover_rig_free(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wall_hides_it_or_cuts_it),
        cmocka_unit_test(in_a_doorway_it_is_seen_from_both_sides),
        cmocka_unit_test(through_one_another_each_is_where_it_is),
        cmocka_unit_test(around_a_leaf_that_stands_still_they_are_before_or_behind),
        cmocka_unit_test(room_for_too_few),
    };

    return cmocka_run_group_tests_name("mesh_movers", tests, NULL, NULL);
}
