/* SPDX-License-Identifier: MIT
 *
 * A point on the screen in a register: where coordinates have 16 bits and y lies in a word's upper half, one load
 * brings both, and words compare as their y do. The same values everywhere. */
#ifndef LIM_PACKED_H
#define LIM_PACKED_H

#include "math/fixed.h"
#include "stages.h"

#define LIM_IS_PACKED (!LIM_WIDE && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ && !LIM_8_BIT)

#if LIM_IS_PACKED

typedef int32_t lim_packed;
typedef int32_t __attribute__((may_alias)) lim_packed_word;

static inline lim_packed lim_packed_of(int32_t x, int32_t y)
{
    return (int32_t)(((uint32_t)x & 0xFFFFu) | (uint32_t)y << 16);
}

static inline lim_packed lim_packed_load(const struct lim_point *at)
{
    return *(const lim_packed_word *)at;
}

static inline void lim_packed_store(struct lim_point *to, lim_packed at)
{
    *(lim_packed_word *)to = at;
}

static inline struct lim_point lim_packed_point(lim_packed at)
{
    const struct lim_point point = {(lim_sub)at, (lim_sub)(at >> 16)};
    return point;
}

static inline int32_t lim_packed_x(lim_packed at)
{
    return (int16_t)at;
}

static inline int32_t lim_packed_y(lim_packed at)
{
    return at >> 16;
}

/* Whether a is above b; on one level, it may or may not be. */
static inline bool lim_packed_is_above(lim_packed a, lim_packed b)
{
    return a < b;
}

#else

typedef struct lim_point lim_packed;

static inline lim_packed lim_packed_of(int32_t x, int32_t y)
{
    const struct lim_point point = {(lim_sub)x, (lim_sub)y};
    return point;
}

static inline void lim_packed_store(struct lim_point *to, lim_packed at)
{
    *to = at;
}

static inline lim_packed lim_packed_load(const struct lim_point *at)
{
    return *at;
}

static inline struct lim_point lim_packed_point(lim_packed at)
{
    return at;
}

static inline int32_t lim_packed_x(lim_packed at)
{
    return at.x;
}

static inline int32_t lim_packed_y(lim_packed at)
{
    return at.y;
}

static inline bool lim_packed_is_above(lim_packed a, lim_packed b)
{
    return a.y < b.y;
}

#endif

#endif
