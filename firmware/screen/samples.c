/* SPDX-License-Identifier: MIT
 *
 * An edge from (ax, ay) down to (bx, by) in sub-pixels, S of them in a pixel, counted so that sample (0, 0) of the
 * first pixel is at (0, 0), meets row t at N / dy with N = ax dy + dx (t S/4 - ay). In columns u = S/16 wide, the first
 * one at or right of it is ceil(M / dy), M = ceil(N / u): as in edge.c. With ax = wx u + px, ay = wy 4u + py
 *
 *     M = wx dy + 4 dx (t - wy) + ceil((px dy - dx py) / u)
 *
 * A sample of a row is four columns wide: so a row's first sample at or right of it is what M / 4 dy, less the row's
 * shift, comes to, rounded up. M / 4 dy on the edge's first row, whichever that is asked for, and dx / dy are rounded
 * down to 16 fraction bits: neighbours, and bands, find the same samples, though in a thousand rows they may be a 256th
 * of a pixel off. Upright edges are not.
 *
 * Range: px < u, py < 4u and |dx|, dy <= 2050 S, so the last term's numerator stays below 2^31 up to 9 sub-pixel bits.
 * The intersection lies between the end points, and a sample fits 15 bits; all else may wrap. */
#include "screen/samples.h"

#include "math/divisor.h"

#if LIM_HAS_ANTIALIAS

/* Profiles with coarser points than 1/32 pixel have them made finer: samples lie on odd 32nds. */
#define POINT_BITS (LIM_SUB_BITS > 5 ? LIM_SUB_BITS : 5)
#define POINT_SCALE ((int32_t)1 << (POINT_BITS - LIM_SUB_BITS))
#define COLUMN_BITS (POINT_BITS - 4)
#define ROW_BITS (POINT_BITS - 2)

/* Columns from the origin to where strips begin, and to the last row's samples. */
#define TO_STRIP                                                                                                       \
    ((LIM_ORIGIN_PX + LIM_STRIP_BIAS_PX) * LIM_SAMPLE_COLUMNS + LIM_SAMPLES_A_ROW - 1 -                                \
     (int32_t)lim_sample_shift(LIM_SAMPLE_ROWS - 1))

/* From the centre of a pixel to its first column and row of samples. */
enum { TO_COLUMN = 15 << (POINT_BITS - 5), TO_ROW = 3 << (POINT_BITS - 3) };

#if LIM_SUB_BITS > 9
typedef int64_t sample_area;
#else
typedef int32_t sample_area;
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

/* m / 4 dy, never too high; what does not fit may wrap. */
static LIM_RARE uint32_t any_quarter_q16(int32_t m, int32_t dy)
{
    int32_t whole = m / dy, rest = m - whole * dy;

    if (rest < 0) {
        whole--;
        rest += dy;
    }
    while (dy > INT16_MAX) {
        dy >>= 1;
        rest >>= 1;
    }
    if (rest >= dy) rest = dy - 1;
    return ((uint32_t)whole << 14) + (uint32_t)((rest << 14) / dy);
}

static inline bool fits_divisor(int32_t number)
{
    return (uint32_t)(number + DIVISOR_WIDTH) < 2 * (uint32_t)DIVISOR_WIDTH;
}

/* Beyond the bias: as many columns as the last row's samples are before the next one's, and all but a unit of another,
 * which makes a ceiling of the floor. */
static inline void samples_edge_set(struct lim_sample_edge *edge, struct lim_point a, struct lim_point b, int32_t row)
{
    const int32_t ax = x_of(a), ay = y_of(a), dx = x_of(b) - ax, dy = y_of(b) - ay;
    const int32_t part_x = ax & ((1 << COLUMN_BITS) - 1), part_y = ay & ((1 << ROW_BITS) - 1);
    const int32_t first = row_of(a), slope = 4 * dx;
    const sample_area part = (sample_area)part_x * dy - (sample_area)part_y * dx + ((1 << COLUMN_BITS) - 1);
    const int32_t start = (int32_t)(part >> COLUMN_BITS) + (part_y ? slope : 0);
    uint32_t start_q16;

    if (dy < 1 << 12 && fits_divisor(start) && fits_divisor(slope)) {
        const struct divisor divisor = divisor_of_short(dy);
        start_q16 = (uint32_t)(divisor_q16(&divisor, start) >> 2);
        edge->step_q16 = (uint32_t)(divisor_q16(&divisor, slope) >> 2);
    } else {
        start_q16 = any_quarter_q16(start, dy);
        edge->step_q16 = any_quarter_q16(slope, dy);
    }
    edge->x_q16 = (uint32_t)((ax >> COLUMN_BITS) + TO_STRIP) * (uint32_t)LIM_COLUMN_Q16 + (uint32_t)LIM_COLUMN_Q16 - 1 +
                  start_q16 + (uint32_t)(row - first) * edge->step_q16;
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
    edge->next = (uint8_t)to;
    edge->end = end;
    samples_edge_set(edge, at[from], at[to], row - LIM_ORIGIN_PX * LIM_SAMPLE_ROWS);
}

void lim_strip_of_rows(struct lim_strip *strip, const struct lim_point *last, int16_t end_row, int16_t y)
{
    const struct lim_point *row = &last[end_row - 1 - y * LIM_SAMPLE_ROWS];

    for (int16_t s = 0; s < LIM_SAMPLE_ROWS; s = (int16_t)(s + 2), row -= 2) {
        strip->left.rows[s >> 1] =
            pair_of((uint32_t)(row[0].x + LIM_STRIP_BIAS), (uint32_t)(row[-1].x + LIM_STRIP_BIAS));
        strip->right.rows[s >> 1] = pair_max(strip->left.rows[s >> 1], pair_of((uint32_t)(row[0].y + LIM_STRIP_BIAS),
                                                                               (uint32_t)(row[-1].y + LIM_STRIP_BIAS)));
    }
}

/* The rows from <= s < end of a line whose first row is given, one at least, of a boundary that goes on through them.
 */
static inline void some_rows(uint32_t x_q16[LIM_SAMPLE_ROWS], struct lim_sample_edge *edge, const struct lim_point *at,
                             uint8_t n, int32_t row, int32_t from, int32_t end)
{
    uint32_t to_q16 = edge->x_q16, step_q16 = edge->step_q16;
    int32_t edge_end = edge->end - row, s = from;

    do {
        if (edge_end > s) {
            to_q16 += step_q16;
        } else {
            turn(edge, at, n, (int16_t)(row + s));
            to_q16 = edge->x_q16;
            step_q16 = edge->step_q16;
            edge_end = edge->end - row;
        }
        x_q16[s] = to_q16;
    } while (++s < end);
    edge->x_q16 = to_q16;
}

static inline struct lim_bound bound_of_rows(const uint32_t x_q16[LIM_SAMPLE_ROWS])
{
    return (struct lim_bound){{lim_samples_at(x_q16[0], x_q16[1], 0), lim_samples_at(x_q16[2], x_q16[3], 2)}};
}

/* A row that the polygon does not have ends where it begins, beside the others. */
void lim_strip_any(struct lim_strip *strip, struct lim_sample_edges *edges, const struct lim_point *at, uint8_t n,
                   uint8_t first, int16_t y, int16_t end_row)
{
    const int32_t row = y * LIM_SAMPLE_ROWS, top_row = edges->left.end == INT16_MIN ? screen_row(at[first]) : row;
    const int32_t from = top_row > row ? top_row - row : 0;
    const int32_t end = end_row - row < LIM_SAMPLE_ROWS ? end_row - row : LIM_SAMPLE_ROWS;
    uint32_t left_q16[LIM_SAMPLE_ROWS], right_q16[LIM_SAMPLE_ROWS];

    some_rows(left_q16, &edges->left, at, n, row, from, end);
    some_rows(right_q16, &edges->right, at, n, row, from, end);
    for (int32_t s = from; s-- > 0;)
        left_q16[s] = right_q16[s] = left_q16[from];
    for (int32_t s = end; s < LIM_SAMPLE_ROWS; s++)
        left_q16[s] = right_q16[s] = left_q16[s > from ? s - 1 : from];
    strip->left = bound_of_rows(left_q16);
    strip->right = bound_of_rows(right_q16);
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

void lim_samples_sides(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n)
{
    int32_t left = INT32_MAX, right = INT32_MIN;

    for (uint8_t k = 0; k < n; k++) {
        const int32_t x = x_of(at[k]);
        if (x < left) left = x;
        if (x > right) right = x;
    }
    shape->left = (int16_t)((left >> POINT_BITS) + LIM_ORIGIN_PX);
    shape->right = (int16_t)((right >> POINT_BITS) + 1 + LIM_ORIGIN_PX);
}

void lim_samples_bounds(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n)
{
    int32_t before = row_of(at[n - 1]), top = INT32_MAX, bottom = INT32_MIN, way = 0;
    uint8_t first = 0;

    for (uint8_t k = 0; k < n; k++) {
        const int32_t row = row_of(at[k]);

        way += row > before ? row - before : before - row;
        if (row < top) top = row, first = k;
        if (row > bottom) bottom = row;
        before = row;
    }
    shape->first = first;
    shape->non_monotone = way > 2 * (bottom - top);
    if (shape->non_monotone) shape->apex = samples_choose_apex(at, n, first, bottom);
    *shape->end_row = (int16_t)(bottom + LIM_ORIGIN_PX * LIM_SAMPLE_ROWS);
    /* A polygon between two rows has none. */
    shape->top = (int16_t)((top >> 2) + LIM_ORIGIN_PX);
    shape->bottom = (int16_t)(top < bottom ? ((bottom + 3) >> 2) + LIM_ORIGIN_PX : shape->top);
}

#endif
