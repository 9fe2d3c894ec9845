/* SPDX-License-Identifier: MIT */
#include "levels/level_cameras.h"

#include "base/grow.h"
#include "levels/level_faces.h"
#include "levels/level_path.h"
#include "levels/level_sectors.h"

#include <math.h>
#include <stdlib.h>

static const double PI = 3.14159265358979323846;

/* Kinds of things. */
enum { FIRST_PLAYER = 1, LAST_PLAYER = 4, DEATHMATCH = 11, OTHERS = DEATHMATCH + 1 };

static int rank_of(const struct level_thing *thing)
{
    const bool is_player = thing->kind >= FIRST_PLAYER && thing->kind <= LAST_PLAYER;
    return is_player || thing->kind == DEATHMATCH ? thing->kind : OTHERS;
}

static bool camera_of(const struct level *level, const struct level_sectors *sectors, const struct level_thing *thing,
                      struct level_camera *out)
{
    const uint32_t number = level_sector_at(sectors, thing->x, thing->y);
    if (number == LEVEL_VOID) return false;
    const struct level_sector *sector = &level->sectors[number];
    const int eye = sector->floor + LEVEL_EYE_UNITS;
    if (eye >= sector->ceiling) return false;
    const double turn = thing->angle_deg * PI / 180;
    level_place(thing->x, thing->y, eye, out->eye_m);
    level_place(thing->x + LEVEL_UNITS_A_M * cos(turn), thing->y + LEVEL_UNITS_A_M * sin(turn), eye, out->target_m);
    return true;
}

static size_t add_cameras(const struct level *level, const struct level_sectors *sectors, struct level_camera *cameras)
{
    size_t count = 0;
    for (int rank = FIRST_PLAYER; rank <= OTHERS; rank++)
        for (size_t i = 0; i < level->thing_count; i++)
            if (rank_of(&level->things[i]) == rank)
                count += camera_of(level, sectors, &level->things[i], &cameras[count]);
    return count;
}

static bool read_level(const struct level_path *path, struct level *level, struct error *err)
{
    struct wad wad;
    if (!wad_open(path->files, &wad, err)) return false;
    const bool ok = level_read(&wad, path->map, level, err);
    wad_close(&wad);
    return ok;
}

bool level_cameras_read(const char *path, struct level_camera **out, size_t *count, struct error *err)
{
    struct level_path parts;
    struct level level;
    struct level_sectors sectors;
    *out = NULL;
    if (!level_path_parse(path, &parts) || !*parts.map) return error_set(err, "%s: names no map of a WAD", path);
    if (!read_level(&parts, &level, err)) return false;
    const bool ok = level_sectors_make(&level, &sectors, err) || error_prefix(err, parts.files);
    if (ok) {
        *out = grow_zeroed(level.thing_count, sizeof **out);
        *count = add_cameras(&level, &sectors, *out);
        level_sectors_free(&sectors);
    }
    level_free(&level);
    if (!ok || *count) return ok;
    free(*out);
    return error_set(err, "%s: no thing stands in it where an eye has room", path);
}
