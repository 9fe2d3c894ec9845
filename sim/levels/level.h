/* SPDX-License-Identifier: MIT
 *
 * A map of a WAD as its lumps have it: vertices, lines, their sides, sectors, things. Its nodes are not read: the
 * compiler builds a tree of its own (sim/DESIGN.md). */
#ifndef SIM_LEVEL_H
#define SIM_LEVEL_H

#include "levels/wad.h"

enum { LEVEL_NO_SIDE = 0xFFFF };

/* Flags of lines. */
enum { LINE_UPPER_UNPEGGED = 0x08, LINE_LOWER_UNPEGGED = 0x10 };

/* x is east, y is north. */
struct level_vertex {
    int x, y;
};

struct level_line {
    uint16_t from, to, flags, special, tag;
    uint16_t sides[2]; /* to the right of from -> to, and to the left; LEVEL_NO_SIDE: there is none */
};

/* Textures are named: "-" is none. */
struct level_side {
    int x_offset, y_offset;
    char upper[WAD_NAME_B], lower[WAD_NAME_B], middle[WAD_NAME_B];
    uint16_t sector;
};

struct level_sector {
    int floor, ceiling;
    char floor_flat[WAD_NAME_B], ceiling_flat[WAD_NAME_B];
    int light;
    uint16_t special, tag;
};

struct level_thing {
    int x, y, angle_deg; /* 0 is east, 90 north */
    uint16_t kind, flags;
};

struct level {
    char name[WAD_NAME_B];
    struct level_vertex *vertices;
    struct level_line *lines;
    struct level_side *sides;
    struct level_sector *sectors;
    struct level_thing *things;
    size_t vertex_count, line_count, side_count, sector_count, thing_count;
};

/* Every index is good then. Refused, naming lump and number: what is missing, cut short, out of range, or of another
 * format (Hexen's, UDMF). */
bool level_read(const struct wad *wad, const char *map, struct level *out, struct error *err);
void level_free(struct level *level);

/* Whether a lump, by its index, is the name of a map: those of the map follow it. */
bool level_begins_at(const struct wad *wad, size_t lump);

#endif
