/* SPDX-License-Identifier: MIT
 *
 * The polygons that have at least one visible pixel, retained between SPAN and PAINT: their points
 * on the screen, a colour, and the line on which they start. A tenth of the memory that their
 * spans would take. The pool is lent by the caller. */
#ifndef LIM_RETAIN_H
#define LIM_RETAIN_H

#include "profile.h"
#include "span.h"

/* A retained polygon is two head cells and one cell a vertex; a piece of one (piece.h) has n = 0 and a cell a line,
 * bottom to top: x its first pixel, y the one after its last. */
union lim_retained_cell {
    struct {
        uint16_t next; /* the polygon retained before this one that starts on the same line */
        uint8_t n, first;
    } link;
    struct {
        uint16_t bottom; /* the line after its last */
        uint16_t colour; /* as it lies in memory */
    } look;
    struct lim_point at;
};

enum { LIM_RETAINED_HEAD_CELLS = 2 };

struct lim_retained {
    union lim_retained_cell *cells;
    uint16_t size, used;
};

struct lim_retained_polygon {
    const struct lim_point *at;
    uint8_t n, first;
    uint16_t top, bottom; /* lines top <= y < bottom, on the screen */
    uint16_t colour;
};

/* Links the polygon into its top line. false: the pool is exhausted. */
bool lim_retain(struct lim_retained *retained, struct lim_line *lines, const struct lim_retained_polygon *polygon);

#endif
