/* SPDX-License-Identifier: MIT
 *
 * Freedoom's maps are closed: from where players and things stand every ray ends at a front, be it a wall, a floor or
 * the sky. Rays know nothing of sectors and lines, and so find what the importer leaves out. Panes let them through;
 * maps with walls that are seen from one side alone, in the middle of a room, are not taken. */
#include "levels/level_cameras.h"
#include "levels/level_import.h"
#include "levels/level_moves.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "unit/levels/level_rig.h"

#include <stdlib.h>

#define FREEDOOM "/usr/share/games/doom/freedoom"

enum { EYES = 40, RAYS = 60 };

static void assert_closed(const char *path)
{
    struct model model;
    struct level_camera *cameras;
    struct error err;
    struct random random = {11};
    size_t count = 0;
    if (!level_import(path, false, &model, &err) || !level_cameras_read(path, &cameras, &count, &err))
        fail_msg("%s", err.text);
    const size_t eyes = (size_t)effort(EYES) < count ? (size_t)effort(EYES) : count;
    for (size_t i = 0; i < eyes; i++)
        if (!level_is_closed(&model, cameras[i * count / eyes].eye_m, RAYS, &random)) fail_msg("%s", path);
    free(cameras);
    model_free(&model);
}

static void maps_without_tricks_are_closed(void **state)
{
    (void)state;
    assert_closed(FREEDOOM "1.wad:E1M1");
    assert_closed(FREEDOOM "1.wad:E1M9");
    assert_closed(FREEDOOM "2.wad:MAP01");
    assert_closed(FREEDOOM "2.wad:MAP31");
}

/* Rays from beyond their doors, and from where lifts have been, end as well. */
static void maps_with_open_doors_are_closed(void **state)
{
    (void)state;
    for (int doors = LEVEL_DOORS_OPEN; doors <= LEVEL_DOORS_MOVE; doors++) {
        level_doors_set((enum level_doors)doors);
        assert_closed(FREEDOOM "1.wad:E1M1");
        assert_closed(FREEDOOM "1.wad:E1M6");
        assert_closed(FREEDOOM "2.wad:MAP01");
    }
    level_doors_set(LEVEL_DOORS_CLOSED);
}

/* Sectors within their own lines, lines that name other sectors than lie beside them. */
static void maps_whose_lines_name_other_sectors_are_closed(void **state)
{
    (void)state;
    assert_closed(FREEDOOM "1.wad:E1M6");
    assert_closed(FREEDOOM "2.wad:MAP29");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(maps_without_tricks_are_closed),
        cmocka_unit_test(maps_with_open_doors_are_closed),
        cmocka_unit_test(maps_whose_lines_name_other_sectors_are_closed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
