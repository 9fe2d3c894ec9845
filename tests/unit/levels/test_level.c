/* SPDX-License-Identifier: MIT
 *
 * Maps of small WADs as models: where floors, ceilings, walls and cameras are. The numbers are worked out by hand from
 * the format's description. */
#include "levels/level_cameras.h"
#include "levels/level_import.h"
#include "levels/level_path.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random.h"
#include "unit/levels/level_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* In square metres, of what looks up (1), down (-1). */
static double level_area(const struct model *model, int up)
{
    double sum = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        double normal[3];
        level_normal(model, &model->faces[i], normal);
        if (normal[1] * up > 0) sum += fabs(normal[1]) / 2;
    }
    return sum;
}

/* Edges of closed surfaces are there once each way, but for corners that lie on other edges. */
static void assert_edges_pair(const struct model *model)
{
    for (size_t i = 0; i < model->face_count; i++)
        for (uint32_t k = 0; k < model->faces[i].count; k++) {
            const double *a = level_corner_at(model, &model->faces[i], k),
                         *b = level_corner_at(model, &model->faces[i], k + 1);
            size_t there = 0;
            for (size_t j = 0; j < model->face_count; j++)
                for (uint32_t m = 0; m < model->faces[j].count; m++)
                    there += memcmp(level_corner_at(model, &model->faces[j], m), b, 3 * sizeof *b) == 0 &&
                             memcmp(level_corner_at(model, &model->faces[j], m + 1), a, 3 * sizeof *a) == 0;
            assert_int_equal(there, 1);
        }
}

/* Sectors ------------------------------------------------------------------------------------ */

static void a_room_is_a_closed_box_in_metres_with_y_up(void **state)
{
    (void)state;
    wad_room(&level_map, 64, 32, 256, wad_sector(&level_map, -32, 96, 255, "FLOOR", "CEIL"));
    struct model model = level_saved();
    assert_int_equal(model.face_count, 6);
    assert_edges_pair(&model);
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, volume6 = 0;
    for (size_t i = 0; i < model.face_count; i++) {
        double normal[3];
        level_normal(&model, &model.faces[i], normal);
        for (int axis = 0; axis < 3; axis++) {
            volume6 += normal[axis] * level_corner_at(&model, &model.faces[i], 0)[axis];
            for (uint32_t k = 0; k < model.faces[i].count; k++) {
                low[axis] = fmin(low[axis], level_corner_at(&model, &model.faces[i], k)[axis]);
                high[axis] = fmax(high[axis], level_corner_at(&model, &model.faces[i], k)[axis]);
            }
        }
        assert_true(model.faces[i].unlit);
    }
    const double lows[3] = {2, -1, -9}, highs[3] = {10, 3, -1}; /* north is -z */
    assert_memory_equal(low, lows, sizeof low);
    assert_memory_equal(high, highs, sizeof high);
    assert_true(volume6 / 6 == -8.0 * 4 * 8); /* seen from within */
    assert_true(model.lattice_m == 1.0 / 32);
    model_free(&model);
}

static void sectors_and_pillars_within_a_sector_are_left_out_of_it(void **state)
{
    (void)state;
    const unsigned outer = wad_sector(&level_map, 0, 128, 255, "FLOOR", "CEIL");
    const unsigned inner = wad_sector(&level_map, 24, 128, 255, "FLOOR", "CEIL");
    wad_room(&level_map, 0, 0, 320, outer);
    level_square(64, 64, 64, outer, WAD_NO_SIDE);
    level_square(192, 160, 64, outer, inner);
    struct model model = level_saved();
    assert_true(level_area(&model, 1) == 10.0 * 10 - 2 * 2);
    assert_true(level_area(&model, -1) == 10.0 * 10 - 2 * 2);
    level_need_wall(&model, 1, 0, 0, 24); /* the platform's steps */
    level_need_wall(&model, 0, -1, 0, 24);
    assert_null(level_wall(&model, 1, 0, 24, 128));
    model_free(&model);
}

enum { CELLS = 4, CELL = 64 };

/* How much a point lies to the left of a -> b. */
static double left_of(const double a[2], const double b[2], const double p[2])
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

static bool is_over(const struct model *model, const struct model_face *face, const double p[2])
{
    for (uint32_t k = 0; k < face->count; k++) {
        const double *a = level_corner_at(model, face, k), *b = level_corner_at(model, face, k + 1);
        const double from[2] = {a[0], -a[2]}, to[2] = {b[0], -b[2]};
        if (left_of(from, to, p) < 0) return false;
    }
    return true;
}

static void make_cells(struct random *random, double places[CELLS + 1][CELLS + 1][2])
{
    unsigned vertices[CELLS + 1][CELLS + 1];
    for (int x = 0; x <= CELLS; x++)
        for (int y = 0; y <= CELLS; y++) {
            const int at[2] = {x * CELL + (int)random_in(random, -20, 20), y * CELL + (int)random_in(random, -20, 20)};
            vertices[x][y] = wad_vertex(&level_map, at[0], at[1]);
            places[x][y][0] = at[0] / 32.0;
            places[x][y][1] = at[1] / 32.0;
        }
    for (int i = 0; i < CELLS * CELLS; i++)
        wad_sector(&level_map, i, 200, 255, "FLOOR", "CEIL");
    for (int i = 0; i <= CELLS; i++)
        for (int k = 0; k < CELLS; k++) {
            const unsigned after = i<CELLS, before = i> 0;
            level_border(vertices[i][k], vertices[i][k + 1], after ? (unsigned)(i * CELLS + k) : WAD_NO_SIDE,
                         before ? (unsigned)((i - 1) * CELLS + k) : WAD_NO_SIDE);
            level_border(vertices[k][i], vertices[k + 1][i], before ? (unsigned)(k * CELLS + i - 1) : WAD_NO_SIDE,
                         after ? (unsigned)(k * CELLS + i) : WAD_NO_SIDE);
        }
}

/* Of a cell, whose sides need not be convex: by a ray to the east. */
static bool is_in_cell(double places[CELLS + 1][CELLS + 1][2], int x, int y, const double p[2])
{
    const double *corners[4] = {places[x][y], places[x + 1][y], places[x + 1][y + 1], places[x][y + 1]};
    bool is_in = false;
    for (int k = 0; k < 4; k++) {
        const double *a = corners[k], *b = corners[(k + 1) % 4];
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]))
            is_in = !is_in;
    }
    return is_in;
}

static void assert_floor_at(const struct model *model, double places[CELLS + 1][CELLS + 1][2], const double p[2])
{
    int expected = -1, found = -1;
    for (int i = 0; i < CELLS * CELLS; i++)
        if (is_in_cell(places, i / CELLS, i % CELLS, p)) expected = i;
    for (size_t i = 0; i < model->face_count; i++) {
        double normal[3];
        level_normal(model, &model->faces[i], normal);
        if (!(normal[1] > 0) || !is_over(model, &model->faces[i], p)) continue;
        assert_int_equal(found, -1);
        found = (int)(level_corner_at(model, &model->faces[i], 0)[1] * 32);
    }
    assert_int_equal(found, expected);
}

static void each_place_has_the_floor_of_its_sector_and_no_other(void **state)
{
    struct random random = {7};
    for (int run = 0; run < effort(20); run++) {
        double places[CELLS + 1][CELLS + 1][2];
        level_begin(state);
        make_cells(&random, places);
        struct model model = level_saved();
        for (int i = 0; i < 400; i++) {
            const double p[2] = {random_unit(&random) * 10 - 1, random_unit(&random) * 10 - 1};
            assert_floor_at(&model, places, p);
        }
        model_free(&model);
    }
}

/* What lines do not say ----------------------------------------------------------------------- */

static void assert_closed_from(const struct model *model, double x, double y, double height)
{
    struct random random = {3};
    const double eye[3] = {x / 32, height / 32, -y / 32};
    if (!level_is_closed(model, eye, effort(2000), &random)) fail_msg("a hole");
}

/* Deep water and bridges: the lines round a sector name it on both sides. */
static void a_sector_within_its_own_lines_has_walls_round_it(void **state)
{
    (void)state;
    const unsigned outer = wad_sector(&level_map, 0, 128, 255, "FLOOR", "CEIL");
    const unsigned inner = wad_sector(&level_map, 24, 100, 255, "FLOOR", "CEIL");
    struct model model;
    struct error err;
    wad_room(&level_map, 0, 0, 320, outer);
    level_square(128, 128, 64, inner, inner);
    level_save("MAP01");
    if (!level_import("a.wad:MAP01", true, &model, &err)) fail_msg("%s", err.text);
    assert_string_equal(model.notice, "lines that name a sector which is not there: 4, LINEDEFS 4 among them");
    assert_true(level_area(&model, 1) == 100);
    level_need_wall(&model, 1, 0, 0, 24);
    level_need_wall(&model, 1, 0, 100, 128);
    assert_closed_from(&model, 20, 30, 41);
    assert_closed_from(&model, 160, 170, 60);
    model_free(&model);
}

/* Towards what is outside the sectors end somewhere, and are closed there. */
static void a_sector_that_is_open_is_closed_where_it_ends(void **state)
{
    (void)state;
    struct model model;
    struct error err;
    wad_room(&level_map, 0, 0, 320, wad_sector(&level_map, 0, 128, 255, "FLOOR", "CEIL"));
    level_map.line_count--;
    level_save("MAP01");
    if (!level_import("a.wad:MAP01", true, &model, &err)) fail_msg("%s", err.text);
    assert_string_equal(model.notice, "sectors that no lines close: 1, SECTORS 0 among them; they end somewhere");
    assert_closed_from(&model, 20, 160, 41);
    model_free(&model);
}

/* A line of one side within a sector, and one with the same sector on both sides. */
static void lines_within_a_sector_are_walls_or_hold_what_hangs(void **state)
{
    (void)state;
    const unsigned room = wad_sector(&level_map, 0, 128, 255, "FLOOR", "CEIL");
    struct model model;
    struct error err;
    wad_room(&level_map, 0, 0, 320, room);
    wad_vertex(&level_map, 100, 100);
    wad_vertex(&level_map, 100, 200);
    wad_vertex(&level_map, 150, 200);
    wad_line(&level_map, 4, 5, 0, wad_side(&level_map, room, "-", "-", "WALL"), WAD_NO_SIDE);
    wad_line(&level_map, 5, 6, 0, wad_side(&level_map, room, "-", "-", "GRATE"),
             wad_side(&level_map, room, "-", "-", "-"));
    level_save("MAP01");
    if (!level_import("a.wad:MAP01", true, &model, &err)) fail_msg("%s", err.text);
    assert_string_equal(model.notice, "lines that name a sector which is not there: 1, LINEDEFS 4 among them");
    assert_true(level_area(&model, 1) == 100);
    size_t walls = 0;
    for (size_t i = 0; i < model.face_count; i++) {
        double normal[3];
        level_normal(&model, &model.faces[i], normal);
        walls += normal[1] == 0;
    }
    assert_int_equal(walls, 4 + 2 + 1);      /* from both sides the one line, from its own what hangs */
    level_need_wall(&model, 0, 1, 120, 128); /* the grate */
    model_free(&model);
}

/* What has no height ------------------------------------------------------------------------- */

static void a_closed_door_is_the_walls_round_it(void **state)
{
    (void)state;
    const unsigned hall = wad_sector(&level_map, 0, 128, 255, "FLOOR", "CEIL");
    wad_room(&level_map, 0, 0, 320, hall);
    level_square(128, 128, 64, hall, wad_sector(&level_map, 0, 0, 255, "FLOOR", "CEIL"));
    struct model model = level_saved();
    assert_true(level_area(&model, 1) == 10.0 * 10 - 2 * 2);
    const double sides[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    size_t walls = 0;
    for (size_t i = 0; i < model.face_count; i++) {
        double normal[3];
        level_normal(&model, &model.faces[i], normal);
        walls += normal[1] == 0;
    }
    assert_int_equal(walls, 8); /* none is seen from within the door */
    for (int i = 0; i < 4; i++)
        level_need_wall(&model, sides[i][0], sides[i][1], 0, 128);
    model_free(&model);
}

/* Files and cameras ---------------------------------------------------------------------------- */

static void a_later_wad_takes_the_place_of_maps_and_textures(void **state)
{
    (void)state;
    wad_room(&level_map, 0, 0, 96, wad_sector(&level_map, 0, 96, 255, "FLOOR", "CEIL"));
    level_save("MAP01");
    level_begin(NULL);
    wad_room(&level_map, 0, 0, 96, wad_sector(&level_map, 0, 48, 255, "FLOOR", "CEIL"));
    wad_begin(&level_wad, "PWAD");
    wad_write_map(&level_wad, "MAP01", &level_map);
    wad_end(&level_wad);
    wad_save(&level_wad, "b.wad");
    struct model model = level_imported("a.wad:MAP01", true);
    level_need_wall(&model, 1, 0, 0, 96);
    model_free(&model);
    model = level_imported("a.wad+b.wad:map01", true);
    level_need_wall(&model, 1, 0, 0, 48);
    assert_int_equal(model.picture_count, 2);
    model_free(&model);
}

static void paths_name_wads_and_maps(void **state)
{
    (void)state;
    struct level_path path;
    char name[16], file[WAD_PATH_B];
    assert_false(level_path_parse("house.obj", &path));
    assert_false(level_path_parse("a.wad:b/house.obj", &path));
    assert_true(level_path_parse("x/Doom.WAD+y+z.wad+w.wad:e1m1", &path));
    assert_string_equal(path.map, "E1M1");
    assert_string_equal(wad_path_at(path.files, 0, file), "x/Doom.WAD");
    assert_string_equal(wad_path_at(path.files, 1, file), "y+z.wad");
    assert_string_equal(wad_path_at(path.files, 2, file), "w.wad");
    assert_null(wad_path_at(path.files, 3, file));
    assert_true(level_path_parse("doom.wad", &path));
    assert_string_equal(path.map, "");
    assert_int_equal(level_path_stem("x/doom.wad:MAP01", name, sizeof name), 5);
    assert_string_equal(name, "MAP01");
    level_path_stem("x.y/hall.obj", name, sizeof name);
    assert_string_equal(name, "hall");
}

static void players_come_first_and_things_without_room_not_at_all(void **state)
{
    (void)state;
    struct level_camera *cameras;
    struct error err;
    size_t count = 0;
    const unsigned hall = wad_sector(&level_map, 16, 128, 255, "FLOOR", "CEIL");
    wad_room(&level_map, 0, 0, 320, hall);
    level_square(128, 128, 64, hall, wad_sector(&level_map, 16, 16 + 41, 255, "FLOOR", "CEIL"));
    wad_thing(&level_map, 32, 64, 90, 3001);
    wad_thing(&level_map, 160, 160, 0, 2001); /* too low */
    wad_thing(&level_map, 900, 900, 0, 2001); /* outside */
    wad_thing(&level_map, 64, 32, 180, 1);
    level_save("MAP01");
    if (!level_cameras_read("a.wad:MAP01", &cameras, &count, &err)) fail_msg("%s", err.text);
    assert_int_equal(count, 2);
    const double eyes[2][3] = {{2, (16 + 41) / 32.0, -1}, {1, (16 + 41) / 32.0, -2}};
    const double ways[2][3] = {{-1, 0, 0}, {0, 0, -1}};
    for (int i = 0; i < 2; i++)
        for (int axis = 0; axis < 3; axis++) {
            assert_true(cameras[i].eye_m[axis] == eyes[i][axis]);
            assert_true(fabs(cameras[i].target_m[axis] - eyes[i][axis] - ways[i][axis]) < 1e-12);
        }
    free(cameras);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_room_is_a_closed_box_in_metres_with_y_up, level_begin),
        cmocka_unit_test_setup(sectors_and_pillars_within_a_sector_are_left_out_of_it, level_begin),
        cmocka_unit_test_setup(each_place_has_the_floor_of_its_sector_and_no_other, level_begin),
        cmocka_unit_test_setup(a_sector_within_its_own_lines_has_walls_round_it, level_begin),
        cmocka_unit_test_setup(a_sector_that_is_open_is_closed_where_it_ends, level_begin),
        cmocka_unit_test_setup(lines_within_a_sector_are_walls_or_hold_what_hangs, level_begin),
        cmocka_unit_test_setup(a_closed_door_is_the_walls_round_it, level_begin),
        cmocka_unit_test_setup(a_later_wad_takes_the_place_of_maps_and_textures, level_begin),
        cmocka_unit_test_setup(paths_name_wads_and_maps, level_begin),
        cmocka_unit_test_setup(players_come_first_and_things_without_room_not_at_all, level_begin),
    };
    return cmocka_run_group_tests(tests, level_enter, level_leave);
}
