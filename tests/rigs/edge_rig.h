/* SPDX-License-Identifier: MIT
 *
 * EDGE against its definition in 128 bits, for whatever screen and profile the file that includes this is built for. */
#ifndef TESTS_EDGE_RIG_H
#define TESTS_EDGE_RIG_H

#include "random.h"
#include "screen/edge.h"
#include "screen/edge_begin.h"

#include <stdio.h>

/* Coordinates of the whole guard band. */
struct edge_rig_band {
    int32_t low, high;
};

static inline struct edge_rig_band edge_rig_band(int32_t side_px)
{
    return (struct edge_rig_band){(-side_px / 2 - LIM_ORIGIN_PX) * LIM_SUB,
                                  (3 * side_px / 2 - LIM_ORIGIN_PX) * LIM_SUB};
}

/* ceil(N / (S dy)): the first pixel at or right of an edge on line y. */
static inline int64_t edge_rig_first_pixel(struct lim_point a, struct lim_point b, int64_t y)
{
    const __int128 dy = b.y - a.y;
    const __int128 n = (__int128)a.x * dy + (__int128)(b.x - a.x) * ((y - LIM_ORIGIN_PX) * LIM_SUB - a.y);
    const __int128 den = dy * LIM_SUB;
    __int128 q = n / den;

    if (q * den < n) q++;
    return (int64_t)q + LIM_ORIGIN_PX;
}

/* Of a triangle's edge that crosses line y: it begins at `next` where it has not been followed to its end yet. */
static inline int64_t edge_rig_first_pixel_of(const struct lim_edge *edge, const struct lim_point at[3], int32_t y)
{
    const bool begins_there = at[edge->next].y <= (y - LIM_ORIGIN_PX) * LIM_SUB;
    const int from = begins_there ? edge->next : (edge->next + 3 - edge->step_vertex) % 3;

    return edge_rig_first_pixel(at[from], at[(from + edge->step_vertex) % 3], y);
}

static inline lim_sub edge_rig_coordinate(struct random *random, struct edge_rig_band band)
{
    if (random_u64(random) % 8) return (lim_sub)random_in(random, band.low, band.high);
    return (lim_sub)(random_u64(random) & 1 ? band.low : band.high);
}

/* Half of them anywhere, the others small; often one sub-pixel high, or upright, or level. */
static inline void edge_rig_triangle(struct random *random, struct edge_rig_band band, struct lim_point at[3])
{
    const bool is_small = random_u64(random) & 1;
    const int64_t reach = random_in(random, 1, 24) * LIM_SUB;

    for (int i = 0; i < 3; i++) {
        at[i] = (struct lim_point){edge_rig_coordinate(random, band), edge_rig_coordinate(random, band)};
        if (!i || !is_small) continue;
        at[i].x = (lim_sub)random_in(random, at[0].x - reach > band.low ? at[0].x - reach : band.low,
                                     at[0].x + reach < band.high ? at[0].x + reach : band.high);
        at[i].y = (lim_sub)random_in(random, at[0].y - reach > band.low ? at[0].y - reach : band.low,
                                     at[0].y + reach < band.high ? at[0].y + reach : band.high);
    }
    if (random_u64(random) % 4 == 0 && at[0].y < band.high) at[1].y = (lim_sub)(at[0].y + 1);
    if (random_u64(random) % 8 == 0) at[2].x = at[0].x;
}

/* Wireframe asks for single lines of an edge, outside of it as well. */
static inline void edge_rig_check_columns(struct random *random, const struct lim_point at[3])
{
    for (int k = 0; k < 3; k++) {
        const struct lim_point a = at[k], b = at[(k + 1) % 3];
        const struct lim_point upper = a.y < b.y ? a : b, lower = a.y < b.y ? b : a;
        const int16_t top = lim_edge_line_of(upper.y), bottom = lim_edge_line_of(lower.y);
        for (int i = 0; i < 4 && top < bottom; i++) {
            const int16_t y = i ? (int16_t)random_in(random, top, bottom - 1) : top;
            assert_int_equal(lim_edge_column(upper, lower, y), edge_rig_first_pixel(upper, lower, y));
        }
        assert_int_equal(lim_edge_column(upper, lower, (int16_t)(top - 1)), lim_edge_line_of(upper.x));
        assert_int_equal(lim_edge_column(upper, lower, bottom), lim_edge_line_of(lower.x));
    }
}

/* Follows a random triangle's boundaries from any of its lines to its end. Returns the lines. */
static inline size_t edge_rig_check(struct random *random, struct edge_rig_band band)
{
    struct lim_point at[3];
    struct lim_edge_shape shape;
    struct lim_edge_pair pair;

    edge_rig_triangle(random, band, at);
    lim_edge_bounds(&shape, at, 3);
    assert_false(shape.non_monotone);
    if (shape.top >= shape.bottom) return 0;
    edge_rig_check_columns(random, at);
    const int16_t start =
        (int16_t)(random_u64(random) % 4 ? random_in(random, shape.top, shape.bottom - 1) : shape.top);
    const bool starts_there = random_u64(random) & 1;
    if (starts_there)
        (void)lim_edge_start(&pair, at, 3, shape.first, start);
    else
        lim_edge_begin(&pair, 3, shape.first);
    for (int16_t y = start;;) {
        if (!starts_there || y > start) lim_edge_advance(&pair, at, 3, y);
        assert_int_equal(lim_edge_x(&pair.left), edge_rig_first_pixel_of(&pair.left, at, y));
        assert_int_equal(lim_edge_x(&pair.right), edge_rig_first_pixel_of(&pair.right, at, y));
        if (++y >= shape.bottom) return (size_t)(y - start);
    }
}

/* As many triangles as it takes to meet each way in which edges are begun, across the screen and small. */
static inline void edge_rig_check_many(uint64_t seed)
{
    struct random random = {seed};
    size_t lines = 0;

    for (int k = 0; k < 20000; k++)
        lines += edge_rig_check(&random, edge_rig_band(k % 2 ? LIM_MAX_SIDE_PX : 64));
    printf("# %d fraction bits: %zu lines of edges\n", LIM_EDGE_BITS, lines);
    assert_true(lines > 500000);
}

/* A single edge, downwards; half of them are small, and some of these low. */
static inline void edge_rig_edge(struct random *random, struct edge_rig_band band, struct lim_point *from,
                                 struct lim_point *to)
{
    const bool is_small = random_u64(random) & 1, is_low = random_u64(random) & 1;
    const int64_t high = is_low ? LIM_SUB / 2 : 20 * LIM_SUB, wide = is_low ? 8 * LIM_SUB : 26 * LIM_SUB;

    *from = (struct lim_point){edge_rig_coordinate(random, band), edge_rig_coordinate(random, band)};
    *to = (struct lim_point){edge_rig_coordinate(random, band), edge_rig_coordinate(random, band)};
    if (is_small) {
        const int64_t x = from->x + random_in(random, -wide, wide), y = from->y + random_in(random, 1, high);
        to->x = (lim_sub)(x < band.low ? band.low : x > band.high ? band.high : x);
        to->y = (lim_sub)(y > band.high ? band.high : y);
    }
    if (from->y > to->y) {
        const struct lim_point upper = *to;
        *to = *from;
        *from = upper;
    }
}

/* Each way to begin an edge that takes it, as often as it does. */
struct edge_rig_ways {
    size_t fast, low, medium, slow;
};

/* From line y to the end. */
static inline void edge_rig_follow(struct lim_edge edge, struct lim_point from, struct lim_point to, int16_t y,
                                   int16_t end, size_t *taken)
{
    for (; y < end; y++) {
        assert_int_equal(lim_edge_x(&edge), edge_rig_first_pixel(from, to, y));
        lim_edge_step(&edge);
    }
    (*taken)++;
}

static inline void edge_rig_check_single(struct random *random, struct edge_rig_band band, struct edge_rig_ways *ways)
{
    struct lim_point from, to;
    struct lim_edge edge = {0};

    edge_rig_edge(random, band, &from, &to);
    const int16_t top = lim_edge_line_of(from.y), end = lim_edge_line_of(to.y);
    if (top >= end) return;
    const int16_t y = (int16_t)(random_u64(random) % 4 ? top : random_in(random, top, end - 1));
    const int32_t row = y - LIM_ORIGIN_PX, end_row = end - LIM_ORIGIN_PX;
    if (lim_edge_begin_fast(&edge, from.x, from.y, to.x, to.y, row, end_row))
        edge_rig_follow(edge, from, to, y, end, &ways->fast);
    if (begin_low(&edge, from.x, from.y, to.x, to.y, row)) edge_rig_follow(edge, from, to, y, end, &ways->low);
    if (begin_medium(&edge, from.x, from.y, to.x, to.y, row)) edge_rig_follow(edge, from, to, y, end, &ways->medium);
    if (lim_edge_begin_slow(&edge, from, to, y, end)) edge_rig_follow(edge, from, to, y, end, &ways->slow);
}

/* Edges of a mesh. */
static inline struct edge_rig_ways edge_rig_check_singles(uint64_t seed)
{
    struct random random = {seed};
    struct edge_rig_ways ways = {0};

    for (int k = 0; k < 200000; k++)
        edge_rig_check_single(&random, edge_rig_band(k % 2 ? LIM_MAX_SIDE_PX : 64), &ways);
    printf("# begun fast %zu, low %zu, medium %zu, slowly %zu\n", ways.fast, ways.low, ways.medium, ways.slow);
    return ways;
}

#endif
