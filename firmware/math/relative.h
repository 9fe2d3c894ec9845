/* SPDX-License-Identifier: MIT
 *
 * The way from an eye to a point of a long scene, as three numbers of one exponent: as many bits wherever the point is.
 */
#ifndef LIM_RELATIVE_H
#define LIM_RELATIVE_H

#include "camera.h"
#include "long.h"
#include "math/fixed.h"

/* d * 2^exponent units; the longest has 28 to 31 bits and a sign, unless the point is where the eye is. */
struct lim_relative {
    int32_t d[3];
    int8_t exponent;
};

enum { LIM_RELATIVE_NEAR_BITS = 22 };

/* |x| or one less. */
static inline uint32_t relative_size(int32_t x)
{
    return (uint32_t)(x ^ x >> 31);
}

/* By how much to shift left, in steps of 4: those are few where leading zeros are searched for. */
static inline uint8_t relative_shift(uint32_t size)
{
    if (LIM_HAS_CLZ) return (uint8_t)((clz_u32(size | 1) - 1u) & ~3u);
    uint8_t up = 0;
    for (size |= 1; !(size >> 27); size <<= 4)
        up = (uint8_t)(up + 4);
    return up;
}

/* Where both are near, their fractions count, else these are nothing that could be seen. `fraction`: the point's, or
 * NULL. */
static inline void lim_relative_set(struct lim_relative *out, const struct lim_long_eye *eye,
                                    const LIM_FLASH struct lim_long_vertex *point,
                                    const LIM_FLASH struct lim_fraction *fraction)
{
    int32_t x = point->at[0] - eye->at[0], y = point->at[1] - eye->at[1], z = point->at[2] - eye->at[2];
    uint32_t size = relative_size(x) | relative_size(y) | relative_size(z);
    int_fast8_t exponent = 0;

    if (!(size >> LIM_RELATIVE_NEAR_BITS)) {
        x = x * 256 - eye->fraction_q8[0];
        y = y * 256 - eye->fraction_q8[1];
        z = z * 256 - eye->fraction_q8[2];
        if (fraction) x += fraction->x_q8, y += fraction->y_q8, z += fraction->z_q8;
        size = relative_size(x) | relative_size(y) | relative_size(z);
        exponent = -8;
    }
    const uint8_t up = relative_shift(size);
    out->d[0] = (int32_t)((uint32_t)x << up);
    out->d[1] = (int32_t)((uint32_t)y << up);
    out->d[2] = (int32_t)((uint32_t)z << up);
    out->exponent = (int8_t)(exponent - up);
}

#endif
