/* SPDX-License-Identifier: MIT
 *
 * What setting up a textured polygon takes, whether its record names a mapping (texture.c) or its corners have places
 * (texture_triangle.c). Private to both. */
#ifndef LIM_TEXTURE_PLANES_H
#define LIM_TEXTURE_PLANES_H

#include "pixels/texture.h"

#if LIM_HAS_TEXTURE

enum { MIDDLE_OF_LEVEL_Q4 = 8 };

/* log2(x) for x >= 1. */
static inline int16_t log2_q4(uint32_t x)
{
    uint8_t zeros;
    const uint32_t mantissa_q31 = normalise_u32(x, &zeros);

    return (int16_t)(LIM_TEXTURE_LOG2_Q4 + (int16_t)(mantissa_q31 >> 27) - zeros * 16);
}

static inline int32_t plane_at(const struct lim_texture_plane *plane, int32_t x, int32_t y)
{
    return plane->at + plane->x * x + plane->y * y;
}

/* The pixels of the screen around a polygon: their middle, and how far they reach from there. */
struct around {
    int32_t x, y, w, h;
};

static inline void middle_of(int32_t least, int32_t most, int16_t side_px, int32_t *middle, int32_t *reach)
{
    int32_t from = (least >> LIM_SUB_BITS) + LIM_ORIGIN_PX, to = (most >> LIM_SUB_BITS) + LIM_ORIGIN_PX + 1;

    if (from < 0) from = 0;
    if (to > side_px) to = side_px;
    *middle = (from + to) >> 1;
    *reach = ((to - from) >> 1) + 1;
}

static inline struct around around_points(const struct lim_texturing *texturing, const struct lim_point *at, uint8_t n)
{
    struct around around;

    if (!n) {
        const int32_t w = texturing->w_px >> 1, h = texturing->h_px >> 1;
        return (struct around){w, h, w + 1, h + 1};
    }
    int32_t left = at->x, right = left, top = at->y, bottom = top;
    while (--n) {
        const int32_t x = (++at)->x, y = at->y;
        if (x < left) left = x;
        if (x > right) right = x;
        if (y < top) top = y;
        if (y > bottom) bottom = y;
    }
    middle_of(left, right, texturing->w_px, &around.x, &around.w);
    middle_of(top, bottom, texturing->h_px, &around.y, &around.h);
    return around;
}

/* How far from that of the middle the depth of any pixel is. */
static inline int32_t depth_range(const struct lim_texture_plane *depth, const struct around *around)
{
    return ((int32_t)abs_s32(depth->x) * around->w + (int32_t)abs_s32(depth->y) * around->h) * 2;
}

/* Planes, their depth_min and their level are set, and texels are the places' planes / depth * 2^(30 - shift): all else
 * of the perspective follows. */
void lim_texture_settle(const struct lim_texturing *texturing, const struct around *around, int8_t shift,
                        struct lim_gradients *out);

#endif

#endif
