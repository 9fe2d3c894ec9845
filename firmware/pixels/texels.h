/* SPDX-License-Identifier: MIT
 *
 * Texels of one level of detail into a line: pixels along which the place in the picture advances evenly. In: a place
 * and the level, with what a pixel adds to a place. Out: pixels. Memory: the caller's. */
#ifndef LIM_TEXELS_H
#define LIM_TEXELS_H

#include "scene.h"
#include "texturing.h"

/* The texel at a place: columns from its upper half, rows from its lower one. A picture's rows are as long as it is
 * wide at this level, 2^w_bits, a constant wherever time matters: two instructions then, on processors that shift what
 * they add. The rows' mask leaves those that the picture has: it is at most as high as it is wide. */
static LIM_INLINE uint_fast16_t lim_texel_at(uint32_t place, uint32_t rows_mask, unsigned w_bits)
{
    if (!w_bits) return 0;
    const uint32_t rows = w_bits <= 8 ? place >> (16 - 2 * w_bits) : place << (2 * w_bits - 16);

    return (uint_fast16_t)((rows & rows_mask) + (place >> (32 - w_bits)));
}

#if LIM_HAS_TEXTURE

#define LIM_TEXEL_NEXT(k)                                                                                              \
    to[k] = palette[texels[lim_texel_at(place, rows_mask, w_bits)]];                                                   \
    place += step

/* Up to so many pixels a jump past those that are too many would take longer than to count them. */
enum { LIM_TEXELS_FEW = 4 };

/* n pixels, one at least. Eight at a time, with a jump past those that are too many. */
static LIM_INLINE void lim_texels_paint_sized(uint16_t *to, uint_fast16_t n, uint32_t place,
                                              const struct lim_texture_level *level, unsigned w_bits)
{
    const LIM_FLASH uint8_t *const texels = level->texels;
    const LIM_FLASH uint16_t *const palette = level->palette;
    const uint32_t rows_mask = level->rows_mask, step = level->step;
    uint16_t *const end = to + n;

    if (n <= LIM_TEXELS_FEW) {
        do {
            LIM_TEXEL_NEXT(0);
        } while (++to != end);
        return;
    }
    const uint_fast16_t skipped = (0u - n) & 7;
    to -= skipped;
    // clang-format off
    switch (skipped) {
        do {
    case 0: LIM_TEXEL_NEXT(0); /* fall through */
    case 1: LIM_TEXEL_NEXT(1); /* fall through */
    case 2: LIM_TEXEL_NEXT(2); /* fall through */
    case 3: LIM_TEXEL_NEXT(3); /* fall through */
    case 4: LIM_TEXEL_NEXT(4); /* fall through */
    case 5: LIM_TEXEL_NEXT(5); /* fall through */
    case 6: LIM_TEXEL_NEXT(6); /* fall through */
    case 7: LIM_TEXEL_NEXT(7);
            to += 8;
        } while (to != end);
    }
    // clang-format on
}

/* What paints a level: a function for each width, or, where small code is asked for, one for all. */
extern lim_texels_painter *const LIM_FLASH lim_texels_painters[11];
void lim_texels_paint_any(uint16_t *to, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level);

/* A level of a texture, but for its step and number. */
static LIM_INLINE void lim_texels_take_level(const struct lim_scene *scene, const LIM_FLASH struct lim_texture *texture,
                                             uint_fast8_t number, struct lim_texture_level *level)
{
    const uint_fast8_t w_bits = (uint_fast8_t)(texture->w_bits - number);
    const LIM_FLASH uint8_t *texels = scene->texels + (uint32_t)texture->texels * LIM_TEXEL_BLOCK;
    uint32_t size = UINT32_C(1) << (texture->w_bits + texture->h_bits);

    level->palette = scene->palettes + texture->palette;
    for (uint_fast8_t i = number; i; i--, size >>= 2)
        texels += size;
    level->texels = texels;
    level->w_bits = (uint8_t)w_bits;
    level->rows_mask = size - (UINT32_C(1) << w_bits);
    level->paint = LIM_OPTIMISE_SIZE ? lim_texels_paint_any : lim_texels_painters[w_bits];
}

#endif

/* n pixels of it. */
static inline void lim_texels_paint(uint16_t *to, uint_fast16_t n, uint32_t place,
                                    const struct lim_texture_level *level)
{
    level->paint(to, n, place, level);
}

#endif
