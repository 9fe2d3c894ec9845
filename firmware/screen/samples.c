/* SPDX-License-Identifier: MIT
 *
 * An edge from (ax, ay) down to (bx, by) in sub-pixels, S of them in a pixel, counted so that sample (0, 0) of the
 * first pixel is at (0, 0), meets row t at N / dy with N = ax dy + dx (t S/4 - ay). In columns u = S/16 wide, the first
 * one at or right of it is ceil(M / dy), M = ceil(N / u): as in edge.c. With ax = wx u + px, ay = wy 4u + py
 *
 *     M = wx dy + 4 dx (t - wy) + ceil((px dy - dx py) / u)
 *
 * Range: the intersection lies between the end points, so |M| <= 24 w * 2 h S, below 2^31 for pictures of up to
 * 349,525 / 2^(LIM_SUB_BITS - 7) pixels; 64 bits do beyond. The sum may wrap on the way. px < u, py < 4u and |dx|,
 * dy <= 2050 S: the last term's numerator stays below 2^31 up to 9 sub-pixel bits. */
#include "screen/samples.h"

#if LIM_HAS_ANTIALIAS

/* Profiles with coarser points than 1/32 pixel have them made finer: samples lie on odd 32nds. */
#define POINT_BITS (LIM_SUB_BITS > 5 ? LIM_SUB_BITS : 5)
#define POINT_SCALE ((int32_t)1 << (POINT_BITS - LIM_SUB_BITS))
#define COLUMN_BITS (POINT_BITS - 4)
#define ROW_BITS (POINT_BITS - 2)

/* From the centre of a pixel to its first column and row of samples. */
enum { TO_COLUMN = 15 << (POINT_BITS - 5), TO_ROW = 3 << (POINT_BITS - 3) };

#if LIM_SUB_BITS > 9 || LIM_MAX_SIDE_PX * LIM_MAX_SIDE_PX > 349525 >> (POINT_BITS - 7 > 0 ? POINT_BITS - 7 : 0)
typedef int64_t sample_area;
typedef int64_t sample_wrap;
#else
typedef int32_t sample_area;
typedef uint32_t sample_wrap;
#endif

static inline int32_t x_of(struct lim_point p)
{
    return (int32_t)p.x * POINT_SCALE + TO_COLUMN;
}

static inline int32_t y_of(struct lim_point p)
{
    return (int32_t)p.y * POINT_SCALE + TO_ROW;
}

/* The first row at or below a point, from the origin. */
static inline int32_t row_of(struct lim_point p)
{
    return (y_of(p) + ((1 << ROW_BITS) - 1)) >> ROW_BITS;
}

static inline int16_t screen_row(struct lim_point p)
{
    return (int16_t)(row_of(p) + LIM_ORIGIN_PX * LIM_SAMPLE_ROWS);
}

/* M above, for row t from the origin. */
static sample_area samples_meeting(struct lim_point a, int32_t dx, int32_t dy, int32_t t)
{
    const int32_t ax = x_of(a), ay = y_of(a);
    const int32_t part_x = ax & ((1 << COLUMN_BITS) - 1), part_y = ay & ((1 << ROW_BITS) - 1);
    const int32_t whole_x = ax >> COLUMN_BITS, whole_y = ay >> ROW_BITS;
    const sample_area part = (sample_area)part_x * dy - (sample_area)part_y * dx;
    const sample_wrap whole =
        (sample_wrap)whole_x * (sample_wrap)dy + (sample_wrap)(t - whole_y) * (sample_wrap)(4 * dx);

    return (sample_area)(whole + (sample_wrap)((part + ((1 << COLUMN_BITS) - 1)) >> COLUMN_BITS));
}

static void samples_edge_set(struct lim_sample_edge *edge, struct lim_point a, struct lim_point b, int16_t row,
                             int16_t end)
{
    const int32_t dx = x_of(b) - x_of(a), dy = y_of(b) - y_of(a);
    const sample_area m = samples_meeting(a, dx, dy, row - LIM_ORIGIN_PX * LIM_SAMPLE_ROWS);
    int32_t x = (int32_t)(m / dy); /* rounds to zero: up, if negative */
    int32_t error = (int32_t)(m - (sample_area)x * dy);

    if (error > 0) {
        x++;
        error -= dy;
    }
    edge->x = (int16_t)(x + LIM_ORIGIN_PX * 16);
    edge->error = error;
    edge->denominator = dy;
    edge->step_x = 0;
    edge->step_error = 0;
    if (end - row < 2) return; /* never stepped */
    int32_t step_x = 4 * dx / dy;
    int32_t rest = 4 * dx - step_x * dy;
    if (rest < 0) {
        step_x--;
        rest += dy;
    }
    edge->step_x = (int16_t)step_x;
    edge->step_error = rest;
}

/* The next edge of a boundary that goes on below a row. */
static LIM_ALONE void turn(struct lim_sample_edge *edge, const struct lim_point *at, uint8_t n, int16_t row)
{
    uint_fast16_t from, to = edge->next;
    int16_t end;

    do {
        from = to;
        to += edge->step_vertex;
        if (to >= n) to -= n;
        end = screen_row(at[to]);
    } while (end <= row);
    samples_edge_set(edge, at[from], at[to], row, end);
    edge->next = (uint8_t)to;
    edge->end = end;
}

static inline void samples_step(struct lim_sample_edge *edge)
{
    edge->x = (int16_t)(edge->x + edge->step_x);
    edge->error += edge->step_error;
    if (edge->error > 0) {
        edge->error -= edge->denominator;
        edge->x++;
    }
}

static inline void samples_advance(struct lim_sample_edge *edge, const struct lim_point *at, uint8_t n, int16_t row)
{
    if (edge->end > row)
        samples_step(edge);
    else
        turn(edge, at, n, row);
}

void lim_strip_bound(struct lim_strip *strip)
{
    int16_t low = INT16_MAX, high = INT16_MIN, inner_low = INT16_MIN, inner_high = INT16_MAX;

    for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
        const int16_t left = strip->left[s], right = strip->right[s];
        if (left >= right) {
            inner_high = INT16_MIN;
            continue;
        }
        if (left < low) low = left;
        if (left > inner_low) inner_low = left;
        if (right > high) high = right;
        if (right < inner_high) inner_high = right;
    }
    strip->x0 = (int16_t)(low >> 2);
    strip->x1 = (int16_t)((high + 3) >> 2);
    strip->inner0 = (int16_t)((inner_low + 3) >> 2);
    strip->inner1 = (int16_t)(inner_high >> 2);
}

void lim_strip_of_rows(struct lim_strip *strip, const struct lim_point *last, int16_t end_row, int16_t y)
{
    for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
        const struct lim_point *row = &last[end_row - 1 - (y * LIM_SAMPLE_ROWS + (int16_t)s)];
        strip->left[s] = (int16_t)row->x;
        strip->right[s] = (int16_t)row->y;
    }
    lim_strip_bound(strip);
}

/* The first sample of a row at or right of a column. */
static inline int16_t sample_at(int32_t column, uint_fast8_t row)
{
    return (int16_t)((column + (LIM_SAMPLES_A_ROW - 1 - lim_sample_shift((int_fast16_t)row))) >> 2);
}

static LIM_ALONE void any_rows(struct lim_strip *strip, struct lim_sample_edges *edges, const struct lim_point *at,
                               uint8_t n, uint8_t first, int16_t y, int16_t end_row)
{
    const int16_t top_row = edges->left.end == INT16_MIN ? screen_row(at[first]) : INT16_MIN;

    for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
        const int16_t row = (int16_t)(y * LIM_SAMPLE_ROWS + (int16_t)s);
        strip->left[s] = strip->right[s] = 0;
        if (row < top_row || row >= end_row) continue;
        samples_advance(&edges->left, at, n, row);
        samples_advance(&edges->right, at, n, row);
        strip->left[s] = sample_at(edges->left.x, s);
        strip->right[s] = sample_at(edges->right.x, s);
    }
    lim_strip_bound(strip);
}

/* Columns on the first and the last row of a line. */
struct reach {
    int16_t low, high;
};

/* All rows of a line that an edge goes on through. */
static inline struct reach all_rows(struct lim_sample_edge *edge, int16_t *samples)
{
    const int32_t step_x = edge->step_x, step_error = edge->step_error, denominator = edge->denominator;
    int32_t x = edge->x, error = edge->error, first = 0;

    LIM_UNROLLED(4)
    for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
        x += step_x;
        error += step_error;
        if (error > 0) {
            error -= denominator;
            x++;
        }
        if (!s) first = x;
        samples[s] = sample_at(x, s);
    }
    edge->x = (int16_t)x;
    edge->error = error;
    return first < x ? (struct reach){(int16_t)first, (int16_t)x} : (struct reach){(int16_t)x, (int16_t)first};
}

/* From columns, pixels are easier told than from samples: a pixel more at an edge does no harm. */
void lim_strip_next(struct lim_strip *strip, struct lim_sample_edges *edges, const struct lim_point *at, uint8_t n,
                    uint8_t first, int16_t y, int16_t end_row)
{
    const int16_t last_row = (int16_t)(y * LIM_SAMPLE_ROWS + LIM_SAMPLE_ROWS - 1);

    if (edges->left.end <= last_row || edges->right.end <= last_row) {
        any_rows(strip, edges, at, n, first, y, end_row);
        return;
    }
    const struct reach left = all_rows(&edges->left, strip->left), right = all_rows(&edges->right, strip->right);
    strip->x0 = (int16_t)(left.low >> 4);
    strip->inner0 = (int16_t)((left.high + 15) >> 4);
    strip->inner1 = (int16_t)(right.low >> 4);
    strip->x1 = (int16_t)((right.high + 15) >> 4);
}

/* Left of the inner pixels: what of a run the left boundary leaves. */
static void left_run(const int16_t *left, struct lim_run *run)
{
    uint32_t mask = 0;

    LIM_UNROLLED(4)
    for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
        const int32_t ahead = left[s] - 4 * run->x0;
        if (ahead >= 4) {
            if (run->x0 + (ahead >> 2) < run->x1) run->x1 = (int16_t)(run->x0 + (ahead >> 2));
        } else if (ahead > 0) {
            mask |= (15u << ahead & 15u) << (4 * s);
            run->x1 = (int16_t)(run->x0 + 1);
        } else {
            mask |= 15u << (4 * s);
        }
    }
    run->mask &= (uint16_t)mask;
}

/* Right of them: the right one. */
static void right_run(const int16_t *right, struct lim_run *run)
{
    uint32_t mask = 0;

    LIM_UNROLLED(4)
    for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
        const int32_t ahead = right[s] - 4 * run->x0;
        if (ahead >= 4) {
            mask |= 15u << (4 * s);
            if (run->x0 + (ahead >> 2) < run->x1) run->x1 = (int16_t)(run->x0 + (ahead >> 2));
        } else if (ahead > 0) {
            mask |= 15u >> (4 - ahead) << (4 * s);
            run->x1 = (int16_t)(run->x0 + 1);
        }
    }
    run->mask &= (uint16_t)mask;
}

void lim_strip_run(const struct lim_strip *strip, int16_t x, struct lim_run *run)
{
    const bool has_inner = strip->inner0 < strip->inner1;

    run->x0 = x;
    run->mask = LIM_ALL_SAMPLES;
    if (has_inner && x < strip->inner0) {
        run->x1 = strip->inner0;
        left_run(strip->left, run);
    } else if (has_inner && x < strip->inner1) {
        run->x1 = strip->inner1;
    } else {
        run->x1 = strip->x1;
        if (!has_inner) left_run(strip->left, run);
        right_run(strip->right, run);
    }
}

/* As in edge.c: where the extra extremes of a non-monotone polygon lie near its top, a fan from the bottom sees every
 * other corner, and the other way round. */
static LIM_RARE uint8_t samples_choose_apex(const struct lim_point *at, uint8_t n, uint8_t top_at, int32_t bottom)
{
    const int32_t top = row_of(at[top_at]);
    int32_t lowest_top = top, after = row_of(at[1]), here = row_of(at[0]);
    uint8_t bottom_at = 0;

    for (uint_fast8_t k = n; k-- > 0;) {
        const int32_t before = row_of(at[k]);
        if (here <= before && here <= after && here > lowest_top) lowest_top = here;
        if (before == bottom) bottom_at = (uint8_t)k;
        after = here;
        here = before;
    }
    return 2 * lowest_top + 1 < top + bottom ? bottom_at : top_at;
}

void lim_samples_bounds(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n)
{
    int32_t before = row_of(at[n - 1]), top = INT32_MAX, bottom = INT32_MIN, left = INT32_MAX, right = INT32_MIN,
            way = 0;

    for (uint8_t k = 0; k < n; k++) {
        const int32_t x = x_of(at[k]), row = row_of(at[k]);

        way += row > before ? row - before : before - row;
        if (row < top) top = row, shape->first = k;
        if (row > bottom) bottom = row;
        if (x < left) left = x;
        if (x > right) right = x;
        before = row;
    }
    shape->non_monotone = way > 2 * (bottom - top);
    if (shape->non_monotone) shape->apex = samples_choose_apex(at, n, shape->first, bottom);
    *shape->end_row = (int16_t)(bottom + LIM_ORIGIN_PX * LIM_SAMPLE_ROWS);
    /* A polygon between two rows has none. */
    shape->top = (int16_t)((top >> 2) + LIM_ORIGIN_PX);
    shape->bottom = (int16_t)(top < bottom ? ((bottom + 3) >> 2) + LIM_ORIGIN_PX : shape->top);
    shape->left = (int16_t)((left >> POINT_BITS) + LIM_ORIGIN_PX);
    shape->right = (int16_t)((right >> POINT_BITS) + 1 + LIM_ORIGIN_PX);
}

#endif
