/* SPDX-License-Identifier: MIT
 *
 * All levels lie in one picture while libgd chooses the palette, so that the small ones have a say in it too. */
#include "model/mipmap.h"

#include "scene.h"

#include <gd.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Level k lies below the ones before it, at the left. */
struct atlas {
    gdImagePtr image;
    int w_px, h_px; /* of level 0 */
    int levels;
};

uint8_t texture_side_bits(uint32_t side_px, uint8_t most_bits)
{
    const double bits = floor(log2(side_px) + 0.5);
    return bits < most_bits ? (uint8_t)bits : most_bits;
}

uint8_t texture_levels(uint8_t w_bits, uint8_t h_bits)
{
    return (uint8_t)((w_bits < h_bits ? w_bits : h_bits) + 1);
}

size_t texture_texels(uint8_t w_bits, uint8_t h_bits)
{
    size_t count = 0;
    for (unsigned k = 0; k < texture_levels(w_bits, h_bits); k++)
        count += (size_t)1 << (w_bits + h_bits - 2 * k);
    return (count + LIM_TEXEL_BLOCK - 1) / LIM_TEXEL_BLOCK * LIM_TEXEL_BLOCK;
}

static int level_y(const struct atlas *atlas, int level)
{
    int y = 0;
    for (int k = 0; k < level; k++)
        y += atlas->h_px >> k;
    return y;
}

static uint32_t pixel_of(const struct picture *picture, bool transposed, int x, int y)
{
    const size_t column = (size_t)(transposed ? y : x), row = (size_t)(transposed ? x : y);
    return picture->pixels[row * picture->w_px + column];
}

/* Linear interpolation where it grows, means of areas where it shrinks. */
static gdImagePtr resized(const struct picture *picture, bool transposed, int w_px, int h_px)
{
    const int from_w_px = (int)(transposed ? picture->h_px : picture->w_px);
    const int from_h_px = (int)(transposed ? picture->w_px : picture->h_px);
    gdImagePtr from = gdImageCreateTrueColor(from_w_px, from_h_px), to = gdImageCreateTrueColor(w_px, h_px);
    for (int y = 0; from && y < from_h_px; y++)
        for (int x = 0; x < from_w_px; x++)
            from->tpixels[y][x] = (int)(pixel_of(picture, transposed, x, y) & 0xFFFFFF);
    if (from && to) gdImageCopyResampled(to, from, 0, 0, 0, 0, w_px, h_px, from_w_px, from_h_px);
    if (from && to) return gdImageDestroy(from), to;
    if (from) gdImageDestroy(from);
    if (to) gdImageDestroy(to);
    return NULL;
}

static int mean_of(const struct atlas *atlas, int x, int y)
{
    int **rows = atlas->image->tpixels, mean = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const int sum = (rows[y][x] >> shift & 0xFF) + (rows[y][x + 1] >> shift & 0xFF) +
                        (rows[y + 1][x] >> shift & 0xFF) + (rows[y + 1][x + 1] >> shift & 0xFF);
        mean |= (sum + 2) / 4 << shift;
    }
    return mean;
}

static void halve(struct atlas *atlas, int level)
{
    const int from_y = level_y(atlas, level - 1), to_y = level_y(atlas, level);
    for (int y = 0; y < atlas->h_px >> level; y++)
        for (int x = 0; x < atlas->w_px >> level; x++)
            atlas->image->tpixels[to_y + y][x] = mean_of(atlas, 2 * x, from_y + 2 * y);
}

/* What the smaller levels leave of their lines is filled with the lines of the level before: a palette weighs it
 * as often as it is there. */
static bool atlas_make(struct atlas *atlas, const struct picture *picture, bool transposed)
{
    gdImagePtr first = resized(picture, transposed, atlas->w_px, atlas->h_px);
    atlas->image = first ? gdImageCreateTrueColor(atlas->w_px, level_y(atlas, atlas->levels)) : NULL;
    if (atlas->image)
        for (int y = 0; y < gdImageSY(atlas->image); y++)
            memcpy(atlas->image->tpixels[y], first->tpixels[y % atlas->h_px], (size_t)atlas->w_px * sizeof(int));
    if (first) gdImageDestroy(first);
    for (int level = 1; atlas->image && level < atlas->levels; level++)
        halve(atlas, level);
    return atlas->image != NULL;
}

static uint32_t mean_colour(const struct atlas *atlas)
{
    uint32_t mean = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
        double sum = 0;
        for (int y = 0; y < atlas->h_px; y++)
            for (int x = 0; x < atlas->w_px; x++)
                sum += atlas->image->tpixels[y][x] >> shift & 0xFF;
        mean |= (uint32_t)(sum / atlas->w_px / atlas->h_px + 0.5) << shift;
    }
    return mean;
}

static void copy_texels(const struct atlas *atlas, struct texture *out)
{
    uint8_t *to = out->texels;
    for (int level = 0; level < atlas->levels; level++)
        for (int y = 0; y < atlas->h_px >> level; y++, to += atlas->w_px >> level)
            memcpy(to, atlas->image->pixels[level_y(atlas, level) + y], (size_t)(atlas->w_px >> level));
    out->colours = (uint32_t)gdImageColorsTotal(atlas->image);
    for (int i = 0; i < (int)out->colours; i++)
        out->palette[i] = (uint32_t)gdImageRed(atlas->image, i) << 16 | (uint32_t)gdImageGreen(atlas->image, i) << 8 |
                          (uint32_t)gdImageBlue(atlas->image, i);
}

bool texture_make(const struct picture *picture, uint8_t most_bits, struct texture *out)
{
    const uint8_t w_bits = texture_side_bits(picture->w_px, most_bits);
    const uint8_t h_bits = texture_side_bits(picture->h_px, most_bits);
    *out = (struct texture){.w_bits = w_bits > h_bits ? w_bits : h_bits,
                            .h_bits = w_bits > h_bits ? h_bits : w_bits,
                            .transposed = h_bits > w_bits};
    out->levels = texture_levels(out->w_bits, out->h_bits);
    out->texel_count = texture_texels(out->w_bits, out->h_bits);
    struct atlas atlas = {NULL, 1 << out->w_bits, 1 << out->h_bits, out->levels};
    out->texels = calloc(out->texel_count, 1);
    bool ok = out->texels && atlas_make(&atlas, picture, out->transposed);
    if (ok) {
        out->mean = mean_colour(&atlas);
        ok = gdImageTrueColorToPalette(atlas.image, 0, TEXTURE_COLOURS) && !gdImageTrueColor(atlas.image);
    }
    if (ok) copy_texels(&atlas, out);
    if (atlas.image) gdImageDestroy(atlas.image);
    if (!ok) texture_free(out);
    return ok;
}

void texture_free(struct texture *texture)
{
    free(texture->texels);
    *texture = (struct texture){0};
}
