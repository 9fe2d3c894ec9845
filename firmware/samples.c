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
#include "samples.h"

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

/* By how many columns a row's samples are shifted. */
static const LIM_FLASH uint8_t row_shift[LIM_SAMPLE_ROWS] = {1, 3, 0, 2};

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
static sample_area meeting(struct lim_point a, int32_t dx, int32_t dy, int32_t t)
{
    const int32_t ax = x_of(a), ay = y_of(a);
    const int32_t part_x = ax & ((1 << COLUMN_BITS) - 1), part_y = ay & ((1 << ROW_BITS) - 1);
    const int32_t whole_x = ax >> COLUMN_BITS, whole_y = ay >> ROW_BITS;
    const sample_area part = (sample_area)part_x * dy - (sample_area)part_y * dx;
    const sample_wrap whole = (sample_wrap)whole_x * (sample_wrap)dy + (sample_wrap)(t - whole_y) * (sample_wrap)(4 * dx);

    return (sample_area)(whole + (sample_wrap)((part + ((1 << COLUMN_BITS) - 1)) >> COLUMN_BITS));
}

static void edge_set(struct lim_edge *edge, struct lim_point a, struct lim_point b, int16_t row, int16_t end)
{
    const int32_t dx = x_of(b) - x_of(a), dy = y_of(b) - y_of(a);
    const sample_area m = meeting(a, dx, dy, row - LIM_ORIGIN_PX * LIM_SAMPLE_ROWS);
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
    int32_t step = 4 * dx / dy;
    int32_t rest = 4 * dx - step * dy;
    if (rest < 0) {
        step--;
        rest += dy;
    }
    edge->step_x = (int16_t)step;
    edge->step_error = rest;
}

/* The next edge of a boundary that goes on below a row. */
static LIM_ALONE void turn(struct lim_edge *edge, const struct lim_point *at, uint8_t n, int16_t row)
{
    uint_fast16_t from, to = edge->to;
    int16_t end;

    do {
        from = to;
        to += edge->step;
        if (to >= n) to -= n;
        end = screen_row(at[to]);
    } while (end <= row);
    edge_set(edge, at[from], at[to], row, end);
    edge->to = (uint8_t)to;
    edge->end = end;
}

static inline void advance(struct lim_edge *edge, const struct lim_point *at, uint8_t n, int16_t row)
{
    if (edge->end > row)
        lim_edge_step(edge);
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

/* The first sample of a row at or right of a column. */
static inline int16_t sample_at(int16_t column, uint_fast8_t row)
{
    return (int16_t)((column + (LIM_SAMPLES_A_ROW - 1 - row_shift[row])) >> 2);
}

void lim_strip_next(struct lim_strip *strip, struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n,
                    uint8_t first, int16_t y, int16_t end_row)
{
    const int16_t top_row = pair->left.end == INT16_MIN ? screen_row(at[first]) : INT16_MIN;

    for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
        const int16_t row = (int16_t)(y * LIM_SAMPLE_ROWS + (int16_t)s);
        strip->left[s] = strip->right[s] = 0;
        if (row < top_row || row >= end_row) continue;
        advance(&pair->left, at, n, row);
        advance(&pair->right, at, n, row);
        strip->left[s] = sample_at(pair->left.x, s);
        strip->right[s] = sample_at(pair->right.x, s);
    }
    lim_strip_bound(strip);
}

struct lim_run lim_strip_run(const struct lim_strip *strip, int16_t x)
{
    struct lim_run run = {x, strip->x1, 0};

    if (x >= strip->inner0 && x < strip->inner1) return (struct lim_run){x, strip->inner1, LIM_ALL_SAMPLES};
    for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
        const int16_t left = (int16_t)(strip->left[s] - 4 * x), right = (int16_t)(strip->right[s] - 4 * x);
        int16_t same = 1; /* so many pixels are alike in this row */
        if (right <= 0 || left >= right) continue;
        if (left >= 4) {
            same = (int16_t)(left >> 2);
        } else {
            const uint32_t from = left > 0 ? 15u << left & 15u : 15, to = right < 4 ? 15u >> (4 - right) : 15;
            run.mask = (uint16_t)(run.mask | (from & to) << (4 * s));
            if (left <= 0 && right >= 4) same = (int16_t)(right >> 2);
        }
        if (x + same < run.x1) run.x1 = (int16_t)(x + same);
    }
    return run;
}

/* As in edge.c: where the extra extremes of a folded polygon lie near its top, a fan from the bottom sees every other
 * corner, and the other way round. */
static LIM_RARE uint8_t choose_apex(const struct lim_point *at, uint8_t n, uint8_t top_at, int32_t bottom)
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

void lim_samples_measure(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n)
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
    shape->folded = way > 2 * (bottom - top);
    if (shape->folded) shape->apex = choose_apex(at, n, shape->first, bottom);
    shape->end_row = (int16_t)(bottom + LIM_ORIGIN_PX * LIM_SAMPLE_ROWS);
    /* A polygon between two rows has none. */
    shape->top = (int16_t)((top >> 2) + LIM_ORIGIN_PX);
    shape->bottom = (int16_t)(top < bottom ? ((bottom + 3) >> 2) + LIM_ORIGIN_PX : shape->top);
    shape->left = (int16_t)((left >> POINT_BITS) + LIM_ORIGIN_PX);
    shape->right = (int16_t)((right >> POINT_BITS) + 1 + LIM_ORIGIN_PX);
}

#endif
