/* SPDX-License-Identifier: MIT
 *
 * Doors and lifts of small maps: which faces move, how far and how fast. The numbers are worked out by hand. */
#include "levels/level_import.h"
#include "levels/level_moves.h"
#include "model/model_part.h"
#include "model/pose.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "unit/levels/level_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEEP = 128, DOOR_W = 16, RAYS = 400 };

static int begin(void **state)
{
    level_doors_set(LEVEL_DOORS_MOVE);
    return level_begin(state);
}

/* Three rooms in a row along x: from 0 to 128, to 144, to 272; returns the line between the first two, whose right is
 * the first. */
static unsigned three_rooms(unsigned first, unsigned between, unsigned last)
{
    static const int at_x[] = {0, DEEP, DEEP + DOOR_W, 2 * DEEP + DOOR_W};
    const unsigned rooms[] = {first, between, last};
    for (unsigned i = 0; i < 4; i++) {
        wad_vertex(&level_map, at_x[i], 0);
        wad_vertex(&level_map, at_x[i], DEEP);
    }
    level_border(0, 1, first, WAD_NO_SIDE);
    for (unsigned i = 0; i < 3; i++) {
        level_border(2 * i + 1, 2 * i + 3, rooms[i], WAD_NO_SIDE);
        level_border(2 * i + 2, 2 * i, rooms[i], WAD_NO_SIDE);
    }
    level_border(7, 6, last, WAD_NO_SIDE);
    const unsigned line = level_border(3, 2, first, between);
    level_border(5, 4, between, last);
    return line;
}

/* Shut, behind a line that opens it by hand; the rooms are 128 and 160 high. */
static unsigned door(unsigned special)
{
    const unsigned first = wad_sector(&level_map, 0, 128, 255, "FLOOR", "CEIL");
    const unsigned between = wad_sector(&level_map, 0, 0, 255, "FLOOR", "CEIL");
    const unsigned last = wad_sector(&level_map, 0, 160, 255, "FLOOR", "CEIL");
    const unsigned line = three_rooms(first, between, last);
    level_map.lines[line][3] = (uint16_t)special;
    return line;
}

static size_t count_faces(const struct model *model, uint16_t mover)
{
    size_t count = 0;
    for (size_t i = 0; i < model->face_count; i++)
        count += model->faces[i].mover == mover;
    return count;
}

static void assert_near(double is, double should)
{
    if (!(fabs(is - should) < 1e-9)) fail_msg("%.12g, not %.12g", is, should);
}

/* How high above its rest the first mover is. */
static double height_at(const struct model *model, double time_s)
{
    return 32 * (pose_at(model, &model->movers[0], time_s).at_m[1] - model->movers[0].rest.at_m[1]);
}

/* Doors -------------------------------------------------------------------------------------- */

static void a_door_is_two_sides_and_what_is_below(void **state)
{
    (void)state;
    door(1);
    struct model model = level_saved();
    assert_int_equal(model.mover_count, 1);
    assert_int_equal(model.movers[0].kind, MODEL_DOOR);
    assert_string_equal(model.movers[0].name, "door of sector 1");
    assert_int_equal(count_faces(&model, 1), 3);
    const struct model_face *west = level_need_wall(&model, -1, 0, 0, 124),
                            *east = level_need_wall(&model, 1, 0, 0, 124);
    assert_int_equal(west->mover, 1);
    assert_int_equal(east->mover, 1);
    assert_true(level_corner_at(&model, west, 0)[0] == (DEEP + LEVEL_MOVE_SLACK) / 32.0);
    assert_true(level_corner_at(&model, east, 0)[0] == (DEEP + DOOR_W - LEVEL_MOVE_SLACK) / 32.0);
    model_free(&model);
}

/* The lintel is four units high, and its texture goes on where that of the shut door ends. */
static void what_is_above_an_open_door_stays(void **state)
{
    (void)state;
    door(1);
    struct model model = level_saved();
    const struct model_face *lintel = level_need_wall(&model, -1, 0, 124, 128);
    const struct model_face *side = level_need_wall(&model, -1, 0, 0, 124);
    assert_int_equal(lintel->mover, 0);
    assert_true(level_uv(&model, lintel, 0)[1] == 4 / 128.0); /* from its lower end on */
    assert_true(level_uv(&model, side, 0)[1] == 1);           /* the texture hangs 128 above the floor */
    assert_true(level_uv(&model, side, 2)[1] == 4 / 128.0);
    level_need_wall(&model, 1, 0, 124, 160);
    level_need_wall(&model, 0, -1, 0, 124); /* beside the door */
    model_free(&model);
}

static void a_door_goes_up_two_units_a_tic_waits_and_comes_down(void **state)
{
    (void)state;
    door(1);
    struct model model = level_saved();
    const double way_s = 124 / 2.0 / 35, wait_s = 150 / 35.0, high = 124 + LEVEL_MOVE_SLACK;
    assert_int_equal(model.movers[0].key_count, 5);
    assert_near(height_at(&model, 0), 0);
    assert_near(height_at(&model, way_s / 2), high / 2);
    assert_near(height_at(&model, way_s), high);
    assert_near(height_at(&model, way_s + wait_s), high);
    assert_near(height_at(&model, way_s + wait_s + way_s / 4), high * 3 / 4);
    assert_near(height_at(&model, 2 * way_s + wait_s), 0);
    assert_near(model.keys[4].time_s, 2 * way_s + wait_s + 2);
    model_free(&model);
}

static void fast_doors_are_four_times_as_fast(void **state)
{
    (void)state;
    door(117);
    struct model model = level_saved();
    assert_near(model.keys[model.movers[0].first_key + 1].time_s, 124 / 8.0 / 35);
    model_free(&model);
}

static void closed_doors_are_the_walls_around(void **state)
{
    (void)state;
    level_doors_set(LEVEL_DOORS_CLOSED);
    door(1);
    struct model model = level_saved();
    assert_int_equal(model.mover_count, 0);
    assert_int_equal(model.face_count, 12);
    assert_int_equal(level_need_wall(&model, -1, 0, 0, 128)->mover, 0);
    model_free(&model);
}

static void open_doors_are_doorways(void **state)
{
    (void)state;
    level_doors_set(LEVEL_DOORS_OPEN);
    door(1);
    struct model model = level_saved();
    assert_int_equal(model.mover_count, 0);
    assert_null(level_wall(&model, -1, 0, 0, 124));
    level_need_wall(&model, -1, 0, 124, 128);
    model_free(&model);
}

/* Of a line whose special is another, of a door that has nowhere to go, of the sky. */
static void other_sectors_stay(void **state)
{
    (void)state;
    door(11);
    struct model model = level_saved();
    assert_int_equal(model.mover_count, 0);
    model_free(&model);
    level_begin(NULL);
    door(1);
    level_map.sectors[0].ceiling = 4;
    model = level_saved();
    assert_int_equal(model.mover_count, 0);
    model_free(&model);
    level_begin(NULL);
    door(1);
    memcpy(level_map.sectors[1].names[1], "F_SKY1\0", 8);
    model = level_saved();
    assert_int_equal(model.mover_count, 0);
    model_free(&model);
}

static void tagged_doors_are_found_by_their_tag(void **state)
{
    (void)state;
    const unsigned line = door(0);
    level_map.lines[(line + 1) % level_map.line_count][3] = 63;
    level_map.lines[(line + 1) % level_map.line_count][4] = 7;
    level_map.sectors[1].tag = 7;
    struct model model = level_saved();
    assert_int_equal(model.mover_count, 1);
    assert_string_equal(model.movers[0].name, "door of sector 1");
    model_free(&model);
}

/* What the room's floor hides of a shut door is seen below it when it goes up. */
static void a_door_has_all_of_its_sides(void **state)
{
    (void)state;
    door(1);
    level_map.sectors[0].floor = 24;
    struct model model = level_saved();
    assert_int_equal(level_need_wall(&model, -1, 0, 0, 124)->mover, 1);
    model_free(&model);
}

/* Lifts -------------------------------------------------------------------------------------- */

/* Up at 64, between floors at 0 and 64. */
static void lift(void)
{
    const unsigned first = wad_sector(&level_map, 0, 192, 255, "FLOOR", "CEIL");
    const unsigned between = wad_sector(&level_map, 64, 192, 255, "FLOOR", "CEIL");
    const unsigned last = wad_sector(&level_map, 64, 192, 255, "FLOOR", "CEIL");
    const unsigned line = three_rooms(first, between, last);
    level_map.lines[line][3] = 62;
    level_map.lines[line][4] = 9;
    level_map.sectors[between].tag = 9;
}

static void a_lift_is_its_top_and_the_sides_that_show(void **state)
{
    (void)state;
    lift();
    struct model model = level_saved();
    assert_int_equal(model.mover_count, 1);
    assert_int_equal(model.movers[0].kind, MODEL_LIFT);
    assert_int_equal(count_faces(&model, 1), 2);
    assert_int_equal(level_need_wall(&model, -1, 0, 0, 64)->mover, 1);
    model_free(&model);
}

static void a_lift_goes_down_four_units_a_tic_waits_and_comes_up(void **state)
{
    (void)state;
    lift();
    struct model model = level_saved();
    const double way_s = 64 / 4.0 / 35, wait_s = 105 / 35.0, low = -64 - LEVEL_MOVE_SLACK;
    assert_near(height_at(&model, way_s / 2), low / 2);
    assert_near(height_at(&model, way_s + wait_s / 2), low);
    assert_near(height_at(&model, 2 * way_s + wait_s), 0);
    model_free(&model);
}

/* Likewise what a ceiling hides of a lift. */
static void a_lift_has_all_of_its_sides(void **state)
{
    (void)state;
    lift();
    level_map.sectors[0].ceiling = 48;
    struct model model = level_saved();
    assert_int_equal(level_need_wall(&model, -1, 0, 0, 64)->mover, 1);
    model_free(&model);
}

/* Coordinates are the map's, as where nothing moves: none of what stands still is rounded. */
static void what_stands_still_is_on_the_maps_lattice(void **state)
{
    (void)state;
    uint32_t *numbers;
    struct model part;
    door(1);
    struct model model = level_saved();
    model_part(&model, 0, true, &part, &numbers);
    assert_true(part.is_interior && part.lattice_m == model.lattice_m && part.lattice_m == 1 / 32.0);
    free(numbers);
    model_free(&part);
    model_free(&model);
}

/* Nothing is open where doors and lifts move away: not in any of the rooms, with and without what moves. */
static void what_stands_still_is_closed(void **state)
{
    (void)state;
    static const double eyes_m[][3] = {{2, 3, -2}, {4.25, 3.0, -2}, {6, 3, -2}};
    struct random random = {5};
    for (int doors = LEVEL_DOORS_OPEN; doors <= LEVEL_DOORS_MOVE; doors++)
        for (int is_lift = 0; is_lift < 2; is_lift++) {
            level_doors_set((enum level_doors)doors);
            level_begin(NULL);
            if (is_lift)
                lift();
            else
                door(1);
            struct model model = level_saved();
            for (int i = 0; i < 3; i++)
                assert_true((doors == LEVEL_DOORS_MOVE && !is_lift && i == 1) ||
                            level_is_closed(&model, eyes_m[i], RAYS, &random));
            model_free(&model);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_door_is_two_sides_and_what_is_below, begin),
        cmocka_unit_test_setup(what_is_above_an_open_door_stays, begin),
        cmocka_unit_test_setup(a_door_goes_up_two_units_a_tic_waits_and_comes_down, begin),
        cmocka_unit_test_setup(fast_doors_are_four_times_as_fast, begin),
        cmocka_unit_test_setup(closed_doors_are_the_walls_around, begin),
        cmocka_unit_test_setup(open_doors_are_doorways, begin),
        cmocka_unit_test_setup(other_sectors_stay, begin),
        cmocka_unit_test_setup(tagged_doors_are_found_by_their_tag, begin),
        cmocka_unit_test_setup(a_lift_is_its_top_and_the_sides_that_show, begin),
        cmocka_unit_test_setup(a_lift_goes_down_four_units_a_tic_waits_and_comes_up, begin),
        cmocka_unit_test_setup(a_door_has_all_of_its_sides, begin),
        cmocka_unit_test_setup(a_lift_has_all_of_its_sides, begin),
        cmocka_unit_test_setup(what_stands_still_is_on_the_maps_lattice, begin),
        cmocka_unit_test_setup(what_stands_still_is_closed, begin),
    };
    return cmocka_run_group_tests(tests, level_enter, level_leave);
}
