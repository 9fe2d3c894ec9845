/* SPDX-License-Identifier: MIT
 *
 * All levels lie in one picture while libgd chooses the palette, so that the small ones have a say in it too. Of a
 * masked picture opacities lie beside them (coverage.h). */
#include "model/mipmap.h"

#include "model/coverage.h"
#include "scene.h"

#include <gd.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SKY_LEAST_BITS = 8, SKY_ENDS = 16 }; /* a sky's ends are the mean of a 16th of its rows */
enum { MASKED_LAST_BITS = 2 }; /* the shorter side of a masked texture's last level, where it is longer at all */

/* Level k lies below the ones before it, at the left. */
struct atlas {
    gdImagePtr image;
    int w_px, h_px; /* of level 0 */
    int levels;
    double *opacity; /* of each pixel, 0..1; NULL: all are opaque */
};

double picture_clear_share(const struct picture *picture)
{
    const size_t count = (size_t)picture->w_px * picture->h_px;
    size_t clear = 0;
    for (size_t i = 0; i < count; i++)
        clear += (picture->pixels[i] & PICTURE_CLEAR) != 0;
    return count ? (double)clear / (double)count : 0;
}

uint8_t picture_transparency(const struct picture *picture)
{
    const double share = picture_clear_share(picture);
    if (share <= 0 || share >= 1) return share > 0 ? 255 : 0;
    return (uint8_t)fmin(fmax(255 * share + 0.5, 1), 254);
}

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

/* As libgd has it, where a colour's share is that of what is opaque. */
static int gd_pixel(uint32_t pixel)
{
    return (int)(pixel & 0xFFFFFF) | (pixel & PICTURE_CLEAR ? gdAlphaTransparent << 24 : 0);
}

/* Linear interpolation where it grows, means of areas where it shrinks. */
static gdImagePtr resized(const struct picture *picture, bool transposed, int w_px, int h_px)
{
    const int from_w_px = (int)(transposed ? picture->h_px : picture->w_px);
    const int from_h_px = (int)(transposed ? picture->w_px : picture->h_px);
    gdImagePtr from = gdImageCreateTrueColor(from_w_px, from_h_px), to = gdImageCreateTrueColor(w_px, h_px);
    for (int y = 0; from && y < from_h_px; y++)
        for (int x = 0; x < from_w_px; x++)
            from->tpixels[y][x] = gd_pixel(pixel_of(picture, transposed, x, y));
    if (to) gdImageAlphaBlending(to, gdEffectReplace);
    if (from && to) gdImageCopyResampled(to, from, 0, 0, 0, 0, w_px, h_px, from_w_px, from_h_px);
    if (from && to) return gdImageDestroy(from), to;
    if (from) gdImageDestroy(from);
    if (to) gdImageDestroy(to);
    return NULL;
}

static double *opacity_at(const struct atlas *atlas, int x, int y)
{
    return &atlas->opacity[(size_t)y * (size_t)atlas->w_px + (size_t)x];
}

/* Of a masked picture: each colour counts as much as it is opaque. */
static int masked_mean_of(const struct atlas *atlas, int x, int y, double *opacity)
{
    double sums[3] = {0};
    *opacity = 0;
    for (int i = 0; i < 4; i++) {
        const int colour = atlas->image->tpixels[y + i / 2][x + i % 2];
        const double part = *opacity_at(atlas, x + i % 2, y + i / 2);
        for (int c = 0; c < 3; c++)
            sums[c] += part * (colour >> 8 * c & 0xFF);
        *opacity += part;
    }
    int mean = 0;
    for (int c = 0; c < 3 && *opacity > 0; c++)
        mean |= (int)(sums[c] / *opacity + 0.5) << 8 * c;
    *opacity /= 4;
    return mean;
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
            atlas->image->tpixels[to_y + y][x] =
                atlas->opacity ? masked_mean_of(atlas, 2 * x, from_y + 2 * y, opacity_at(atlas, x, to_y + y))
                               : mean_of(atlas, 2 * x, from_y + 2 * y);
}

/* From the first level's pixels, which lose them. */
static bool take_opacities(struct atlas *atlas)
{
    const int h_px = gdImageSY(atlas->image);
    atlas->opacity = calloc((size_t)atlas->w_px * (size_t)h_px, sizeof *atlas->opacity);
    for (int y = 0; atlas->opacity && y < h_px; y++)
        for (int x = 0; x < atlas->w_px; x++) {
            int *pixel = &atlas->image->tpixels[y][x];
            *opacity_at(atlas, x, y) = 1 - (double)gdTrueColorGetAlpha(*pixel) / gdAlphaTransparent;
            *pixel &= 0xFFFFFF;
        }
    return atlas->opacity != NULL;
}

/* Which texels of each level are clear; opacities are 0 or 1 from then on. Those that are clear take `mean`, so that no
 * colour of the palette is theirs alone. */
static bool mask_levels(struct atlas *atlas, double clear_share, uint32_t mean)
{
    for (int level = 0; level < atlas->levels; level++) {
        const int w_px = atlas->w_px >> level, h_px = atlas->h_px >> level, from_y = level_y(atlas, level);
        const struct coverage coverage = {opacity_at(atlas, 0, from_y), w_px, h_px, atlas->w_px};
        if (!coverage_keep(&coverage, 1 - clear_share)) return false;
    }
    for (int y = 0; y < gdImageSY(atlas->image); y++)
        for (int x = 0; x < atlas->w_px; x++)
            if (*opacity_at(atlas, x, y) <= 0) atlas->image->tpixels[y][x] = (int)mean;
    return true;
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
    if (atlas->image && picture->is_masked && !take_opacities(atlas)) return false;
    for (int level = 1; atlas->image && level < atlas->levels; level++)
        halve(atlas, level);
    return atlas->image != NULL;
}

static uint32_t mean_colour(const struct atlas *atlas)
{
    uint32_t mean = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
        double sum = 0, weights = 0;
        for (int y = 0; y < atlas->h_px; y++)
            for (int x = 0; x < atlas->w_px; x++) {
                const double weight = atlas->opacity ? *opacity_at(atlas, x, y) : 1;
                sum += weight * (atlas->image->tpixels[y][x] >> shift & 0xFF);
                weights += weight;
            }
        mean |= (uint32_t)(weights > 0 ? sum / weights + 0.5 : 0) << shift;
    }
    return mean;
}

static uint32_t mean_of_rows(const struct atlas *atlas, int from, int end)
{
    uint32_t mean = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
        double sum = 0;
        for (int y = from; y < end; y++)
            for (int x = 0; x < atlas->w_px; x++)
                sum += atlas->image->tpixels[y][x] >> shift & 0xFF;
        mean |= (uint32_t)(sum / atlas->w_px / (end - from) + 0.5) << shift;
    }
    return mean;
}

/* Those at the beginning of a palette that no texel of the picture has: of what is clear, or beyond a sky. */
static int own_colours(const struct texture *texture)
{
    return texture->sky.times ? 2 : texture->is_masked;
}

static void set_own_colours(const struct atlas *atlas, struct texture *out)
{
    const int rows = atlas->h_px > SKY_ENDS ? atlas->h_px / SKY_ENDS : 1;
    out->palette[0] = out->sky.times ? mean_of_rows(atlas, 0, rows) : out->mean;
    if (out->sky.times) out->palette[1] = mean_of_rows(atlas, atlas->h_px - rows, atlas->h_px);
}

static uint8_t texel_of(const struct atlas *atlas, int x, int y, int first)
{
    if (atlas->opacity && *opacity_at(atlas, x, y) <= 0) return 0;
    return (uint8_t)(atlas->image->pixels[y][x] + first);
}

static void copy_texels(const struct atlas *atlas, struct texture *out)
{
    uint8_t *to = out->texels;
    const int first = own_colours(out);
    for (int level = 0; level < atlas->levels; level++)
        for (int y = 0; y < atlas->h_px >> level; y++)
            for (int x = 0; x < atlas->w_px >> level; x++)
                *to++ = texel_of(atlas, x, level_y(atlas, level) + y, first);
    out->colours = (uint32_t)(gdImageColorsTotal(atlas->image) + first);
    for (int i = 0; i < gdImageColorsTotal(atlas->image); i++)
        out->palette[i + first] = (uint32_t)gdImageRed(atlas->image, i) << 16 |
                                  (uint32_t)gdImageGreen(atlas->image, i) << 8 | (uint32_t)gdImageBlue(atlas->image, i);
}

void texture_bits_of(const struct picture *picture, uint8_t most_bits, uint8_t *w_bits, uint8_t *h_bits)
{
    if (picture->sky.times && most_bits < SKY_LEAST_BITS) most_bits = SKY_LEAST_BITS;
    *w_bits = texture_side_bits(picture->w_px, most_bits);
    *h_bits = texture_side_bits(picture->h_px, picture->sky.times ? *w_bits : most_bits);
}

bool texture_make(const struct picture *picture, uint8_t most_bits, struct texture *out)
{
    uint8_t w_bits, h_bits;
    texture_bits_of(picture, most_bits, &w_bits, &h_bits);
    *out = (struct texture){.w_bits = w_bits > h_bits ? w_bits : h_bits,
                            .h_bits = w_bits > h_bits ? h_bits : w_bits,
                            .transposed = h_bits > w_bits,
                            .is_masked = picture->is_masked,
                            .sky = picture->sky};
    out->levels = texture_levels(out->w_bits, out->h_bits);
    if (out->is_masked) out->levels = out->levels > MASKED_LAST_BITS ? (uint8_t)(out->levels - MASKED_LAST_BITS) : 1;
    out->texel_count = texture_texels(out->w_bits, out->h_bits);
    struct atlas atlas = {NULL, 1 << out->w_bits, 1 << out->h_bits, out->levels, NULL};
    out->texels = calloc(out->texel_count, 1);
    bool ok = out->texels && atlas_make(&atlas, picture, out->transposed);
    if (ok) {
        out->mean = mean_colour(&atlas);
        if (out->is_masked) ok = mask_levels(&atlas, picture_clear_share(picture), out->mean);
        set_own_colours(&atlas, out);
        ok = ok && gdImageTrueColorToPalette(atlas.image, 0, TEXTURE_COLOURS - own_colours(out)) &&
             !gdImageTrueColor(atlas.image);
    }
    if (ok) copy_texels(&atlas, out);
    free(atlas.opacity);
    if (atlas.image) gdImageDestroy(atlas.image);
    if (!ok) texture_free(out);
    return ok;
}

void texture_free(struct texture *texture)
{
    free(texture->texels);
    *texture = (struct texture){0};
}
