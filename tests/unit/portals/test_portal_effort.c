/* SPDX-License-Identifier: MIT
 *
 * Portals that lead too far: from rooms that are given up everything counts as seen, from others nothing that is seen
 * is left out; and where too large a part is given up, all of it is refused. */
#include "core/core.h"
#include "portals/flow.h"
#include "portals/pvs.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/room_scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double ANGLE_RAD = 1.0 / 128.0;

struct tally {
    size_t views, hidden, given_up, rooms;
};

/* Views with what is seen from where, and without: their pictures are equal. */
static void look_around(const struct room_scene *rooms, const struct compiled *scene, const struct pvs *pvs, int views,
                        struct random *random, struct tally *tally)
{
    const struct simulator_setup setup = {32, 24, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, &core_fast};
    struct simulator with, without;
    struct lim_scene places = scene->scene;
    struct lens lens;
    struct error err;

    places.places = pvs->places;
    places.place_count = (uint16_t)pvs->place_count;
    places.pvs = pvs->bytes;
    places.pvs_bytes = (uint16_t)pvs->byte_count;
    if (!simulator_init(&with, &places, &setup, &err) || !simulator_init(&without, &scene->scene, &setup, &err) ||
        !lens_init(&lens, 70, 0.1, setup.w_px, setup.h_px, &err))
        fail_msg("%s", err.text);
    for (int v = 0; v < views; v++) {
        struct viewpoint viewpoint = room_scene_view(rooms, random);
        const struct camera_path path = {"random", &viewpoint, 1};
        struct lim_camera camera;
        if (!camera_path_to_camera(&path, 0, &lens, &scene->grid, &camera, &err) ||
            !simulator_frame(&with, &camera, &err) || !simulator_frame(&without, &camera, &err))
            fail_msg("%s", err.text);
        assert_memory_equal(with.pixels, without.pixels, simulator_pixel_count(&with) * sizeof *with.pixels);
        tally->views++;
        tally->hidden += simulator_stats(&with)->hidden > 0;
    }
    simulator_free(&with);
    simulator_free(&without);
}

/* Random buildings, in which so much is done for each room, and for all. */
static struct tally tally_of(const struct pvs_effort *effort, int buildings, int views)
{
    struct random random = {815};
    struct tally tally = {0};

    for (int s = 0; s < buildings; s++) {
        struct room_scene rooms;
        struct compiled scene;
        struct pvs pvs;
        struct error err;
        room_scene_random(&rooms, &random);
        if (!room_scene_compile(&rooms, PORTALS_OFF, &core_fast, &scene, &err) ||
            !pvs_find(&scene.scene, ANGLE_RAD, effort, &pvs, &err))
            fail_msg("%s", err.text);
        tally.given_up += pvs.given_up;
        tally.rooms += pvs.zones;
        look_around(&rooms, &scene, &pvs, views, &random, &tally);
        pvs_free(&pvs);
        compiled_free(&scene);
        room_scene_free(&rooms);
    }
    printf("# portals: %zu of %zu rooms given up; of %zu views %zu leave something out\n", tally.given_up, tally.rooms,
           tally.views, tally.hidden);
    return tally;
}

static void some_rooms_are_given_up_and_no_picture_changes(void **state)
{
    const struct pvs_effort by_room = {.zone_work = 8000, .work = 1000000, .given_up = 2.0};
    const struct pvs_effort in_all = {.zone_work = 1000000, .work = 40000, .given_up = 2.0};

    (void)state;
    for (int k = 0; k < 2; k++) { /* all buildings: one alone may give up all */
        const struct tally tally = tally_of(k ? &in_all : &by_room, 20, effort(350) + 50);
        assert_true(tally.given_up * 5 > tally.rooms && tally.given_up < tally.rooms);
        assert_true(tally.hidden * 20 > tally.views);
    }
}

static void enough_effort_gives_up_nothing(void **state)
{
    (void)state;
    assert_int_equal(tally_of(&pvs_usual_effort, effort(5), 50).given_up, 0);
}

/* What is seen from all rooms, each looked from once more with little effort before the next one. Returns how often
 * that was too little. */
static size_t see_all(const struct cells *cells, const struct zones *zones, bool interrupted, bool *visible)
{
    struct flow flow;
    size_t given_up = 0;

    flow_init(&flow, cells, zones, ANGLE_RAD);
    for (size_t z = 0; z < zones->count; z++) {
        bool *const mine = visible + z * cells->record_count;
        flow.work_max = 500 + 37 * z;
        if (interrupted) given_up += !flow_see(&flow, z, mine);
        flow.work_max = pvs_usual_effort.zone_work;
        assert_true(flow_see(&flow, z, mine));
    }
    flow_free(&flow);
    return given_up;
}

static void a_room_that_is_given_up_leaves_nothing_behind(void **state)
{
    struct random random = {23};
    size_t given_up = 0;

    (void)state;
    for (int s = 0; s < 5; s++) {
        struct room_scene rooms;
        struct compiled scene;
        struct cells cells;
        struct zones zones;
        struct error err;
        room_scene_random(&rooms, &random);
        if (!room_scene_compile(&rooms, PORTALS_OFF, &core_fast, &scene, &err) ||
            !cells_find(&scene.scene, &cells, &err))
            fail_msg("%s", err.text);
        zones_find(&cells, &zones);
        const size_t count = zones.count * cells.record_count;
        bool *const expected = calloc(count, 1), *const found = calloc(count, 1);
        (void)see_all(&cells, &zones, false, expected);
        given_up += see_all(&cells, &zones, true, found);
        assert_memory_equal(expected, found, count);
        free(expected);
        free(found);
        zones_free(&zones);
        cells_free(&cells);
        compiled_free(&scene);
        room_scene_free(&rooms);
    }
    assert_true(given_up > 50);
}

static void too_large_a_part_is_refused(void **state)
{
    const struct pvs_effort none = {.zone_work = 1, .work = 1000000, .given_up = 0.25};
    struct random random = {4};
    struct room_scene rooms;
    struct compiled scene;
    struct pvs pvs;
    struct error err;

    (void)state;
    room_scene_random(&rooms, &random);
    if (!room_scene_compile(&rooms, PORTALS_OFF, &core_fast, &scene, &err)) fail_msg("%s", err.text);
    assert_false(pvs_find(&scene.scene, ANGLE_RAD, &none, &pvs, &err));
    assert_string_equal(err.text, "its portals lead too far to be followed");
    assert_null(pvs.places);
    compiled_free(&scene);
    room_scene_free(&rooms);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(some_rooms_are_given_up_and_no_picture_changes),
        cmocka_unit_test(enough_effort_gives_up_nothing),
        cmocka_unit_test(a_room_that_is_given_up_leaves_nothing_behind),
        cmocka_unit_test(too_large_a_part_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
