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

/* The upper and the lower of two points; only y is of use. Where halves of words are compared by one instruction, x is
 * not that point's. */
#if LIM_DUAL_MULTIPLY

static inline lim_packed packed_upper(lim_packed a, lim_packed b)
{
    (void)__builtin_arm_ssub16(a, b); /* sets the flags that __builtin_arm_sel() reads */
    return (int32_t)__builtin_arm_sel((uint32_t)b, (uint32_t)a);
}

static inline lim_packed packed_lower(lim_packed a, lim_packed b)
{
    (void)__builtin_arm_ssub16(a, b);
    return (int32_t)__builtin_arm_sel((uint32_t)a, (uint32_t)b);
}

#else

static inline lim_packed packed_upper(lim_packed a, lim_packed b)
{
    return a < b ? a : b;
}

static inline lim_packed packed_lower(lim_packed a, lim_packed b)
{
    return a > b ? a : b;
}

#endif

/* The rows of the uppermost and the lowest of three. */
static inline int32_t lim_packed_least_y(lim_packed a, lim_packed b, lim_packed c)
{
    return packed_upper(packed_upper(a, b), c) >> 16;
}

static inline int32_t lim_packed_most_y(lim_packed a, lim_packed b, lim_packed c)
{
    return packed_lower(packed_lower(a, b), c) >> 16;
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

static inline int32_t lim_packed_least_y(lim_packed a, lim_packed b, lim_packed c)
{
    const lim_sub ab = a.y < b.y ? a.y : b.y;
    return ab < c.y ? ab : c.y;
}

static inline int32_t lim_packed_most_y(lim_packed a, lim_packed b, lim_packed c)
{
    const lim_sub ab = a.y > b.y ? a.y : b.y;
    return ab > c.y ? ab : c.y;
}

static inline bool lim_packed_is_above(lim_packed a, lim_packed b)
{
    return a.y < b.y;
}

#endif

/* The columns of the leftmost and the rightmost of three. */
static inline int32_t lim_packed_least_x(lim_packed a, lim_packed b, lim_packed c)
{
    const int32_t ax = lim_packed_x(a), bx = lim_packed_x(b), cx = lim_packed_x(c), ab = ax < bx ? ax : bx;

    return ab < cx ? ab : cx;
}

static inline int32_t lim_packed_most_x(lim_packed a, lim_packed b, lim_packed c)
{
    const int32_t ax = lim_packed_x(a), bx = lim_packed_x(b), cx = lim_packed_x(c), ab = ax > bx ? ax : bx;

    return ab > cx ? ab : cx;
}

/* The way from one point to another. What does not fit 16 bits may be saturated to them. */
struct lim_packed_way {
    int32_t dx, dy;
};

/* Differences of 16 bits at once, where that is an instruction. */
#if LIM_IS_PACKED && LIM_DUAL_MULTIPLY

static inline struct lim_packed_way lim_packed_way(lim_packed from, lim_packed to)
{
    const lim_packed way = __builtin_arm_qsub16(to, from);
    const struct lim_packed_way both = {(int16_t)way, way >> 16};
    return both;
}

/* Whether b, then c, lie to the left of the way from a, as y goes down; of points less than 2^15 apart. */
static inline bool lim_packed_turns(lim_packed a, lim_packed b, lim_packed c)
{
    return __builtin_arm_smusdx(__builtin_arm_ssub16(b, a), __builtin_arm_ssub16(c, a)) < 0;
}

static inline uint32_t packed_minus(lim_packed a, lim_packed b)
{
    return (uint32_t)__builtin_arm_ssub16(a, b);
}

#else

static inline struct lim_packed_way lim_packed_way(lim_packed from, lim_packed to)
{
    const struct lim_packed_way way = {lim_packed_x(to) - lim_packed_x(from), lim_packed_y(to) - lim_packed_y(from)};
    return way;
}

static inline bool lim_packed_turns(lim_packed a, lim_packed b, lim_packed c)
{
    const struct lim_packed_way u = lim_packed_way(a, b), v = lim_packed_way(a, c);
    return u.dx * v.dy < u.dy * v.dx;
}

#if LIM_IS_PACKED

/* Words are subtracted whole: where the lower half borrows, the upper one is less by 1. */
static inline uint32_t packed_minus(lim_packed a, lim_packed b)
{
    return (uint32_t)a - (uint32_t)b;
}

#endif

#endif

/* Bits of which one is set by lim_packed_is_beyond() where a point lies before the first corner or behind the last; a
 * point just on the border may count as beyond it. */
#if LIM_IS_PACKED

static inline uint32_t lim_packed_beyond(lim_packed at, lim_packed first, lim_packed last)
{
    return packed_minus(at, first) | packed_minus(last, at);
}

static inline bool lim_packed_is_beyond(uint32_t signs)
{
    return signs & 0x80008000u;
}

#else

static inline uint32_t lim_packed_beyond(lim_packed at, lim_packed first, lim_packed last)
{
    return (uint32_t)(lim_packed_x(at) - lim_packed_x(first)) | (uint32_t)(lim_packed_x(last) - lim_packed_x(at)) |
           (uint32_t)(lim_packed_y(at) - lim_packed_y(first)) | (uint32_t)(lim_packed_y(last) - lim_packed_y(at));
}

static inline bool lim_packed_is_beyond(uint32_t signs)
{
    return signs & 0x80000000u;
}

#endif

/* The same of any points on the screen or around it. */
static inline bool lim_packed_turns_far(lim_packed a, lim_packed b, lim_packed c)
{
    const int32_t ux = lim_packed_x(b) - lim_packed_x(a), uy = lim_packed_y(b) - lim_packed_y(a);
    const int32_t vx = lim_packed_x(c) - lim_packed_x(a), vy = lim_packed_y(c) - lim_packed_y(a);

    if ((uint32_t)((ux + 32768) | (uy + 32768) | (vx + 32768) | (vy + 32768)) >> 16)
        return (int64_t)ux * vy < (int64_t)uy * vx;
    return ux * vy < uy * vx;
}

#endif
