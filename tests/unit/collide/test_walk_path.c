/* SPDX-License-Identifier: MIT
 *
 * Walks that a scene is explored on: no way from one eye to the next crosses a polygon, no stride is too long, all of a
 * building that hangs together is seen, and the same comes out again. */
#include "cameras/walk_path.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/room_scene.h"
#include "unit/collide/solid_stage.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct walk_wish PERSON = {
    .body = {.eye_m = 1.5, .height_m = 1.7, .radius_m = 0.25, .step_m = 0.3}, .frames = 600, .stride_m = 0.25};

/* Steps are walked over within a frame: the eye's way is tried at the higher of both. Screens with one side are passed
 * from behind. */
static void assert_walks(const struct compiled *scene, const struct walk_wish *wish, const struct camera_path *path)
{
    struct solid_list list;
    size_t crossed = 0;
    double way_m = 0;

    solid_list_init(&list, &scene->scene);
    for (size_t i = 1; i < path->count; i++) {
        const double *a = path->frames[i - 1].eye_m, *b = path->frames[i].eye_m;
        const double from_m[3] = {a[0], fmax(a[1], b[1]), a[2]}, to_m[3] = {b[0], fmax(a[1], b[1]), b[2]};
        int32_t from_q8[3], there_q8[3];
        solid_place_q8(scene, from_m, from_q8);
        solid_place_q8(scene, to_m, there_q8);
        crossed += solid_trace(&list, from_q8, there_q8, false).hit;
        assert_true(hypot(b[0] - a[0], b[2] - a[2]) <= wish->stride_m * 1.001);
        way_m += hypot(b[0] - a[0], b[2] - a[2]);
    }
    assert_int_equal(crossed, 0);
    assert_true(way_m > 0.2 * wish->stride_m * (double)wish->frames);
    solid_list_free(&list);
}

static struct camera_path walk(const struct compiled *scene, const struct walk_wish *wish, struct walk_found *found)
{
    struct camera_path path;
    struct error err;

    if (!walk_path(scene, "a building", wish, &path, found, &err)) fail_msg("%s", err.text);
    assert_int_equal(path.count, wish->frames);
    return path;
}

static void random_buildings_are_walked_through(void **state)
{
    struct random random = {4};

    (void)state;
    for (int k = 0, count = effort(6); k < count; k++) {
        struct room_scene rooms;
        struct compiled scene;
        struct walk_found found, again;
        struct error err;
        do { /* upright ones */
            room_scene_random(&rooms, &random);
            if (rooms.turn[1][1] == 1) break;
            room_scene_free(&rooms);
        } while (true);
        if (!room_scene_compile(&rooms, PORTALS_OFF, NULL, &scene, &err)) fail_msg("%s", err.text);
        struct camera_path path = walk(&scene, &PERSON, &found), same = walk(&scene, &PERSON, &again);
        printf("# building %d: %zu of %zu places seen, %.0f m\n", k, found.seen, found.places, found.way_m);
        assert_walks(&scene, &PERSON, &path);
        assert_memory_equal(path.frames, same.frames, path.count * sizeof *path.frames);
        assert_true(found.seen * 10 > found.places * 8 || found.places > 1500);
        camera_path_free(&path);
        camera_path_free(&same);
        compiled_free(&scene);
        room_scene_free(&rooms);
    }
}

static void a_level_is_walked_through(void **state)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "fewest", .tree = TREE_BSP, .unlit = true};
    const struct walk_wish player = {.body = {.eye_m = 1.28, .height_m = 1.75, .radius_m = 0.5, .step_m = 0.75},
                                     .has_from = true,
                                     .from_m = {-5, 1.28, -9.5},
                                     .frames = 256,
                                     .stride_m = 0.25};
    struct compiled scene;
    struct walk_found found;
    struct error err;

    (void)state;
    if (!compile_model(SOLID_E1M1, &options, &scene, &err)) fail_msg("%s", err.text);
    struct camera_path path = walk(&scene, &player, &found);
    assert_walks(&scene, &player, &path);
    printf("# E1M1: %zu of %zu places seen, %.0f m\n", found.seen, found.places, found.way_m);
    assert_true(found.places > 1000 && found.seen > 1000);
    camera_path_free(&path);
    compiled_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_buildings_are_walked_through),
        cmocka_unit_test(a_level_is_walked_through),
    };

    return cmocka_run_group_tests_name("walk path", tests, NULL, NULL);
}
