/* SPDX-License-Identifier: MIT
 *
 * PLAYPAL has the palette, PNAMES the names of patches, TEXTURE1 and TEXTURE2 which of them make up a wall texture,
 * COLORMAP what becomes of the palette in 32 steps of darkness. Source: Fell, The Unofficial Doom Specs 1.666, 1994,
 * chapters 5 and 8. */
#include "levels/level_textures.h"

#include "base/grow.h"

#include <stdlib.h>
#include <string.h>

enum {
    PALETTE_B = 768,
    COLOUR_ROW_B = 256,
    TEXTURE_HEADER_B = 22,
    TEXTURE_PATCH_B = 10,
    SIDE_MAX_PX = TEXTURE_SIDE_MAX_PX
};

/* Doom makes light fall off with distance, by rows of the colour map. What is baked is light at 80 units: a row
 * of its table is (15 - level) * 4 - 1280 / distance (linuxdoom, r_main.c). */
enum { LIGHT_LEVELS = 16, ROWS_A_LEVEL = 4, ROWS_NEARER = 16, LIGHT_SHIFT = 4 };

/* Colours ------------------------------------------------------------------------------------ */

static uint32_t colour_of(const struct level_textures *textures, int index)
{
    const uint8_t *rgb = textures->palette->bytes + 3 * index;
    return (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
}

static unsigned brightness(const uint8_t *rgb)
{
    return 2u * rgb[0] + 5u * rgb[1] + rgb[2];
}

/* How bright a row of the colour map leaves the palette; without one, evenly darker. */
static void read_light(struct level_textures *textures)
{
    const struct wad_lump *map = wad_find(textures->wad, "COLORMAP", WAD_GLOBAL);
    const uint8_t *palette = textures->palette->bytes;
    const bool is_there = map && map->bytes && map->size_b >= LEVEL_LIGHT_ROWS * COLOUR_ROW_B;
    double full = 0;
    for (int i = 0; i < COLOUR_ROW_B; i++)
        full += brightness(palette + 3 * i);
    for (int row = 0; row < LEVEL_LIGHT_ROWS; row++) {
        double sum = 0;
        for (int i = 0; i < COLOUR_ROW_B && is_there; i++)
            sum += brightness(palette + 3 * map->bytes[row * COLOUR_ROW_B + i]);
        textures->light[row] = is_there && full > 0 ? sum / full : 1.0 - row / (double)LEVEL_LIGHT_ROWS;
    }
}

uint32_t level_light(const struct level_textures *textures, int sector_light, int contrast)
{
    int level = (sector_light < 0 ? 0 : sector_light > 255 ? 255 : sector_light) >> LIGHT_SHIFT;
    level += contrast;
    if (level < 0) level = 0;
    if (level >= LIGHT_LEVELS) level = LIGHT_LEVELS - 1;
    int row = (LIGHT_LEVELS - 1 - level) * ROWS_A_LEVEL - ROWS_NEARER;
    if (row < 0) row = 0;
    if (row >= LEVEL_LIGHT_ROWS) row = LEVEL_LIGHT_ROWS - 1;
    double light = textures->light[row];
    if (light > 1) light = 1;
    return (uint32_t)(255 * light + 0.5) * 0x010101u;
}

/* Of texels: the mean colour of those that are not clear, and the pixels. */
static void take(const struct level_textures *textures, const struct level_picture *picture, struct level_look *look)
{
    const size_t count = (size_t)picture->w_px * picture->h_px;
    double sums[3] = {0};
    size_t clear = 0;
    look->w_px = picture->w_px;
    look->h_px = picture->h_px;
    look->is_known = look->is_one_colour = true;
    for (size_t i = 0; i < count; i++) {
        look->is_one_colour &= picture->texels[i] == picture->texels[0];
        clear += picture->texels[i] == CLEAR_TEXEL;
        for (int channel = 0; channel < 3 && picture->texels[i] != CLEAR_TEXEL; channel++)
            sums[channel] += textures->palette->bytes[3 * picture->texels[i] + channel];
    }
    for (int channel = 0; channel < 3 && clear < count; channel++)
        look->mean = look->mean << 8 | (uint32_t)(sums[channel] / (double)(count - clear) + 0.5);
    look->clear = (double)clear / (double)count;
    look->pixels = grow_zeroed(count, sizeof *look->pixels);
    for (size_t i = 0; i < count; i++)
        look->pixels[i] =
            picture->texels[i] == CLEAR_TEXEL ? PICTURE_CLEAR | look->mean : colour_of(textures, picture->texels[i]);
}

/* Wall textures ------------------------------------------------------------------------------ */

/* Every texture of a list is within it then. */
static bool check_list(const struct wad *wad, const struct wad_lump *list, struct error *err)
{
    const char *path = wad->paths[list->file];
    if (!wad_lump_is_whole(wad, list, err)) return false;
    const size_t count = list->size_b >= 4 ? wad_u32(list->bytes) : 0;
    if (list->size_b < 4 || count > (list->size_b - 4) / 4)
        return error_set(err, "%s: lump %s: truncated: it ends within its list of %zu textures", path, list->name,
                         count);
    for (size_t i = 0; i < count; i++) {
        const size_t at = wad_u32(list->bytes + 4 + 4 * i);
        if (at > list->size_b || list->size_b - at < TEXTURE_HEADER_B)
            return error_set(err, "%s: lump %s: texture %zu is not within it", path, list->name, i);
        const size_t patches = wad_u16(list->bytes + at + 20);
        if (list->size_b - at - TEXTURE_HEADER_B < patches * TEXTURE_PATCH_B)
            return error_set(err, "%s: lump %s: texture %zu: its %zu patches are not within it", path, list->name, i,
                             patches);
    }
    return true;
}

static const uint8_t *find_in(const struct wad_lump *list, const char *name)
{
    char other[WAD_NAME_B];
    const size_t count = list ? wad_u32(list->bytes) : 0;
    for (size_t i = 0; i < count; i++) {
        const uint8_t *texture = list->bytes + wad_u32(list->bytes + 4 + 4 * i);
        wad_name(texture, other);
        if (strcmp(other, name) == 0) return texture;
    }
    return NULL;
}

static void note_broken(struct level_textures *textures, const char *name, const char *part)
{
    if (textures->broken_count++) return;
    memcpy(textures->broken, name, WAD_NAME_B);
    memcpy(textures->broken_part, part, WAD_NAME_B);
}

static void draw_patch(struct level_textures *textures, const uint8_t *patch, const char *texture,
                       struct level_picture *picture)
{
    char name[WAD_NAME_B] = "?";
    const struct wad_lump *names = textures->patch_names;
    const size_t count = names->size_b >= 4 ? (names->size_b - 4) / 8 : 0, index = wad_u16(patch + 4);
    const struct wad_lump *lump = NULL;
    if (index < count) {
        wad_name(names->bytes + 4 + 8 * index, name);
        lump = wad_find(textures->wad, name, WAD_GLOBAL);
    }
    if (!lump || !level_patch_draw(lump, wad_s16(patch), wad_s16(patch + 2), picture))
        note_broken(textures, texture, name);
}

static void compose(struct level_textures *textures, const uint8_t *texture, struct level_look *look)
{
    struct level_picture picture = {wad_u16(texture + 12), wad_u16(texture + 14), NULL};
    const size_t count = (size_t)picture.w_px * picture.h_px;
    if (count == 0 || picture.w_px > SIDE_MAX_PX || picture.h_px > SIDE_MAX_PX) {
        note_broken(textures, look->name, look->name);
        return;
    }
    picture.texels = grow_zeroed(count, sizeof *picture.texels);
    for (size_t i = 0; i < count; i++)
        picture.texels[i] = CLEAR_TEXEL;
    for (size_t i = 0; i < wad_u16(texture + 20); i++)
        draw_patch(textures, texture + TEXTURE_HEADER_B + i * TEXTURE_PATCH_B, look->name, &picture);
    take(textures, &picture, look);
    level_picture_free(&picture);
}

/* -------------------------------------------------------------------------------------------- */

bool level_textures_open(const struct wad *wad, struct level_textures *out, struct error *err)
{
    *out = (struct level_textures){.wad = wad};
    out->palette = wad_take(wad, "PLAYPAL", WAD_GLOBAL, err);
    out->patch_names = out->palette ? wad_take(wad, "PNAMES", WAD_GLOBAL, err) : NULL;
    out->lists[0] = out->patch_names ? wad_take(wad, "TEXTURE1", WAD_GLOBAL, err) : NULL;
    if (!out->lists[0]) return false;
    if (out->palette->size_b < PALETTE_B)
        return error_set(err, "%s: lump PLAYPAL: truncated: %zu bytes, a palette has %d",
                         wad->paths[out->palette->file], out->palette->size_b, PALETTE_B);
    out->lists[1] = wad_find(wad, "TEXTURE2", WAD_GLOBAL);
    for (int i = 0; i < 2; i++)
        if (out->lists[i] && !check_list(wad, out->lists[i], err)) return false;
    read_light(out);
    return true;
}

void level_textures_close(struct level_textures *textures)
{
    for (size_t i = 0; i < textures->look_count; i++)
        free(textures->looks[i].pixels);
    free(textures->looks);
    *textures = (struct level_textures){0};
}

static void find_flat(struct level_textures *textures, struct level_look *look)
{
    struct level_picture picture;
    const struct wad_lump *lump = wad_find(textures->wad, look->name, WAD_FLATS);
    if (!lump) return;
    if (!level_flat_read(lump, &picture)) {
        note_broken(textures, look->name, look->name);
        return;
    }
    take(textures, &picture, look);
    level_picture_free(&picture);
}

size_t level_look(struct level_textures *textures, enum level_look_kind kind, const char *name)
{
    for (size_t i = 0; i < textures->look_count; i++)
        if (textures->looks[i].kind == kind && strcmp(textures->looks[i].name, name) == 0) return i;
    textures->looks = grow(textures->looks, textures->look_count, &textures->look_capacity, sizeof *textures->looks);
    struct level_look *look = &textures->looks[textures->look_count++];
    *look = (struct level_look){.kind = kind};
    wad_name_of_text(name, look->name);
    const uint8_t *texture = kind == LOOK_WALL ? find_in(textures->lists[0], name) : NULL;
    if (!texture && kind == LOOK_WALL) texture = find_in(textures->lists[1], name);
    if (texture) compose(textures, texture, look);
    if (kind == LOOK_FLAT) find_flat(textures, look);
    if (!look->is_known && !textures->unknown_count++) memcpy(textures->unknown, look->name, WAD_NAME_B);
    return textures->look_count - 1;
}
