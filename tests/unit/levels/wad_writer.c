/* SPDX-License-Identifier: MIT */
#include "unit/levels/wad_writer.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void put(uint8_t *at, uint32_t value, int bytes)
{
    for (int i = 0; i < bytes; i++)
        at[i] = (uint8_t)(value >> 8 * i);
}

static void name_to(void *at, const char *name)
{
    memset(at, 0, 8);
    memcpy(at, name, strlen(name) < 8 ? strlen(name) : 8);
}

void wad_begin(struct wad_writer *wad, const char *kind)
{
    wad->count = 0;
    wad->size_b = 12;
    memset(wad->bytes, 0, wad->size_b);
    memcpy(wad->bytes, kind, 4);
}

void wad_lump(struct wad_writer *wad, const char *name, const void *bytes, size_t size_b)
{
    if (wad->size_b + size_b > WAD_WRITER_B - 16 * WAD_WRITER_LUMPS || wad->count == WAD_WRITER_LUMPS) abort();
    wad->lumps[wad->count].at = (uint32_t)wad->size_b;
    wad->lumps[wad->count].size_b = (uint32_t)size_b;
    name_to(wad->lumps[wad->count++].name, name);
    if (size_b) memcpy(wad->bytes + wad->size_b, bytes, size_b);
    wad->size_b += size_b;
}

void wad_end(struct wad_writer *wad)
{
    put(wad->bytes + 4, (uint32_t)wad->count, 4);
    put(wad->bytes + 8, (uint32_t)wad->size_b, 4);
    for (size_t i = 0; i < wad->count; i++, wad->size_b += 16) {
        put(wad->bytes + wad->size_b, wad->lumps[i].at, 4);
        put(wad->bytes + wad->size_b + 4, wad->lumps[i].size_b, 4);
        memcpy(wad->bytes + wad->size_b + 8, wad->lumps[i].name, 8);
    }
}

void wad_save(const struct wad_writer *wad, const char *path)
{
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(wad->bytes, 1, wad->size_b, file) != wad->size_b || fclose(file) != 0) abort();
}

/* Looks -------------------------------------------------------------------------------------- */

enum { PATCH_MOST_B = 1 << 15 };

/* Columns of one post each, but empty ones where `clear` says so. */
static void write_patch(struct wad_writer *wad, const char *name, int w_px, int h_px, int (*colour)(int x, int y))
{
    uint8_t *patch = calloc(1, PATCH_MOST_B);
    size_t at = 8 + 4 * (size_t)w_px;
    if (!patch) abort();
    put(patch, (uint32_t)w_px, 2);
    put(patch + 2, (uint32_t)h_px, 2);
    for (int x = 0; x < w_px; x++) {
        put(patch + 8 + 4 * x, (uint32_t)at, 4);
        if (colour(x, 0) >= 0) {
            patch[at + 1] = (uint8_t)h_px;
            for (int y = 0; y < h_px; y++)
                patch[at + 3 + (size_t)y] = (uint8_t)colour(x, y);
            at += (size_t)h_px + 4;
        }
        patch[at++] = 255;
    }
    wad_lump(wad, name, patch, at);
    free(patch);
}

static int wall_colour(int x, int y)
{
    return x + y / 2;
}

static int grate_colour(int x, int y)
{
    return x % 2 ? -1 : 20 + y;
}

static int one_colour(int x, int y)
{
    (void)x, (void)y;
    return 7;
}

static int sky_colour(int x, int y)
{
    (void)x, (void)y;
    return 200;
}

static const struct {
    const char *name, *patch;
    int w_px, h_px;
    int (*colour)(int x, int y);
} TEXTURES[] = {{"WALL", "PWALL", 64, 128, wall_colour},
                {"GRATE", "PGRATE", 8, 8, grate_colour},
                {"ONE", "PONE", 8, 8, one_colour},
                {"SKY1", "PSKY", 16, 16, sky_colour}};
enum { TEXTURE_COUNT = sizeof TEXTURES / sizeof *TEXTURES, TEXTURE_B = 22 + 10 };

static void write_textures(struct wad_writer *wad)
{
    uint8_t names[4 + 8 * TEXTURE_COUNT], list[4 + TEXTURE_COUNT * (4 + TEXTURE_B)] = {0};
    put(names, TEXTURE_COUNT, 4);
    put(list, TEXTURE_COUNT, 4);
    for (int i = 0; i < TEXTURE_COUNT; i++) {
        const size_t at = 4 + 4 * TEXTURE_COUNT + (size_t)i * TEXTURE_B;
        name_to(names + 4 + 8 * i, TEXTURES[i].patch);
        put(list + 4 + 4 * i, (uint32_t)at, 4);
        name_to(list + at, TEXTURES[i].name);
        put(list + at + 12, (uint32_t)TEXTURES[i].w_px, 2);
        put(list + at + 14, (uint32_t)TEXTURES[i].h_px, 2);
        put(list + at + 20, 1, 2);
        put(list + at + 26, (uint32_t)i, 2);
    }
    wad_lump(wad, "PNAMES", names, sizeof names);
    wad_lump(wad, "TEXTURE1", list, sizeof list);
}

static void write_flats(struct wad_writer *wad)
{
    uint8_t flat[64 * 64];
    wad_lump(wad, "F_START", NULL, 0);
    for (int i = 0; i < 64 * 64; i++)
        flat[i] = (uint8_t)(i % 64 + i / 64);
    wad_lump(wad, "FLOOR", flat, sizeof flat);
    memset(flat, 9, sizeof flat);
    wad_lump(wad, "CEIL", flat, sizeof flat);
    wad_lump(wad, "F_SKY1", flat, sizeof flat);
    wad_lump(wad, "F_END", NULL, 0);
}

void wad_write_looks(struct wad_writer *wad)
{
    uint8_t palette[768], rows[32 * 256];
    for (int i = 0; i < 256; i++) {
        palette[3 * i] = (uint8_t)i;
        palette[3 * i + 1] = (uint8_t)i;
        palette[3 * i + 2] = (uint8_t)(i / 2);
    }
    for (int row = 0; row < 32; row++)
        for (int i = 0; i < 256; i++)
            rows[256 * row + i] = (uint8_t)(i * (32 - row) / 32);
    wad_lump(wad, "PLAYPAL", palette, sizeof palette);
    wad_lump(wad, "COLORMAP", rows, sizeof rows);
    write_textures(wad);
    for (int i = 0; i < TEXTURE_COUNT; i++)
        write_patch(wad, TEXTURES[i].patch, TEXTURES[i].w_px, TEXTURES[i].h_px, TEXTURES[i].colour);
    write_flats(wad);
}

/* Maps --------------------------------------------------------------------------------------- */

unsigned wad_vertex(struct wad_map *map, int x, int y)
{
    map->vertices[map->vertex_count][0] = (int16_t)x;
    map->vertices[map->vertex_count][1] = (int16_t)y;
    return (unsigned)map->vertex_count++;
}

unsigned wad_sector(struct wad_map *map, int floor, int ceiling, int light, const char *floor_flat,
                    const char *ceiling_flat)
{
    const size_t i = map->sector_count++;
    map->sectors[i].floor = (int16_t)floor;
    map->sectors[i].ceiling = (int16_t)ceiling;
    map->sectors[i].light = (int16_t)light;
    name_to(map->sectors[i].names[0], floor_flat);
    name_to(map->sectors[i].names[1], ceiling_flat);
    return (unsigned)i;
}

unsigned wad_side(struct wad_map *map, unsigned sector, const char *upper, const char *lower, const char *middle)
{
    const size_t i = map->side_count++;
    const char *const names[3] = {upper, lower, middle};
    for (int k = 0; k < 3; k++)
        name_to(map->sides[i].names[k], names[k]);
    map->sides[i].sector = (uint16_t)sector;
    map->sides[i].offsets[0] = map->sides[i].offsets[1] = 0;
    return (unsigned)i;
}

unsigned wad_line(struct wad_map *map, unsigned from, unsigned to, unsigned flags, unsigned right, unsigned left)
{
    const uint16_t line[7] = {(uint16_t)from, (uint16_t)to, (uint16_t)flags, 0, 0, (uint16_t)right, (uint16_t)left};
    memcpy(map->lines[map->line_count], line, sizeof line);
    return (unsigned)map->line_count++;
}

void wad_thing(struct wad_map *map, int x, int y, int angle, int kind)
{
    const int16_t thing[5] = {(int16_t)x, (int16_t)y, (int16_t)angle, (int16_t)kind, 7};
    memcpy(map->things[map->thing_count++], thing, sizeof thing);
}

void wad_room(struct wad_map *map, int left, int bottom, int side, unsigned sector)
{
    const unsigned first = wad_vertex(map, left, bottom);
    wad_vertex(map, left, bottom + side);
    wad_vertex(map, left + side, bottom + side);
    wad_vertex(map, left + side, bottom);
    for (unsigned i = 0; i < 4; i++)
        wad_line(map, first + i, first + (i + 1) % 4, 1, wad_side(map, sector, "-", "-", "WALL"), WAD_NO_SIDE);
}

void wad_write_map(struct wad_writer *wad, const char *name, const struct wad_map *map)
{
    uint8_t bytes[30 * WAD_MAP_MOST];
    wad_lump(wad, name, NULL, 0);
    for (size_t i = 0; i < map->thing_count; i++)
        for (int k = 0; k < 5; k++)
            put(bytes + 10 * i + 2 * (size_t)k, (uint16_t)map->things[i][k], 2);
    wad_lump(wad, "THINGS", bytes, 10 * map->thing_count);
    for (size_t i = 0; i < map->line_count; i++)
        for (int k = 0; k < 7; k++)
            put(bytes + 14 * i + 2 * (size_t)k, map->lines[i][k], 2);
    wad_lump(wad, "LINEDEFS", bytes, 14 * map->line_count);
    for (size_t i = 0; i < map->side_count; i++) {
        put(bytes + 30 * i, (uint16_t)map->sides[i].offsets[0], 2);
        put(bytes + 30 * i + 2, (uint16_t)map->sides[i].offsets[1], 2);
        memcpy(bytes + 30 * i + 4, map->sides[i].names, 24);
        put(bytes + 30 * i + 28, map->sides[i].sector, 2);
    }
    wad_lump(wad, "SIDEDEFS", bytes, 30 * map->side_count);
    for (size_t i = 0; i < map->vertex_count; i++) {
        put(bytes + 4 * i, (uint16_t)map->vertices[i][0], 2);
        put(bytes + 4 * i + 2, (uint16_t)map->vertices[i][1], 2);
    }
    wad_lump(wad, "VERTEXES", bytes, 4 * map->vertex_count);
    for (size_t i = 0; i < map->sector_count; i++) {
        memset(bytes + 26 * i, 0, 26);
        put(bytes + 26 * i, (uint16_t)map->sectors[i].floor, 2);
        put(bytes + 26 * i + 2, (uint16_t)map->sectors[i].ceiling, 2);
        memcpy(bytes + 26 * i + 4, map->sectors[i].names, 16);
        put(bytes + 26 * i + 20, (uint16_t)map->sectors[i].light, 2);
        put(bytes + 26 * i + 24, (uint16_t)map->sectors[i].tag, 2);
    }
    wad_lump(wad, "SECTORS", bytes, 26 * map->sector_count);
}
