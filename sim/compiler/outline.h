/* SPDX-License-Identifier: MIT
 *
 * A piece as it will be drawn: its corners and every point that splits have put on its edges,
 * rounded to the grid. */
#ifndef SIM_OUTLINE_H
#define SIM_OUTLINE_H

#include "trees/bsp.h"

struct outline {
    struct grid_point *corners;
    bool *hidden; /* of each corner: the edge to the next one is none of the model's */
    size_t hidden_capacity;
    size_t count, capacity; /* count 0: rounding left fewer than three different corners */
};

/* The next corner, and whether the edge from it to the one after it is none of the model's. */
void outline_add(struct outline *outline, struct grid_point corner, bool hidden);

/* When all corners are there. */
void outline_close(struct outline *outline);

/* Replaces what is in *outline. `snapped` are the exact points, rounded. */
void outline_trace(const struct bsp *bsp, const struct bsp_piece *piece, const struct grid_point *snapped,
                   struct outline *outline);

void outline_free(struct outline *outline);

/* The best chord to halve an outline of more than 3 corners by: from corner *from to corner
 * *from + count / 2 (modulo count), where the smaller part is as large as possible. */
size_t outline_chord(const struct outline *outline);

#endif
