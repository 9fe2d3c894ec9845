/* SPDX-License-Identifier: MIT
 *
 * A triangle on the screen, as what is linear over it is set up from: ways from one corner to the others, in sub-pixels
 * that are halved until they have 14 bits and a sign, along each axis apart, as a triangle may be as narrow as a line
 * is high. */
#ifndef LIM_MESH_PLANE_H
#define LIM_MESH_PLANE_H

#include "math/fixed.h"
#include "stages.h"

struct plane_of_three {
    int32_t ux, uy, vx, vy;     /* sub-pixels, halved */
    uint8_t halved_x, halved_y; /* bits */
};

/* Two differences along an axis, to 14 bits and a sign. Returns how often they are halved. */
static inline uint8_t mesh_halve(int32_t *u, int32_t *v)
{
    const uint32_t most = abs_s32(*u) | abs_s32(*v);

    if (most >> 14 == 0) return 0;
    const uint8_t bits = (uint8_t)(18 - clz_u32(most));
    *u >>= bits;
    *v >>= bits;
    return bits;
}

#endif
