/* SPDX-License-Identifier: MIT
 *
 * Records of fixed size, little-endian. Source: Fell, The Unofficial Doom Specs 1.666, 1994, chapter 4. */
#include "levels/level.h"

#include "base/grow.h"
#include "model/note_words.h"

#include <stdlib.h>
#include <string.h>

/* A map's name is followed by its lumps, in this order mostly; nodes, blockmap and the like may be missing. */
enum { MAP_LUMPS = 12, RECORDS_MAX = 1 << 16 };

struct reading {
    const struct wad *wad;
    size_t first, end; /* the map's lumps */
    struct level *level;
    struct error *err;
};

static bool is_of_a_map(const char *name)
{
    static const char *const names[] = {"THINGS", "LINEDEFS", "SIDEDEFS", "VERTEXES", "SEGS",     "SSECTORS",
                                        "NODES",  "SECTORS",  "REJECT",   "BLOCKMAP", "BEHAVIOR", "SCRIPTS"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(name, names[i]) == 0) return true;
    return false;
}

bool level_begins_at(const struct wad *wad, size_t lump)
{
    if (lump + 1 >= wad->lump_count || is_of_a_map(wad->lumps[lump].name)) return false;
    const char *next = wad->lumps[lump + 1].name;
    return strcmp(next, "THINGS") == 0 || strcmp(next, "LINEDEFS") == 0 || strcmp(next, "TEXTMAP") == 0;
}

static const struct wad_lump *lump_of(const struct reading *reading, const char *name)
{
    for (size_t i = reading->first; i < reading->end; i++)
        if (strcmp(reading->wad->lumps[i].name, name) == 0) return &reading->wad->lumps[i];
    return NULL;
}

static bool refuse(const struct reading *reading, const char *lump, size_t number, const char *reason)
{
    const struct wad *wad = reading->wad;
    return error_set(reading->err, "%s: %s: %s %zu: %s", wad->paths[wad->lumps[reading->first - 1].file],
                     reading->level->name, lump, number, reason);
}

static bool refuse_index(const struct reading *reading, const char *lump, size_t number, const char *what, size_t index,
                         size_t count)
{
    const struct wad *wad = reading->wad;
    return error_set(reading->err, "%s: %s: %s %zu: its %s is number %zu, of %zu",
                     wad->paths[wad->lumps[reading->first - 1].file], reading->level->name, lump, number, what, index,
                     count);
}

/* NULL on error. What is behind the last whole record is nothing. */
static const uint8_t *records(const struct reading *reading, const char *name, size_t record_b, size_t *count)
{
    const struct wad_lump *lump = lump_of(reading, name);
    const char *path = reading->wad->paths[reading->wad->lumps[reading->first - 1].file], *map = reading->level->name;
    if (!lump) {
        error_set(reading->err, "%s: %s: there is no lump %s", path, map, name);
        return NULL;
    }
    if (!wad_lump_is_whole(reading->wad, lump, reading->err)) return NULL;
    *count = lump->size_b / record_b;
    if (lump->size_b % record_b)
        error_set(reading->err, "%s: %s: lump %s: truncated: its %zu bytes are no records of %zu", path, map, name,
                  lump->size_b, record_b);
    else if (*count == 0)
        error_set(reading->err, "%s: %s: lump %s: it is empty", path, map, name);
    else if (*count > RECORDS_MAX)
        error_set(reading->err, "%s: %s: lump %s: %zu records, %d are the most", path, map, name, *count, RECORDS_MAX);
    else
        return lump->bytes;
    return NULL;
}

static bool read_vertices(const struct reading *reading)
{
    struct level *level = reading->level;
    const uint8_t *at = records(reading, "VERTEXES", 4, &level->vertex_count);
    if (!at) return false;
    level->vertices = grow_zeroed(level->vertex_count, sizeof *level->vertices);
    for (size_t i = 0; i < level->vertex_count; i++, at += 4)
        level->vertices[i] = (struct level_vertex){wad_s16(at), wad_s16(at + 2)};
    return true;
}

static bool read_sectors(const struct reading *reading)
{
    struct level *level = reading->level;
    const uint8_t *at = records(reading, "SECTORS", 26, &level->sector_count);
    if (!at) return false;
    level->sectors = grow_zeroed(level->sector_count, sizeof *level->sectors);
    for (size_t i = 0; i < level->sector_count; i++, at += 26) {
        struct level_sector *sector = &level->sectors[i];
        *sector = (struct level_sector){.floor = wad_s16(at),
                                        .ceiling = wad_s16(at + 2),
                                        .light = wad_s16(at + 20),
                                        .special = wad_u16(at + 22),
                                        .tag = wad_u16(at + 24)};
        wad_name(at + 4, sector->floor_flat);
        wad_name(at + 12, sector->ceiling_flat);
    }
    return true;
}

static bool read_sides(const struct reading *reading)
{
    struct level *level = reading->level;
    const uint8_t *at = records(reading, "SIDEDEFS", 30, &level->side_count);
    if (!at) return false;
    level->sides = grow_zeroed(level->side_count, sizeof *level->sides);
    for (size_t i = 0; i < level->side_count; i++, at += 30) {
        struct level_side *side = &level->sides[i];
        *side = (struct level_side){.x_offset = wad_s16(at), .y_offset = wad_s16(at + 2), .sector = wad_u16(at + 28)};
        wad_name(at + 4, side->upper);
        wad_name(at + 12, side->lower);
        wad_name(at + 20, side->middle);
        if (side->sector >= level->sector_count)
            return refuse_index(reading, "SIDEDEFS", i, "sector", side->sector, level->sector_count);
    }
    return true;
}

static bool check_line(const struct reading *reading, size_t i)
{
    const struct level *level = reading->level;
    const struct level_line *line = &level->lines[i];
    const uint16_t vertices[2] = {line->from, line->to};
    for (int end = 0; end < 2; end++) {
        if (vertices[end] >= level->vertex_count)
            return refuse_index(reading, "LINEDEFS", i, "vertex", vertices[end], level->vertex_count);
        if (line->sides[end] != LEVEL_NO_SIDE && line->sides[end] >= level->side_count)
            return refuse_index(reading, "LINEDEFS", i, "side", line->sides[end], level->side_count);
    }
    return line->sides[0] != LEVEL_NO_SIDE || refuse(reading, "LINEDEFS", i, "it has no right side");
}

static bool read_lines(const struct reading *reading)
{
    struct level *level = reading->level;
    const uint8_t *at = records(reading, "LINEDEFS", 14, &level->line_count);
    if (!at) return false;
    level->lines = grow_zeroed(level->line_count, sizeof *level->lines);
    for (size_t i = 0; i < level->line_count; i++, at += 14) {
        level->lines[i] = (struct level_line){.from = wad_u16(at),
                                              .to = wad_u16(at + 2),
                                              .flags = wad_u16(at + 4),
                                              .special = wad_u16(at + 6),
                                              .tag = wad_u16(at + 8),
                                              .sides = {wad_u16(at + 10), wad_u16(at + 12)}};
        if (!check_line(reading, i)) return false;
    }
    return true;
}

/* A map without things is one. */
static bool read_things(const struct reading *reading)
{
    struct level *level = reading->level;
    const struct wad_lump *lump = lump_of(reading, "THINGS");
    if (lump && lump->size_b == 0) return true;
    const uint8_t *at = records(reading, "THINGS", 10, &level->thing_count);
    if (!at) return false;
    level->things = grow_zeroed(level->thing_count, sizeof *level->things);
    for (size_t i = 0; i < level->thing_count; i++, at += 10)
        level->things[i] =
            (struct level_thing){wad_s16(at), wad_s16(at + 2), wad_s16(at + 4), wad_u16(at + 6), wad_u16(at + 8)};
    return true;
}

static bool find_map(struct reading *reading)
{
    const struct wad *wad = reading->wad;
    const char *map = reading->level->name;
    size_t i = wad->lump_count;
    while (i > 0 && !(level_begins_at(wad, i - 1) && strcmp(wad->lumps[i - 1].name, map) == 0))
        i--;
    const char *path = i ? wad->paths[wad->lumps[i - 1].file] : wad->paths[wad->file_count - 1];
    if (i == 0)
        return error_set(reading->err, "%s: there is no map %s in it; `limner wad` lists those that are", path, map);
    reading->first = reading->end = i;
    while (reading->end < wad->lump_count && reading->end < i + MAP_LUMPS && is_of_a_map(wad->lumps[reading->end].name))
        reading->end++;
    if (reading->end == i) return error_set(reading->err, "%s: %s: " WORDS_UDMF, path, map);
    return !lump_of(reading, "BEHAVIOR") || error_set(reading->err,
                                                      "%s: %s: is of Hexen's format, which is not read; "
                                                      "only Doom's is",
                                                      path, map);
}

bool level_read(const struct wad *wad, const char *map, struct level *out, struct error *err)
{
    struct reading reading = {.wad = wad, .level = out, .err = err};
    *out = (struct level){0};
    wad_name_of_text(map, out->name);
    const bool ok = find_map(&reading) && read_vertices(&reading) && read_sectors(&reading) && read_sides(&reading) &&
                    read_lines(&reading) && read_things(&reading);
    if (!ok) level_free(out);
    return ok;
}

void level_free(struct level *level)
{
    free(level->vertices);
    free(level->lines);
    free(level->sides);
    free(level->sectors);
    free(level->things);
    *level = (struct level){0};
}
