/* SPDX-License-Identifier: MIT
 *
 * What of a textured polygon depends on its scene's coordinates, and the arithmetic for it: texture.c finds it in
 * scenes of 16 bits, texture_long.c in those of 32. */
#ifndef LIM_TEXTURE_SEEN_H
#define LIM_TEXTURE_SEEN_H

#include "pixels/texture_planes.h"

enum { PLANE_BITS = 30 };

/* The eye's distance from the mapping's plane, in the length of its normal: h = mantissa 2^(bits - 8), mantissa of 31
 * bits. */
struct height {
    int32_t mantissa;
    int8_t bits;
    bool behind;
};

/* What has to be known before it is decided how to draw. */
struct seen {
    struct lim_texture_plane depth, uv[2]; /* n . D, a . D */
    struct height height;
    uint32_t eye_uv_q16[2];
    int16_t level_q4; /* as in struct lim_texture_planes */
    int8_t shift, depth_bits;
};

/* The same of a scene whose coordinates have 32 bits; `number` of its mappings. */
void lim_texture_see_long(const struct lim_texturing *texturing, uint16_t number, struct seen *seen);

/* x / 2^bits, or what of it 32 bits hold. */
static inline int32_t lim_texture_scaled(int32_t x, int_fast16_t bits)
{
    return bits >= 0 ? x >> (bits < 31 ? bits : 31) : (int32_t)((uint32_t)x << -bits);
}

/* For either memory: an AVR reads flash otherwise. */
#if LIM_DUAL_MULTIPLY
#define DOT_OF_PAIRS(a, b) ((int32_t)fixed_dot_pairs(a, b, 0))
#else
#define DOT_OF_PAIRS(a, b) ((int32_t)(a)[0] * (b)[0] + (int32_t)(a)[1] * (b)[1])
#endif

static inline int32_t dot_3(const int16_t *a, const int16_t *b)
{
    return DOT_OF_PAIRS(a, b) + (int32_t)a[2] * b[2];
}

/* The components add up to 32767 at most: below 2^30 with both limbs. */
static inline int32_t normal_q15(const int16_t n[3], const struct lim_texture_axis *axis)
{
    return dot_3(n, axis->high_q14) * 2 + (dot_3(n, axis->low_q30) >> 15);
}

/* What a plane may be at most, in 2^12. X goes three times as far as the screen: a stretch's end may lie beyond. A
 * polygon's surroundings reach a line or two beyond it. There is room for twice the screen, which is too little where
 * it has one line or two: then it counts as one of four. */
static inline uint32_t most_of(const struct lim_texturing *texturing, const struct lim_texture_plane *plane)
{
    const int32_t h_px = texturing->h_px > 2 ? texturing->h_px : 4;

    return (abs_s32(plane->at) >> 12) + 3 +
           (uint32_t)lim_texture_scaled((int32_t)(abs_s32(plane->x) >> 12) * 3 * texturing->w_px,
                                        texturing->axis_bits[0]) +
           (uint32_t)lim_texture_scaled((int32_t)(abs_s32(plane->y) >> 12) * h_px, texturing->axis_bits[1]);
}

/* Scales planes until the larger one fills PLANE_BITS, and says by how many bits. Without limbs they are left as they
 * are. */
static inline int8_t fill_bits(const struct lim_texturing *texturing, struct lim_texture_plane *planes,
                               uint_fast8_t count)
{
    uint32_t most = 0;

    if (!LIM_HAS_LIMBS) return texturing->axis_bits[2];
    for (uint_fast8_t i = 0; i < count; i++)
        most |= most_of(texturing, &planes[i]);
    const int8_t bits = (int8_t)(clz_u32(most) - (32 - PLANE_BITS + 12));
    for (uint_fast8_t i = 0; i < count; i++) {
        planes[i].at = lim_texture_scaled(planes[i].at, -bits);
        planes[i].x = lim_texture_scaled(planes[i].x, texturing->axis_bits[0] - bits);
        planes[i].y = lim_texture_scaled(planes[i].y, texturing->axis_bits[1] - bits);
    }
    return bits;
}

/* Of a height that is high * 2^32 + low, in 2^-8. */
static inline struct height height_of_words(uint32_t high, uint32_t low, bool behind)
{
    struct height height = {.behind = behind};
    uint8_t zeros;

    if (high) {
        const uint32_t mantissa = normalise_u32(high, &zeros);
        height.mantissa = (int32_t)((mantissa | low >> 1 >> (31 - zeros)) >> 1);
        height.bits = (int8_t)(33 - zeros);
    } else {
        height.mantissa = (int32_t)(normalise_u32(low ? low : 1, &zeros) >> 1);
        height.bits = (int8_t)(1 - zeros);
    }
    return height;
}

static inline void negate(struct lim_texture_plane *plane)
{
    plane->at = -plane->at;
    plane->x = -plane->x;
    plane->y = -plane->y;
}

#endif
