/* SPDX-License-Identifier: MIT
 *
 * What the depth sort left to its farthest points, and why: the picture may be wrong there, and is whole. */
#ifndef SIM_UNSETTLED_H
#define SIM_UNSETTLED_H

#include "stages.h"

#include <stddef.h>
#include <stdio.h>

struct unsettled {
    size_t frames;  /* of those that were added, with at least one */
    size_t entries; /* polygons and pieces */
    size_t by[LIM_FORCED_REASONS];
};

/* Adds a frame. */
void unsettled_add(struct unsettled *sum, const struct lim_newell_stats *stats);

/* One line: "WHO: the order of 3 polygons and pieces in 1 frame could not be settled: 2 for want of memory ...". */
void unsettled_print(const struct unsettled *sum, const char *who, FILE *out);

#endif
