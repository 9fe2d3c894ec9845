/* SPDX-License-Identifier: MIT
 *
 * EDGE for antialiasing: a polygon on the screen -> for each line of pixels, which of their samples it covers.
 *
 * A pixel has 16 samples in four rows a quarter of a pixel apart, four a row. Each row is shifted against the others
 * by a sixteenth of a pixel, so that all 16 have different x: an upright edge knows 17 coverages, a level one 5.
 * Sample (v, row) belongs to a polygon when it is inside, or on a left or a top edge: what edge.c does for the centres
 * of pixels, as exactly. So neighbours share out the samples between them, and what they cover adds up to all. */
#ifndef LIM_SAMPLES_H
#define LIM_SAMPLES_H

#include "math/pair.h"
#include "stages.h"

enum { LIM_SAMPLE_ROWS = 4, LIM_SAMPLES_A_ROW = 4, LIM_SAMPLE_COLUMNS = 16, LIM_SAMPLES = 16 };
#define LIM_COLUMN_Q16 (INT32_C(65536) * LIM_SAMPLES_A_ROW / LIM_SAMPLE_COLUMNS) /* of a sample of a row */
#define LIM_ALL_SAMPLES 0xFFFF /* of a pixel, a bit each; where int has 16 bits, no enumerator's value */

/* Samples of a strip count from so many pixels left of the screen, beyond which no polygon reaches (perspective.h). */
enum {
    LIM_STRIP_BIAS_PX = LIM_MAX_SIDE_PX / 2 + 2,
    LIM_STRIP_BIAS = LIM_STRIP_BIAS_PX * LIM_SAMPLES_A_ROW,
};

LIM_STATIC_ASSERT((INT32_C(2) * LIM_MAX_SIDE_PX + 4) * LIM_SAMPLES_A_ROW <= INT32_C(0x7FFF),
                  "a sample of a row fits half a word");

/* A boundary on a line, in samples (samples.h): of each row the first one at or right of it. Two rows a word, the upper
 * one in the lower half, below 2^15; from LIM_STRIP_BIAS_PX before the screen on. */
struct lim_bound {
    uint32_t rows[2];
};

/* Of each row of a line the samples left <= v < right; left >= right: none. */
struct lim_strip {
    struct lim_bound left, right;
};

/* Sample v of the screen as strips have it, in all rows. */
static inline struct lim_bound lim_bound_at(int32_t v)
{
    const uint32_t pair = pair_of_both((uint32_t)(v + LIM_STRIP_BIAS));

    return (struct lim_bound){{pair, pair}};
}

/* Where a bound is in a row, as a sample of the screen. */
static inline int16_t lim_bound_sample(const struct lim_bound *bound, uint_fast8_t row)
{
    return (int16_t)((int32_t)(bound->rows[row >> 1] >> (row & 1 ? 16 : 0) & 0xFFFF) - LIM_STRIP_BIAS);
}

static inline bool lim_bound_equals(const struct lim_bound *a, const struct lim_bound *b)
{
    return a->rows[0] == b->rows[0] && a->rows[1] == b->rows[1];
}

/* In all rows, or at the same sample. */
static inline bool lim_bound_is_before(const struct lim_bound *a, const struct lim_bound *b)
{
    return pair_are_most(a->rows[0], b->rows[0], a->rows[1], b->rows[1]);
}

/* The same, where the answer is mostly no: the upper rows alone say so. */
static inline bool lim_bound_is_seldom_before(const struct lim_bound *a, const struct lim_bound *b)
{
    return !pair_beyond(a->rows[0], b->rows[0]) && !pair_beyond(a->rows[1], b->rows[1]);
}

/* What two strips have in common; `strip` may have rows that end before they begin. */
static inline struct lim_strip lim_strip_common(const struct lim_strip *strip, const struct lim_strip *open)
{
    struct lim_strip common = *strip;

    for (uint_fast8_t i = 0; i < 2; i++) {
        common.left.rows[i] = pair_min(pair_max(common.left.rows[i], open->left.rows[i]), open->right.rows[i]);
        common.right.rows[i] = pair_min(pair_max(common.right.rows[i], common.left.rows[i]), open->right.rows[i]);
    }
    return common;
}

/* Whether all its rows are in the same pixel. */
static inline bool lim_bound_is_in_pixel(const struct lim_bound *bound)
{
    const uint32_t apart = bound->rows[0] ^ bound->rows[1];

    return !(((bound->rows[0] ^ bound->rows[0] >> 16) | apart | apart >> 16) & 0xFFFC);
}

static inline uint32_t lim_bound_sum(const struct lim_bound *bound)
{
    return pair_sum(bound->rows[0] + bound->rows[1]);
}

/* How many samples in all rows lie beyond a bound and before pixel x, which counts as they do. */
static inline uint32_t lim_bound_beyond(const struct lim_bound *bound, uint32_t x)
{
    const uint32_t at = pair_of_both(x * LIM_SAMPLES_A_ROW);

    return pair_sum(pair_beyond(at, bound->rows[0]) + pair_beyond(at, bound->rows[1]));
}

/* The least and the greatest of its rows. */
static inline uint32_t lim_bound_low(const struct lim_bound *bound)
{
    const uint32_t low = pair_min(bound->rows[0], bound->rows[1]);

    return pair_low(low) < pair_high(low) ? pair_low(low) : pair_high(low);
}

static inline uint32_t lim_bound_high(const struct lim_bound *bound)
{
    const uint32_t high = pair_max(bound->rows[0], bound->rows[1]);

    return pair_low(high) > pair_high(high) ? pair_low(high) : pair_high(high);
}

/* The pixels that hold all of a strip's samples, on the screen's line: first <= x < end. */
static inline int16_t lim_strip_first_px(const struct lim_strip *strip)
{
    return (int16_t)((int32_t)(lim_bound_low(&strip->left) / LIM_SAMPLES_A_ROW) - LIM_STRIP_BIAS_PX);
}

static inline int16_t lim_strip_end_px(const struct lim_strip *strip)
{
    const uint32_t end = lim_bound_high(&strip->right) + LIM_SAMPLES_A_ROW - 1;

    return (int16_t)((int32_t)(end / LIM_SAMPLES_A_ROW) - LIM_STRIP_BIAS_PX);
}

/* How many of a strip's samples lie before pixel x; both from LIM_STRIP_BIAS_PX before the screen on. */
static inline uint32_t lim_strip_count(const struct lim_strip *strip, uint32_t x)
{
    const uint32_t at = pair_of_both(x * LIM_SAMPLES_A_ROW);

    return pair_sum(pair_beyond(at, strip->left.rows[0]) - pair_beyond(at, strip->right.rows[0]) +
                    pair_beyond(at, strip->left.rows[1]) - pair_beyond(at, strip->right.rows[1]));
}

/* As lim_edge_begin(). */
static inline void lim_strip_begin(struct lim_sample_edges *edges, uint8_t n, uint8_t first)
{
    edges->left.next = edges->right.next = first;
    edges->left.end = edges->right.end = INT16_MIN;
    edges->left.step_vertex = 1;
    edges->right.step_vertex = (uint8_t)(n - 1);
}

/* lim_edge_bounds() and lim_edge_bounds_sides() for lines and pixels of which the polygon may have a sample;
 * `non_monotone` as rows of samples are. */
void lim_samples_sides(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n);
void lim_samples_bounds(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n);

/* By how many sixteenths of a pixel a row's samples are shifted: 1, 3, 0, 2. */
static inline int32_t lim_sample_shift(int_fast16_t row)
{
    return 0x8D >> (2 * (row & 3)) & 3;
}

/* Where a row is of an edge, as struct lim_sample_edge has it: as if its samples were shifted as the last row's are. */
static inline uint32_t lim_sample_shifted(uint32_t x_q16, int_fast16_t row)
{
    return x_q16 + (uint32_t)((lim_sample_shift(LIM_SAMPLE_ROWS - 1) - lim_sample_shift(row)) * LIM_COLUMN_Q16);
}

/* The first samples of two rows of a line at or right of an edge. */
static inline uint32_t lim_samples_at(uint32_t upper_q16, uint32_t lower_q16, int_fast16_t row)
{
    return pair_of_highs(lim_sample_shifted(upper_q16, row), lim_sample_shifted(lower_q16, row + 1));
}

/* All rows of a line that an edge goes on through, and on to the last one. */
static inline struct lim_bound lim_bound_step(uint32_t *x_q16, uint32_t step_q16)
{
    const uint32_t a_q16 = *x_q16 + step_q16, b_q16 = a_q16 + step_q16, c_q16 = b_q16 + step_q16,
                   d_q16 = c_q16 + step_q16;

    *x_q16 = d_q16;
    return (struct lim_bound){{lim_samples_at(a_q16, b_q16, 0), lim_samples_at(c_q16, d_q16, 2)}};
}

static inline struct lim_bound lim_bound_next(struct lim_sample_edge *edge)
{
    return lim_bound_step(&edge->x_q16, edge->step_q16);
}

/* lim_strip_next() where an edge begins or ends. */
void lim_strip_any(struct lim_strip *strip, struct lim_sample_edges *edges, const struct lim_point *at, uint8_t n,
                   uint8_t first, int16_t y, int16_t end_row);

/* The strip of line y of a polygon that is not non-monotone and ends above row `end_row`. `edges` come from
 * lim_strip_begin() or from the line above. */
static LIM_INLINE struct lim_strip lim_strip_next(struct lim_sample_edges *edges, const struct lim_point *at, uint8_t n,
                                                  uint8_t first, int32_t y, int32_t end_row)
{
    const int32_t last_row = y * LIM_SAMPLE_ROWS + LIM_SAMPLE_ROWS - 1;

    if (edges->left.end <= last_row || edges->right.end <= last_row) {
        struct lim_strip strip;
        lim_strip_any(&strip, edges, at, n, first, (int16_t)y, (int16_t)end_row);
        return strip;
    }
    return (struct lim_strip){lim_bound_next(&edges->left), lim_bound_next(&edges->right)};
}

/* A strip from its rows: `last` is the row above end_row, those above it follow; x is the first sample, y the one after
 * the last, both on the screen. */
void lim_strip_of_rows(struct lim_strip *strip, const struct lim_point *last, int16_t end_row, int16_t y);

static inline uint8_t lim_sample_count(uint16_t mask)
{
    uint32_t bits = mask - (mask >> 1 & 0x5555u);

    bits = (bits & 0x3333) + (bits >> 2 & 0x3333);
    bits = (bits + (bits >> 4)) & 0x0F0F;
    return (uint8_t)((bits + (bits >> 8)) & 0x1F);
}

#endif
