/* SPDX-License-Identifier: MIT
 *
 * Which lines a polygon takes, and whether it is non-monotone: the part of EDGE that comes before its lines are known
 * to matter. In: its points. Out: struct lim_edge_shape, the caller's. */
#ifndef LIM_EDGE_BOUNDS_H
#define LIM_EDGE_BOUNDS_H

#include "screen/edge.h"

/* No quotient in EDGE is longer than the guard band is wide, nor, on small screens, a divisor than 16 bits. */
#define LIM_EDGE_MOST_PX (2 * LIM_MAX_SIDE_PX + 2)
#define LIM_EDGE_IS_SHORT (LIM_8_BIT && LIM_EDGE_MOST_PX < 512 && LIM_EDGE_MOST_PX <= UINT16_MAX >> LIM_SUB_BITS)

/* A coordinate and what is added to it, or a line from the origin. */
#if LIM_EDGE_IS_SHORT
typedef int16_t lim_edge_sub;
#define LIM_EDGE_SUB_MIN INT16_MIN
#define LIM_EDGE_SUB_MAX INT16_MAX
#else
typedef int32_t lim_edge_sub;
#define LIM_EDGE_SUB_MIN INT32_MIN
#define LIM_EDGE_SUB_MAX INT32_MAX
#endif

/* The first line at or below y, from the origin: what two of them have between them is the same as on the screen. So
 * are columns. */
static inline lim_edge_sub lim_edge_row(lim_edge_sub y)
{
    return (lim_edge_sub)(y + (lim_edge_sub)(LIM_SUB - 1)) >> LIM_SUB_BITS;
}

/* What corners are compared by: themselves, because rows rise as they do, so where corners turn but twice their rows
 * do. 16 bits have no room for their sums. */
static inline lim_edge_sub lim_edge_level(lim_edge_sub y)
{
    return LIM_EDGE_IS_SHORT ? lim_edge_row(y) : y;
}

static inline lim_edge_sub lim_edge_row_of_level(lim_edge_sub level)
{
    return LIM_EDGE_IS_SHORT ? level : lim_edge_row(level);
}

/* What corners span, in levels, and a corner at its top. */
struct lim_edge_span {
    lim_edge_sub top, bottom;
    uint8_t first;
};

/* `y`: the corner's level. */
static inline void lim_edge_span_add(struct lim_edge_span *span, lim_edge_sub y, uint8_t corner)
{
    if (y < span->top) span->top = y, span->first = corner;
    if (y > span->bottom) span->bottom = y;
}

static inline void lim_edge_span_to_shape(const struct lim_edge_span *span, struct lim_edge_shape *shape)
{
    shape->top = (int16_t)(lim_edge_row_of_level(span->top) + LIM_ORIGIN_PX);
    shape->bottom = (int16_t)(lim_edge_row_of_level(span->bottom) + LIM_ORIGIN_PX);
    shape->first = span->first;
    shape->non_monotone = false;
}

/* How far a boundary goes down, all its ways together, and what it spans. */
lim_edge_sub lim_edge_bounds_down(struct lim_edge_span *span, const struct lim_point *at, uint8_t n);

/* lim_edge_bounds() but for folds. false: the boundary turns more than twice, perhaps it is non-monotone (not where it
 * does so within a line), and only lim_edge_bounds() can tell. Most polygons have three corners, which turn twice, or
 * four, which turn more often where each edge goes the other way than the one before it. */
static inline bool lim_edge_bounds_plain(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n)
{
    if (LIM_8_BIT || LIM_OPTIMISE_SIZE || n > 4) {
        struct lim_edge_span many;
        const lim_edge_sub down = lim_edge_bounds_down(&many, at, n);
        lim_edge_span_to_shape(&many, shape);
        return down <= many.bottom - many.top;
    }
    const lim_edge_sub a = lim_edge_level(at[0].y), b = lim_edge_level(at[1].y), c = lim_edge_level(at[2].y);
    struct lim_edge_span span = {a, a, 0};
    int32_t turns = 0;
    lim_edge_span_add(&span, b, 1);
    lim_edge_span_add(&span, c, 2);
    if (n == 4) {
        const lim_edge_sub d = lim_edge_level(at[3].y);
        lim_edge_span_add(&span, d, 3);
        turns = ((a - b) ^ (b - c)) & ((b - c) ^ (c - d)) & ((c - d) ^ (d - a));
    }
    lim_edge_span_to_shape(&span, shape);
    return turns >= 0;
}

/* Sets left and right. */
static inline void lim_edge_bounds_sides(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n)
{
    lim_edge_sub left = at[0].x, right = left;

    for (uint8_t k = 1; k < n; k++) {
        const lim_edge_sub x = at[k].x;

        if (x < left) left = x;
        if (x > right) right = x;
    }
    shape->left = (int16_t)(lim_edge_row(left) + LIM_ORIGIN_PX);
    shape->right = (int16_t)(lim_edge_row(right) + LIM_ORIGIN_PX);
}

#endif
