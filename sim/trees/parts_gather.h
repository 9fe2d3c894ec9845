/* SPDX-License-Identifier: MIT
 *
 * What is one thing and does not hang together: eyes in a head, legs at a body. Planes between such parts would split
 * both. */
#ifndef SIM_PARTS_GATHER_H
#define SIM_PARTS_GATHER_H

#include "trees/parts.h"

/* What is known of a part, by its leader. */
struct survey {
    struct part part; /* no polygons: it is none, or has joined another one */
    double largest;   /* the longest diagonal of a polygon's box */
    size_t records;
};

#define PARTS_LARGEST_SHARE 0.5 /* most of the diagonal of a part's box that a polygon of it may have */

double parts_diagonal(const double low[3], const double high[3]);

/* The leader of a polygon's part; leaders[i] <= i. */
uint32_t parts_leader(uint32_t *leaders, uint32_t polygon);

/* Joins parts whose boxes overlap: a sixteenth of the smaller one's lies in the other, which is smaller than half the
 * model. Not where a polygon would be too large for what comes of it. */
void parts_gather(struct survey *surveys, uint32_t *leaders, size_t polygon_count);

#endif
