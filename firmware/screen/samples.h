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

#include "screen/edge.h"

enum { LIM_SAMPLE_ROWS = 4, LIM_SAMPLES_A_ROW = 4, LIM_SAMPLE_COLUMNS = 16 };
#define LIM_ALL_SAMPLES 0xFFFF /* where int has 16 bits, no enumerator's value */

/* A polygon's samples on a line of pixels: left <= v < right of each row; sample v is pixel v / 4's. */
struct lim_strip {
    int16_t left[LIM_SAMPLE_ROWS], right[LIM_SAMPLE_ROWS]; /* left >= right: none */
    int16_t x0, x1;                                        /* no other pixel holds any; x0 >= x1: none does */
    int16_t inner0, inner1; /* of these, some of which it has all samples; inner0 >= inner1: none */
};

/* Pixels x0 <= x < x1, of which it has the same samples: bit 4 * row + v % 4. */
struct lim_run {
    int16_t x0, x1;
    uint16_t mask;
};

/* As lim_edge_begin(). */
static inline void lim_strip_begin(struct lim_sample_edges *edges, uint8_t n, uint8_t first)
{
    edges->left.next = edges->right.next = first;
    edges->left.end = edges->right.end = INT16_MIN;
    edges->left.step_vertex = 1;
    edges->right.step_vertex = (uint8_t)(n - 1);
}

/* lim_edge_bounds() for lines and pixels of which the polygon may have a sample; `non_monotone` as rows of samples are.
 */
void lim_samples_bounds(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n);

/* The strip of line y of a polygon that is not non-monotone and ends above row `end_row`. `edges` come from
 * lim_strip_begin() or from the line above. */
void lim_strip_next(struct lim_strip *strip, struct lim_sample_edges *edges, const struct lim_point *at, uint8_t n,
                    uint8_t first, int16_t y, int16_t end_row);

/* Sets the strip's pixels from its samples. */
void lim_strip_bound(struct lim_strip *strip);

/* A strip from its rows: `last` is the row above end_row, those above it follow; x is the first sample, y the one after
 * the last. */
void lim_strip_of_rows(struct lim_strip *strip, const struct lim_point *last, int16_t end_row, int16_t y);

/* By how many sixteenths of a pixel a row's samples are shifted: 1, 3, 0, 2. */
static inline int32_t lim_sample_shift(int_fast16_t row)
{
    return 0x8D >> (2 * (row & 3)) & 3;
}

/* The run of a strip's line that begins with pixel x0 <= x < x1, perhaps without any sample. */
void lim_strip_run(const struct lim_strip *strip, int16_t x, struct lim_run *run);

static inline uint8_t lim_sample_count(uint16_t mask)
{
    uint32_t bits = mask - (mask >> 1 & 0x5555u);

    bits = (bits & 0x3333) + (bits >> 2 & 0x3333);
    bits = (bits + (bits >> 4)) & 0x0F0F;
    return (uint8_t)((bits + (bits >> 8)) & 0x1F);
}

/* By samples or by the centres of pixels. */
static inline void lim_shape_bounds(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n,
                                    bool by_samples)
{
    if (LIM_HAS_ANTIALIAS && by_samples)
        lim_samples_bounds(shape, at, n);
    else
        lim_edge_bounds(shape, at, n);
}

#endif
