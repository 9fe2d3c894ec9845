/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a WAD: its lumps, each a kind, a length and so many bytes, behind the looks of a small WAD; or, if they
 * begin with IWAD or PWAD, the file itself. What is refused is refused in one line, what is read is a model as any
 * other, and its things are cameras within it. */
#include "fuzz.h"
#include "fuzz_model.h"
#include "levels/level_cameras.h"
#include "levels/level_moves.h"
#include "unit/levels/wad_writer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { LUMPS_MOST = 32, FARTHEST_M = 2048, DOORS_MARK = 0xD0, DOOR_TAG = 7 };

static const char *const NAMES[] = {"MAP01",   "THINGS",   "LINEDEFS", "SIDEDEFS", "VERTEXES", "SECTORS",  "NODES",
                                    "PNAMES",  "TEXTURE1", "TEXTURE2", "PWALL",    "PGRATE",   "COLORMAP", "FLOOR",
                                    "PLAYPAL", "BEHAVIOR", "TEXTMAP",  "F_START",  "F_END",    "SKY1"};

static void write_lumps(struct wad_writer *wad, struct fuzz_bytes bytes)
{
    wad_begin(wad, "IWAD");
    wad_write_looks(wad);
    for (int i = 0; i < LUMPS_MOST && bytes.left_b; i++) {
        const char *name = NAMES[fuzz_below(&bytes, sizeof NAMES / sizeof *NAMES)];
        const size_t said_b = fuzz_u16(&bytes), size_b = said_b < bytes.left_b ? said_b : bytes.left_b;
        wad_lump(wad, name, bytes.at, size_b);
        bytes.at += size_b;
        bytes.left_b -= size_b;
    }
    wad_end(wad);
}

static const char *check_cameras(const char *path)
{
    struct level_camera *cameras;
    struct error err;
    size_t count;
    const char *broken = NULL;
    if (!level_cameras_read(path, &cameras, &count, &err)) return fuzz_check_refusal(err.text, NULL);
    if (!count) broken = "no cameras, and no reason";
    for (size_t i = 0; i < count; i++)
        for (int axis = 0; axis < 3; axis++)
            if (!(fabs(cameras[i].eye_m[axis]) < FARTHEST_M)) broken = "a camera out of range";
    free(cameras);
    return broken;
}

/* What doors are is in a last byte that few older inputs have. */
static enum level_doors doors_of(const uint8_t *bytes, size_t size_b)
{
    if (!size_b || (bytes[size_b - 1] & ~3) != DOORS_MARK) return LEVEL_DOORS_CLOSED;
    return (enum level_doors)((bytes[size_b - 1] & 3) % (LEVEL_DOORS_MOVE + 1));
}

static const char *run(const uint8_t *bytes, size_t size_b)
{
    static struct wad_writer wad;
    const enum level_doors doors = doors_of(bytes, size_b);
    level_doors_set(doors);
    if (doors != LEVEL_DOORS_CLOSED) size_b--; /* the mark is of no lump */
    const bool is_file = size_b >= 4 && memcmp(bytes + 1, "WAD", 3) == 0 && (*bytes == 'I' || *bytes == 'P');
    char path[512];
    if (!is_file) write_lumps(&wad, (struct fuzz_bytes){bytes, size_b});
    const char *file = is_file ? fuzz_as_named_file("model.wad", bytes, size_b)
                               : fuzz_as_named_file("model.wad", wad.bytes, wad.size_b);
    snprintf(path, sizeof path, "%s:MAP01", file);
    const char *broken = fuzz_model_read(path, (uint32_t)crc32(0, bytes, (uInt)size_b));
    return broken ? broken : check_cameras(path);
}

const struct fuzz_target fuzz_wad = {"wad", run, NULL};

/* Seeds -------------------------------------------------------------------------------------- */

/* The inner sector is a door or a lift. */
static void make_special(struct wad_map *map, unsigned sector, unsigned line, uint8_t dice)
{
    static const uint8_t specials[] = {1, 117, 63, 62, 123, 0};
    const uint16_t special = specials[dice % sizeof specials];

    map->sectors[sector].tag = DOOR_TAG;
    for (; line < map->line_count; line++) {
        map->lines[line][3] = special;
        map->lines[line][4] = DOOR_TAG;
    }
}

static void make_map(struct wad_map *map, const uint8_t dice[8])
{
    memset(map, 0, sizeof *map);
    const unsigned room = wad_sector(map, 0, 128, dice[0], "FLOOR", dice[1] & 1 ? "CEIL" : "F_SKY1");
    wad_room(map, 0, 0, 256 + dice[2], room);
    if (dice[3] & 1) {
        const unsigned inner = wad_sector(map, dice[4] & 63, 64 + dice[5] % 128, dice[0], "CEIL", "FLOOR");
        const unsigned first = wad_vertex(map, 64, 64), first_line = (unsigned)map->line_count;
        wad_vertex(map, 128, 64);
        wad_vertex(map, 96 + dice[6] % 32, 128);
        for (unsigned i = 0; i < 3; i++)
            wad_line(map, first + i, first + (i + 1) % 3, dice[7],
                     wad_side(map, room, "WALL", "WALL", dice[3] & 2 ? "GRATE" : "-"),
                     wad_side(map, inner, "WALL", "WALL", "-"));
        make_special(map, inner, first_line, dice[6]);
    }
    wad_thing(map, 32, 32, 90, 1);
}

size_t fuzz_wad_seed(uint8_t *out, size_t most_b, const uint8_t dice[8])
{
    static struct wad_writer wad;
    struct wad_map map;
    size_t at = 0;
    make_map(&map, dice);
    wad_begin(&wad, "PWAD");
    wad_write_map(&wad, "MAP01", &map);
    for (size_t i = 0; i < wad.count; i++) {
        const size_t size_b = wad.lumps[i].size_b;
        uint8_t kind = 0;
        while (strncmp(NAMES[kind], wad.lumps[i].name, 8) != 0)
            kind++;
        if (at + 3 + size_b > most_b) abort();
        out[at++] = kind;
        out[at++] = (uint8_t)size_b;
        out[at++] = (uint8_t)(size_b >> 8);
        memcpy(out + at, wad.bytes + wad.lumps[i].at, size_b);
        at += size_b;
    }
    if (at < most_b) out[at++] = (uint8_t)(DOORS_MARK + dice[1] % 3);
    return at;
}
