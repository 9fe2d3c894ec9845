/* SPDX-License-Identifier: MIT
 *
 * Reciprocals for edges of a few lines, as most of a mesh are, where a processor does not divide: one product each for
 * start and slope. Of a height below SMALL_DY, from a table of 4 KB, rounded to nearest. Of one up to twice that, by
 * the mean of two entries, which is off by one unit of its last place at most: half a unit by the entries, as much by
 * rounding it, and a quarter by the curve between, upwards.
 *
 * A product is off to either side, on the edge's last line by less than a bias in units of the edge's last bit, if the
 * slope's errors are added up. That much below the truth is where the edge is to start; rounding takes a unit more a
 * line. All that must stay below 1/dy (edge.c). */
#ifndef LIM_SMALL_H
#define LIM_SMALL_H

#include "stages.h"

#define EDGE_HAS_SMALL (!LIM_DIVIDES && !LIM_8_BIT && !LIM_OPTIMISE_SIZE && LIM_SUB_BITS >= 7 && LIM_SUB_BITS <= 9)

#if EDGE_HAS_SMALL

enum {
    SMALL_LEAST_DY = 52, /* below: products might not fit */
    SMALL_DY = 1024,
    SMALL_DX = 3072,
    LOW_LEAST_DY = SMALL_LEAST_DY / 4, /* where they are narrower, they do */
    LOW_DX = SMALL_DX / 4,
    SMALL_RECIP_BITS = 27,
    SMALL_DROPPED_BITS = 2, /* of an entry, for products to fit */
    SMALL_SHIFT = SMALL_RECIP_BITS - SMALL_DROPPED_BITS - LIM_EDGE_BITS,
    SMALL_LINES = (SMALL_DY + 2 * LIM_SUB) / LIM_SUB - 1,
    SMALL_BIAS = ((SMALL_DY + SMALL_LINES * SMALL_DX) >> (SMALL_SHIFT + 1)) + 1,
    MEDIUM_DY = 2 * SMALL_DY,
    MEDIUM_SHIFT = SMALL_RECIP_BITS + 1 - LIM_EDGE_BITS,
    MEDIUM_LINES = (MEDIUM_DY + 2 * LIM_SUB) / LIM_SUB - 1,
    MEDIUM_BIAS = ((MEDIUM_DY + MEDIUM_LINES * SMALL_DX) >> MEDIUM_SHIFT) + 1,
};

/* With half of what will be dropped. */
#define SMALL_RECIP(dy) ((UINT32_C(1) << SMALL_RECIP_BITS) / ((dy) ? (dy) : 1) + (1 << SMALL_DROPPED_BITS) / 2)

LIM_STATIC_ASSERT((2 * SMALL_BIAS + SMALL_LINES + 1) * SMALL_DY <= 1 << LIM_EDGE_BITS, "small edges are exact");
LIM_STATIC_ASSERT((2 * MEDIUM_BIAS + MEDIUM_LINES + 1) * MEDIUM_DY <= 1 << LIM_EDGE_BITS, "medium ones are exact");
LIM_STATIC_ASSERT((uint64_t)(SMALL_DX + SMALL_LEAST_DY) * SMALL_RECIP(SMALL_LEAST_DY) >> SMALL_DROPPED_BITS <=
                      INT32_MAX,
                  "their products fit");
LIM_STATIC_ASSERT((uint64_t)(LOW_DX + LOW_LEAST_DY) * SMALL_RECIP(LOW_LEAST_DY) >> SMALL_DROPPED_BITS <= INT32_MAX,
                  "those of low edges, too");
LIM_STATIC_ASSERT((uint64_t)(SMALL_DX + SMALL_DY) * SMALL_RECIP(SMALL_DY / 2) <= INT32_MAX, "and these");

extern const uint32_t lim_small_recips[SMALL_DY + 1];

static inline int32_t small_recip(int32_t dy)
{
    return (int32_t)(lim_small_recips[dy] >> SMALL_DROPPED_BITS);
}

static inline int32_t medium_recip(int32_t dy)
{
    enum { ADDED = 2 * ((1 << SMALL_DROPPED_BITS) / 2) - 1 };

    return (int32_t)((lim_small_recips[dy >> 1] + lim_small_recips[(dy + 1) >> 1] - ADDED) >> 1);
}

#endif

#endif
