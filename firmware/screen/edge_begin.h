/* SPDX-License-Identifier: MIT
 *
 * How most edges begin: those that a short division, or a reciprocal from a table, is exact for on all of their lines
 * (edge.c). Inlined where polygons come by the hundred. */
#ifndef LIM_EDGE_BEGIN_H
#define LIM_EDGE_BEGIN_H

#include "math/divisor.h"
#include "screen/small.h"
#include "stages.h"

#if !EDGE_HAS_SMALL

static inline bool begin_low(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y)
{
    (void)edge, (void)ax, (void)ay, (void)bx, (void)by, (void)y;
    return false;
}

static inline bool begin_small(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y)
{
    (void)edge, (void)ax, (void)ay, (void)bx, (void)by, (void)y;
    return false;
}

static inline bool begin_medium(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y)
{
    (void)edge, (void)ax, (void)ay, (void)bx, (void)by, (void)y;
    return false;
}

#endif

#if LIM_8_BIT

static inline bool begin_short(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y,
                               int32_t end)
{
    (void)edge, (void)ax, (void)ay, (void)bx, (void)by, (void)y, (void)end;
    return false;
}

static inline bool lim_edge_begin_fast(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y,
                                       int32_t end)
{
    (void)edge, (void)ax, (void)ay, (void)bx, (void)by, (void)y, (void)end;
    return false;
}

#else

/* The origin, and all but one unit of the next pixel: what makes a ceiling of the floor. */
#define EDGE_BEFORE_NEXT (((lim_edge_wrap)(LIM_ORIGIN_PX + 1) << LIM_EDGE_BITS) - 1)

/* Fractions of 16 bits, which do for most. With up to 9 sub-pixel bits dy is below SHORT_WIDTH then, and what is left
 * of a start below 2 SHORT_WIDTH. */
enum { SHORT_BITS = 16, SHORT_WIDTH = DIVISOR_WIDTH / 2 };

/* The last term of M above, where a short division does. */
static inline int32_t part_of(int32_t ax, int32_t ay, int32_t dx, int32_t dy)
{
    const int32_t part_x = ax & (LIM_SUB - 1), part_y = ay & (LIM_SUB - 1);

    return (part_x * dy - part_y * dx + (LIM_SUB - 1)) >> LIM_SUB_BITS;
}

/* From a corner's pixel, `ahead` of it on the current line. */
static inline void set_ahead(struct lim_edge *edge, int32_t ax, lim_edge_wrap ahead, lim_edge_wrap step)
{
    edge->step = (lim_edge_at)step;
    edge->at =
        (lim_edge_at)(((lim_edge_wrap)(lim_edge_at)(ax >> LIM_SUB_BITS) << LIM_EDGE_BITS) + EDGE_BEFORE_NEXT + ahead);
}

static inline lim_edge_wrap widened(int32_t at_q16)
{
    return (lim_edge_wrap)(lim_edge_at)at_q16 << (LIM_EDGE_BITS - SHORT_BITS);
}

/* Whether a short division does for all lines of an edge, as many as `lines`, if it is narrow; then for those of any
 * that is less high, too. */
static inline bool edge_is_low(int32_t dy, int32_t lines)
{
    if (LIM_OPTIMISE_SIZE || (uint32_t)(DIVISOR_ERROR * lines + 1) * (uint32_t)dy > UINT32_C(1) << SHORT_BITS)
        return false;
    return LIM_SUB_BITS <= 9 || dy < SHORT_WIDTH;
}

/* Edges are narrow if edge_are_narrow() of what edge_width() says of each, OR'ed: 2 SHORT_WIDTH is a power of two. */
static inline uint32_t edge_width(int32_t dx)
{
    return (uint32_t)(dx + SHORT_WIDTH);
}

static inline bool edge_are_narrow(uint32_t widths)
{
    return widths < 2 * SHORT_WIDTH;
}

/* Sets such an edge for line y, from the origin. */
static inline void set_short(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t dx, int32_t dy, int32_t y)
{
    const int32_t part = part_of(ax, ay, dx, dy);
    const struct divisor divisor = LIM_SUB_BITS <= 9 ? divisor_of_short(dy) : divisor_of(dy);
    const int32_t step_q16 = divisor_q16(&divisor, dx);
    const int32_t start_q16 = divisor_q16(&divisor, part);

    set_ahead(edge, ax, widened(start_q16 + (y - (ay >> LIM_SUB_BITS)) * step_q16), widened(step_q16));
}

/* Sets the edge from one corner down to another, for line y and up to line `end`, both from the origin. false: it is
 * not short. */
static inline bool begin_short(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y,
                               int32_t end)
{
    const int32_t dx = bx - ax, dy = by - ay;

    if (!edge_is_low(dy, end - (ay >> LIM_SUB_BITS)) || !edge_are_narrow(edge_width(dx))) return false;
    set_short(edge, ax, ay, dx, dy, y);
    return true;
}

#if EDGE_HAS_SMALL

/* By reciprocals (small.h): a start as much too low as what all of the edge's lines add may be too high. */
static inline void set_by(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t dx, int32_t dy, int32_t y,
                          int32_t recip, uint8_t shift, lim_edge_wrap bias)
{
    const lim_edge_wrap step = (lim_edge_wrap)((dx * recip) >> shift);
    const lim_edge_wrap start = (lim_edge_wrap)((part_of(ax, ay, dx, dy) * recip) >> shift);
    const lim_edge_wrap from_top = (lim_edge_wrap)(y - (ay >> LIM_SUB_BITS));

    set_ahead(edge, ax, start - bias + from_top * step, step);
}

/* begin_short() of an edge of these heights, up to so wide, whatever its lines. false: it is none. */
static inline bool begin_from_table(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y,
                                    int32_t least_dy, int32_t end_dy, int32_t most_dx)
{
    const int32_t dx = bx - ax, dy = by - ay;

    if ((uint32_t)(dy - least_dy) >= (uint32_t)(end_dy - least_dy)) return false;
    if ((uint32_t)(dx + most_dx) >= 2 * (uint32_t)most_dx) return false;
    set_by(edge, ax, ay, dx, dy, y, small_recip(dy), SMALL_SHIFT, SMALL_BIAS);
    return true;
}

static inline bool begin_small(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y)
{
    return begin_from_table(edge, ax, ay, bx, by, y, SMALL_LEAST_DY, SMALL_DY, SMALL_DX);
}

/* Lower ones, if they are narrower. */
static inline bool begin_low(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y)
{
    return begin_from_table(edge, ax, ay, bx, by, y, LOW_LEAST_DY, SMALL_LEAST_DY, LOW_DX);
}

static inline bool begin_medium(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y)
{
    const int32_t dx = bx - ax, dy = by - ay;

    if ((uint32_t)(dy - SMALL_DY) >= MEDIUM_DY - SMALL_DY) return false;
    if ((uint32_t)(dx + SMALL_DX) >= 2 * SMALL_DX) return false;
    set_by(edge, ax, ay, dx, dy, y, medium_recip(dy), MEDIUM_SHIFT, MEDIUM_BIAS);
    return true;
}

#endif

/* As most edges begin. false: this one does not. */
static inline bool lim_edge_begin_fast(struct lim_edge *edge, int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t y,
                                       int32_t end)
{
    return EDGE_HAS_SMALL ? begin_small(edge, ax, ay, bx, by, y) : begin_short(edge, ax, ay, bx, by, y, end);
}

#endif

#endif
