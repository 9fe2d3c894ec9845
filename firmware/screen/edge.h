/* SPDX-License-Identifier: MIT
 *
 * EDGE: a polygon on the screen -> for each line, the pixels [left, right) whose centres it covers.
 *
 * Exact: an edge is evaluated from its two end points, top -> bottom, as a fixed-point number whose error no pixel
 * shows, so two polygons that share it agree on every pixel: no gap, no double hit. Never clipped against the screen:
 * lines above it are skipped by multiplication. Pixel (x, y) belongs to a polygon when its centre is inside, or on a
 * left or a top edge. Memory: the caller's; a polygon's points are read as long as its edges are followed. */
#ifndef LIM_EDGE_H
#define LIM_EDGE_H

#include "stages.h"

/* Sums of products (edge.c), and what they are summed in: 32 bits may wrap on the way, 64 never need to. */
#if LIM_SUB_BITS > 9
typedef int64_t lim_sub_area;
typedef int64_t lim_sub_wrap;
#else
typedef int32_t lim_sub_area;
typedef uint32_t lim_sub_wrap;
#endif

/* Sets all but left and right, which fewer ask for: lim_edge_bounds_sides(). 3 <= n. */
void lim_edge_bounds(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n);

/* Both boundaries of a polygon that is not non-monotone, before its first line; lim_edge_turn() takes them to any. */
static inline void lim_edge_begin(struct lim_edge_pair *pair, uint8_t n, uint8_t first)
{
    pair->left.next = pair->right.next = first;
    pair->left.end = pair->right.end = INT16_MIN;
    pair->left.step_vertex = 1;
    pair->right.step_vertex = (uint8_t)(n - 1);
}

/* Puts the boundary's edge on line y, above the polygon's bottom, in the place of one that ends there or above. */
void lim_edge_next(struct lim_edge *edge, const struct lim_point *at, uint8_t n, int16_t y);

/* A single edge for line y and up to line `end`, which it does not have. false: it is to be begun anew on a line
 * before.
 */
bool lim_edge_begin_slow(struct lim_edge *edge, struct lim_point from, struct lim_point to, int16_t y, int16_t end);

/* Replaces the edges that end on line y or above, top <= y < bottom. Returns the line on which it must be called
 * again. */
static inline int16_t lim_edge_turn(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, int16_t y)
{
    if (pair->left.end <= y) lim_edge_next(&pair->left, at, n, y);
    if (pair->right.end <= y) lim_edge_next(&pair->right, at, n, y);
    return pair->left.end < pair->right.end ? pair->left.end : pair->right.end;
}

/* lim_edge_begin() and lim_edge_turn() in one, for the first line of a polygon that is asked for. */
int16_t lim_edge_start(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, uint8_t first, int16_t y);

/* From the line above to line y, or from lim_edge_begin() to any line: steps the edges that go on, replaces the others.
 */
void lim_edge_advance(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, int16_t y);

/* The first line at or below a point, or the first column at or right of it. */
int16_t lim_edge_line_of(lim_sub at);

/* The first column at or right of an edge on line y; above and below its lines, that of its end. For wireframe: it
 * divides. */
int16_t lim_edge_column(struct lim_point upper, struct lim_point lower, int16_t y);

#if LIM_8_BIT

/* The first pixel centre at or right of the edge on the current line. */
static inline int16_t lim_edge_x(const struct lim_edge *edge)
{
    return edge->x;
}

/* Says where it is: of pieces, whose lines are known (active.h). */
static inline void lim_edge_put(struct lim_edge *edge, int16_t x)
{
    edge->x = x;
}

/* The same for all lines that come. */
static inline void lim_edge_stand(struct lim_edge *edge, int16_t x)
{
    lim_edge_put(edge, x);
    edge->step_x = 0;
    edge->error = edge->step_error = 0;
}

/* What lim_edge_step() takes of an edge, for a copy that steps in its place, and back. */
static inline void lim_edge_copy(struct lim_edge *to, const struct lim_edge *from)
{
    *to = *from;
}

static inline void lim_edge_follow(struct lim_edge *edge, const struct lim_edge *ahead)
{
    edge->x = ahead->x;
    edge->error = ahead->error;
}

/* To the next line. */
static inline void lim_edge_step(struct lim_edge *edge)
{
    edge->x = (int16_t)(edge->x + edge->step_x);
    edge->error += edge->step_error;
    if (edge->error > 0) {
        edge->error -= edge->denominator;
        edge->x++;
    }
}

#else

/* The first pixel centre at or right of the edge on the current line. */
/*@ requires \valid_read(edge);
    assigns \nothing; */
static inline int16_t lim_edge_x(const struct lim_edge *edge)
{
    return (int16_t)(edge->at >> LIM_EDGE_BITS);
}

/* Says where it is: of pieces, whose lines are known (active.h). */
static inline void lim_edge_put(struct lim_edge *edge, int16_t x)
{
    edge->at = (lim_edge_at)x * ((lim_edge_at)1 << LIM_EDGE_BITS);
}

/* The same for all lines that come. */
static inline void lim_edge_stand(struct lim_edge *edge, int16_t x)
{
    lim_edge_put(edge, x);
    edge->step = 0;
}

/* What lim_edge_step() takes of an edge, for a copy that steps in its place, and back. */
static inline void lim_edge_copy(struct lim_edge *to, const struct lim_edge *from)
{
    to->at = from->at;
    to->step = from->step;
}

static inline void lim_edge_follow(struct lim_edge *edge, const struct lim_edge *ahead)
{
    edge->at = ahead->at;
}

/* To the next line. */
/*@ requires \valid(edge);
    assigns edge->at; */
static inline void lim_edge_step(struct lim_edge *edge)
{
    edge->at = (lim_edge_at)((lim_edge_wrap)edge->at + (lim_edge_wrap)edge->step);
}

#endif

/* After lim_edge_begin(), of a polygon that begins farther down: until then it has no pixels. */
static inline void lim_edge_rest(struct lim_edge_pair *pair)
{
    lim_edge_stand(&pair->left, 0);
    lim_edge_stand(&pair->right, 0);
}

/* Where the edge is on the current line; and on to the next. */
static inline int16_t lim_edge_next_x(struct lim_edge *edge)
{
    const int16_t x = lim_edge_x(edge);

    lim_edge_step(edge);
    return x;
}

/* Bounds: which lines a polygon takes, and whether it is non-monotone, before its lines are known to matter ----------
 */

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

/* Of a coordinate: the line, or the column, of the screen or beside it. */
static inline int32_t lim_edge_pixel(int32_t at)
{
    return lim_edge_row((lim_edge_sub)at) + LIM_ORIGIN_PX;
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

/* Twice the area in sub-pixels, of corners at most two screens and a half apart: negative where it faces the eye, as y
 * goes down. */
static inline int64_t lim_edge_area(const struct lim_point *at, uint8_t n)
{
    int64_t area = 0;

    for (uint_fast8_t k = 2; k < n; k++) {
        const int32_t ux = (int32_t)at[k - 1].x - at[0].x, uy = (int32_t)at[k - 1].y - at[0].y;
        const int32_t vx = (int32_t)at[k].x - at[0].x, vy = (int32_t)at[k].y - at[0].y;
        area += (int64_t)ux * vy - (int64_t)uy * vx;
    }
    return area;
}

#endif
