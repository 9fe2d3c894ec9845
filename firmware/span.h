/* SPDX-License-Identifier: MIT
 *
 * SPAN: per line, which pixels are still open. A line's open pixels are a list of gaps, left to
 * right, the first one inside the line's own record: most lines never need a second. Memory: one
 * record a line and a pool of further gaps, lent by the caller. */
#ifndef LIM_SPAN_H
#define LIM_SPAN_H

#include "cull.h"

/* Pixels x0 <= x < x1. */
struct gap {
    uint16_t x0, x1;
    uint16_t next; /* in the pool, or LIM_NONE */
};

struct line {
    struct gap gap;    /* x0 == x1: the line is closed */
    uint16_t retained; /* PAINT's list of polygons that start on this line, or LIM_NONE */
};

struct spans {
    struct line *lines; /* one for each screen line */
    struct gap *pool;
    uint16_t pool_size;
    uint16_t free;  /* list of gaps that were given back */
    uint16_t fresh; /* gaps from here on were never used */
    uint16_t open_lines;
    struct rect open; /* holds every open pixel */
};

enum span_result {
    SPAN_NOTHING = 0,  /* all of it was closed before */
    SPAN_SOME = 1,     /* some of it was open, and is closed now */
    SPAN_EXHAUSTED = 2 /* no gap was left in the pool; the lines are as they were found or further */
};

/* Receives a piece [x0, x1) of a line that was open, left to right. */
typedef void span_sink(void *ctx, uint16_t x0, uint16_t x1);

/* Opens the pixels of `open`, and no others. */
void spans_open(struct spans *spans, const struct rect *open);

/* Gives all gaps back; only single lines are used from now on. */
void spans_reset_pool(struct spans *spans);

/* Closes [x0, x1) of a line; x0 < x1, any values. Pieces that were open go to `sink`, if any. */
enum span_result span_close(struct spans *spans, struct line *line, int16_t x0, int16_t x1, span_sink *sink, void *ctx);

/* Draws `open` together around what is open. true: it became smaller than it was. */
bool spans_shrink(struct spans *spans);

#endif
