/* SPDX-License-Identifier: MIT
 *
 * Texels of one level of detail into a line: pixels along which the place in the picture advances evenly. In: a place
 * and the level, with what a pixel adds to a place. Out: pixels. Memory: the caller's. */
#ifndef LIM_TEXELS_H
#define LIM_TEXELS_H

#include "math/thumb.h"
#include "pixels/falls.h"
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

/* n pixels, from `to` to the one before `end`: eight at a time, with a jump past those that are too many. */
static LIM_INLINE void texels_paint_long(uint16_t *to, const uint16_t *end, uint_fast16_t n, uint32_t place,
                                         const LIM_FLASH uint8_t *texels, const LIM_FLASH uint16_t *palette,
                                         uint32_t rows_mask, uint32_t step, unsigned w_bits)
{
    const uint_fast16_t skipped = (0u - n) & 7;

    to -= skipped;
    // clang-format off
    switch (skipped) {
        do { LIM_FALL_THROUGH;
    case 0: LIM_TEXEL_NEXT(0); LIM_FALL_THROUGH;
    case 1: LIM_TEXEL_NEXT(1); LIM_FALL_THROUGH;
    case 2: LIM_TEXEL_NEXT(2); LIM_FALL_THROUGH;
    case 3: LIM_TEXEL_NEXT(3); LIM_FALL_THROUGH;
    case 4: LIM_TEXEL_NEXT(4); LIM_FALL_THROUGH;
    case 5: LIM_TEXEL_NEXT(5); LIM_FALL_THROUGH;
    case 6: LIM_TEXEL_NEXT(6); LIM_FALL_THROUGH;
    case 7: LIM_TEXEL_NEXT(7);
            to += 8;
        } while (to != end);
    }
    // clang-format on
}

/* Where stores reach no memory before an address, what lies before `end` is counted from eight pixels farther back. */
enum { LIM_TEXELS_BACK = LIM_WRITTEN_THUMB ? 8 : 0 };

static inline uint16_t *texels_back(uint16_t *end)
{
    end -= LIM_TEXELS_BACK;
    FOUND_FROM(end); /* else the compiler would count from `end` all the same */
    return end;
}

/* What is told that the return address is lost keeps it on the stack: one instruction then restores registers and
 * returns, instead of two. */
#if defined(__thumb2__)
#define LIM_TEXELS_RETURN() __asm__ volatile("" : : : "lr")
#else
#define LIM_TEXELS_RETURN() ((void)0)
#endif

/* As lim_texels_painter has it. Up to eight pixels, as most are, without a loop. That n may be 0 spares the jump a
 * subtraction. */
static LIM_INLINE void lim_texels_paint_sized(uint16_t *end, uint_fast16_t n, uint32_t place,
                                              const struct lim_texture_level *level, unsigned w_bits)
{
    const LIM_FLASH uint8_t *const texels = level->texels;
    const LIM_FLASH uint16_t *const palette = level->palette;
    const uint32_t rows_mask = level->rows_mask, step = level->step;
    uint16_t *const to = texels_back(end);

    end = to + LIM_TEXELS_BACK;
    LIM_TEXELS_RETURN();
    // clang-format off
    switch (n) {
    default: texels_paint_long(end - n, end, n, place, texels, palette, rows_mask, step, w_bits);
             return;
    case 0:
    case 8: LIM_TEXEL_NEXT(LIM_TEXELS_BACK - 8); LIM_FALL_THROUGH;
    case 7: LIM_TEXEL_NEXT(LIM_TEXELS_BACK - 7); LIM_FALL_THROUGH;
    case 6: LIM_TEXEL_NEXT(LIM_TEXELS_BACK - 6); LIM_FALL_THROUGH;
    case 5: LIM_TEXEL_NEXT(LIM_TEXELS_BACK - 5); LIM_FALL_THROUGH;
    case 4: LIM_TEXEL_NEXT(LIM_TEXELS_BACK - 4); LIM_FALL_THROUGH;
    case 3: LIM_TEXEL_NEXT(LIM_TEXELS_BACK - 3); LIM_FALL_THROUGH;
    case 2: LIM_TEXEL_NEXT(LIM_TEXELS_BACK - 2); LIM_FALL_THROUGH;
    case 1: LIM_TEXEL_NEXT(LIM_TEXELS_BACK - 1);
    }
    // clang-format on
}

/* What paints a level: a function for each width, or, where small code is asked for, one for all. */
extern lim_texels_painter *const LIM_FLASH lim_texels_painters[11];
lim_texels_painter lim_texels_paint_any;

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
}

#endif

#endif
