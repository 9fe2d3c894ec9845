/* SPDX-License-Identifier: MIT
 *
 * EDGE: a polygon on the screen -> for each line, the pixels [left, right) whose centres it covers.
 *
 * Exact: an edge is evaluated from its two end points, top -> bottom, in quotient and remainder, so
 * two polygons that share it agree on every pixel: no gap, no double hit. Never clipped against the
 * screen: lines above it are skipped by multiplication. Pixel (x, y) belongs to a polygon when its
 * centre is inside, or on a left or a top edge. */
#ifndef LIM_EDGE_H
#define LIM_EDGE_H

#include "profile.h"

/* The first pixel centre at or right of the edge is `x` on the current line. */
struct lim_edge {
    int32_t error;       /* M - x * denominator (edge.c), in -denominator+1 .. 0 */
    int32_t step_error;  /* what a line adds to it, 0 .. denominator-1 */
    int32_t denominator; /* lines from end to end, in sub-pixels */
    int16_t x, step_x;
    int16_t end;  /* the line on which it hands over to the next edge */
    uint8_t to;   /* the vertex at which it ends */
    uint8_t step; /* from there to the next one, modulo their number: the left boundary runs forward */
};

/* Both boundaries of a polygon, on their way down. */
struct lim_edge_pair {
    struct lim_edge left, right;
};

/* What a polygon looks like to EDGE; lines are relative to nothing: line y is screen line y. */
struct lim_edge_shape {
    int16_t top, bottom; /* lines top <= y < bottom; may lie outside of the screen */
    int16_t left, right; /* pixels left <= x < right, likewise; set if LIM_HAS_HIDDEN, which looks for what is hidden */
    uint8_t first;       /* a vertex on the top line */
    uint8_t apex;        /* if folded: from which a fan of triangles covers the polygon */
    bool folded;         /* its boundary turns more than twice: rounding bent it */
#if LIM_HAS_ANTIALIAS
    int16_t end_row; /* the row of samples (samples.h) after its last, antialiased */
#endif
};

void lim_edge_measure(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n);

/* Both boundaries of a polygon that is not folded, before its first line; lim_edge_turn() takes them to any. */
static inline void lim_edge_begin(struct lim_edge_pair *pair, uint8_t n, uint8_t first)
{
    pair->left.to = pair->right.to = first;
    pair->left.end = pair->right.end = INT16_MIN;
    pair->left.step = 1;
    pair->right.step = (uint8_t)(n - 1);
}

/* Replaces the edges that end on line y or above, top <= y < bottom. Returns the line on which it must be called
 * again. */
int16_t lim_edge_turn(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, int16_t y);

/* From the line above to line y, or from lim_edge_begin() to any line: steps the edges that go on, replaces the others.
 */
void lim_edge_advance(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, int16_t y);

/* The first line at or below a point, or the first column at or right of it. */
int16_t lim_edge_line_of(lim_sub at);

/* The first column at or right of an edge on line y; above and below its lines, that of its end. For wireframe: it
 * divides. */
int16_t lim_edge_column(struct lim_point upper, struct lim_point lower, int16_t y);

/* To the next line. */
/*@ requires \valid(edge) && 0 < edge->denominator <= 16777216;
    requires 0 <= edge->step_error < edge->denominator && -edge->denominator < edge->error <= 0;
    assigns edge->x, edge->error;
    ensures -edge->denominator < edge->error <= 0; */
static inline void lim_edge_step(struct lim_edge *edge)
{
    edge->x = (int16_t)(edge->x + edge->step_x);
    edge->error += edge->step_error;
    if (edge->error > 0) {
        edge->error -= edge->denominator;
        edge->x++;
    }
}

#endif
