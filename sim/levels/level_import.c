/* SPDX-License-Identifier: MIT
 *
 * From a path to faces: floors and ceilings by sectors, walls by lines. What has no height has no faces: a closed door
 * that does not move is the walls round it. The sky is a ceiling, so that nothing is seen through it. */
#include "levels/level_import.h"

#include "base/grow.h"
#include "levels/level_path.h"
#include "levels/level_sectors.h"
#include "levels/level_walls.h"
#include "model/note_words.h"
#include "scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct importing {
    const struct level *level;
    struct level_move *moves; /* of each sector; NULL: all stay */
    struct level_faces faces;
    struct level_corner *corners; /* room for a polygon */
    size_t corner_capacity, sky;
    bool has_too_many; /* doors and lifts */
};

/* Doom has one for each episode, Doom II one for each third. */
static const char *sky_name(const char *map)
{
    static const char *const names[] = {"SKY1", "SKY2", "SKY3", "SKY4"};
    if (map[0] == 'E' && map[1] >= '1' && map[1] <= '4') return names[map[1] - '1'];
    const int number = strncmp(map, "MAP", 3) == 0 ? atoi(map + 3) : 0;
    return names[number > 20 ? 2 : number > 11 ? 1 : 0];
}

/* Flats lie on the world's lattice of 64 units, rows running south. */
static void add_flat(struct importing *importing, const int32_t (*points)[2], size_t count, bool is_floor, int height,
                     const struct level_sector *sector)
{
    const char *flat = is_floor ? sector->floor_flat : sector->ceiling_flat;
    struct level_textures *textures = importing->faces.textures;
    struct level_paint paint = {.look = importing->sky, .is_sky = true, .light = 0xFFFFFF};
    if (!level_is_sky(flat))
        paint = (struct level_paint){.look = level_look(textures, LOOK_FLAT, flat),
                                     .light = level_light(textures, sector->light, 0)};
    for (size_t i = 0; i < count; i++) {
        const int32_t *point = points[is_floor ? i : count - 1 - i];
        importing->corners[i] = (struct level_corner){point[0], point[1], height, point[0], -point[1]};
    }
    level_face_add(&importing->faces, importing->corners, count, &paint);
}

/* What is below a door that is shut, or above a lift that is up. */
static void add_moving(struct importing *importing, const int32_t (*points)[2], size_t count, uint32_t number)
{
    struct level_move *move = &importing->moves[number];
    struct model *model = importing->faces.model;
    if (!move->mover && model->mover_count == LIM_INSTANCES_MAX) importing->has_too_many = true;
    if (!move->mover && model->mover_count < LIM_INSTANCES_MAX) {
        double origin_m[3];
        level_place(points[0][0], points[0][1], move->rest, origin_m);
        move->mover = level_mover_add(model, move, number, origin_m);
    }
    importing->faces.mover = move->mover;
    if (move->mover)
        add_flat(importing, points, count, move->kind == MODEL_LIFT, move->rest, &importing->level->sectors[number]);
    importing->faces.mover = 0;
}

static void add_polygon(void *context, const int32_t (*points)[2], size_t count, uint32_t number)
{
    struct importing *importing = context;
    const struct level_sector *sector = &importing->level->sectors[number];
    if (sector->ceiling <= sector->floor) return;
    while (importing->corner_capacity < count)
        importing->corners = grow(importing->corners, importing->corner_capacity, &importing->corner_capacity,
                                  sizeof *importing->corners);
    add_flat(importing, points, count, true, sector->floor, sector);
    add_flat(importing, points, count, false, sector->ceiling, sector);
    if (importing->moves && importing->moves[number].kind != MODEL_MOVES && level_doors() == LEVEL_DOORS_MOVE)
        add_moving(importing, points, count, number);
}

/* Notices ------------------------------------------------------------------------------------ */

static void note_sectors(const struct level_sectors *sectors, struct model *model)
{
    if (sectors->crossing_count)
        model_note(model, "lines that cross others: %zu, LINEDEFS %u among them; floors follow the others",
                   sectors->crossing_count, sectors->first_crossing);
    if (sectors->astray_count)
        model_note(model, "lines that name a sector which is not there: %zu, LINEDEFS %u among them",
                   sectors->astray_count, sectors->first_astray);
    if (sectors->open_count)
        model_note(model, "sectors that no lines close: %zu, SECTORS %u among them; they end somewhere",
                   sectors->open_count, sectors->first_open);
}

static void note_textures(const struct level_textures *textures, struct model *model)
{
    if (textures->unknown_count)
        model_note(model, "textures that are missing: %zu, %s among them; " WORDS_GREY, textures->unknown_count,
                   textures->unknown);
    if (textures->broken_count)
        model_note(model, "parts of textures that are broken or missing: %zu, %s of %s among them",
                   textures->broken_count, textures->broken_part, textures->broken);
}

/* -------------------------------------------------------------------------------------------- */

static bool add_faces(const struct level *level, struct level_move *moves, bool is_textured,
                      struct level_textures *textures, struct model *model, struct error *err)
{
    struct level_sectors sectors;
    struct importing importing = {
        .level = level, .moves = moves, .faces = {model, textures, is_textured, .pictures = NULL}};
    if (!level_sectors_make(level, &sectors, err)) return false;
    importing.sky = level_look(textures, LOOK_WALL, sky_name(level->name));
    level_sectors_each(&sectors, add_polygon, &importing);
    level_walls_add(level, &sectors, moves, importing.sky, &importing.faces);
    if (moves) level_movers_finish(model, moves, level->sector_count);
    model->is_interior = true;
    model->lattice_m = 1.0 / LEVEL_UNITS_A_M;
    note_sectors(&sectors, model);
    if (importing.has_too_many)
        model_note(model, "doors and lifts beyond %d; they stay open, or down", LIM_INSTANCES_MAX);
    note_textures(textures, model);
    level_sectors_free(&sectors);
    free(importing.corners);
    free(importing.faces.pictures);
    return model->face_count > 0 || error_set(err, "%s: SECTORS: none of them has a height", level->name);
}

static bool import(const struct wad *wad, const char *map, bool is_textured, struct model *model, struct error *err)
{
    struct level level;
    struct level_textures textures = {0};
    struct level_move *moves = NULL;
    if (!level_read(wad, map, &level, err)) return false;
    if (level_doors() != LEVEL_DOORS_CLOSED) {
        moves = level_moves_find(&level);
        level_moves_open(moves, &level);
    }
    bool ok = level_textures_open(wad, &textures, err);
    if (ok && !add_faces(&level, moves, is_textured, &textures, model, err))
        ok = error_prefix(err, wad->paths[wad->file_count - 1]);
    free(moves);
    level_textures_close(&textures);
    level_free(&level);
    return ok;
}

bool level_import(const char *path, bool is_textured, struct model *model, struct error *err)
{
    struct level_path parts;
    struct wad wad;
    *model = (struct model){0};
    if (!level_path_parse(path, &parts)) return error_set(err, "%s: names no WAD", path);
    if (!*parts.map)
        return error_set(err, "%s: say which map, as %s:MAP01; `limner wad %s` lists them", path, path, path);
    if (!wad_open(parts.files, &wad, err)) return false;
    const bool ok = import(&wad, parts.map, is_textured, model, err);
    wad_close(&wad);
    if (!ok) model_free(model);
    return ok;
}
