/* SPDX-License-Identifier: MIT
 *
 * Writes small WADs: lumps, maps, textures. Nothing is checked, so that broken ones can be written, too. */
#ifndef LEVELS_WAD_WRITER_H
#define LEVELS_WAD_WRITER_H

#include <stddef.h>
#include <stdint.h>

enum { WAD_WRITER_B = 1 << 18, WAD_WRITER_LUMPS = 64, WAD_MAP_MOST = 128, WAD_NO_SIDE = 0xFFFF };

struct wad_writer {
    uint8_t bytes[WAD_WRITER_B];
    size_t size_b;
    struct {
        uint32_t at, size_b;
        char name[8];
    } lumps[WAD_WRITER_LUMPS];
    size_t count;
};

void wad_begin(struct wad_writer *wad, const char *kind);
void wad_lump(struct wad_writer *wad, const char *name, const void *bytes, size_t size_b);

/* The directory; bytes[0 .. size_b) are the file then. */
void wad_end(struct wad_writer *wad);
void wad_save(const struct wad_writer *wad, const char *path);

/* A palette in which colour i is (i, i, i / 2), a colour map whose row r makes i (32 - r) / 32 of colour i, patches, a
 * list of textures, and flats:
 *   WALL   64x128, colour x + y / 2 at x, y    GRATE  8x8, clear where x is odd    ONE    8x8, colour 7 everywhere
 *   SKY1   16x16, colour 200                   flats  FLOOR (colour x + y), CEIL (colour 9), F_SKY1 */
void wad_write_looks(struct wad_writer *wad);

struct wad_map {
    int16_t vertices[WAD_MAP_MOST][2];
    uint16_t lines[WAD_MAP_MOST][7]; /* from, to, flags, special, tag, right and left side */
    struct {
        int16_t offsets[2];
        char names[3][8]; /* upper, lower, middle */
        uint16_t sector;
    } sides[WAD_MAP_MOST];
    struct {
        int16_t floor, ceiling, light, tag;
        char names[2][8];
    } sectors[WAD_MAP_MOST];
    int16_t things[WAD_MAP_MOST][5]; /* x, y, angle, kind, flags */
    size_t vertex_count, line_count, side_count, sector_count, thing_count;
};

unsigned wad_vertex(struct wad_map *map, int x, int y);
unsigned wad_sector(struct wad_map *map, int floor, int ceiling, int light, const char *floor_flat,
                    const char *ceiling_flat);
unsigned wad_side(struct wad_map *map, unsigned sector, const char *upper, const char *lower, const char *middle);
unsigned wad_line(struct wad_map *map, unsigned from, unsigned to, unsigned flags, unsigned right, unsigned left);
void wad_thing(struct wad_map *map, int x, int y, int angle, int kind);

/* A square of one sector, seen from inside; its lines have the texture WALL. */
void wad_room(struct wad_map *map, int left, int bottom, int side, unsigned sector);
void wad_write_map(struct wad_writer *wad, const char *name, const struct wad_map *map);

#endif
