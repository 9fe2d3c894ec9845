/* SPDX-License-Identifier: MIT
 *
 * Shimmer: what eyes notice of rounding while the camera moves slowly. A pixel that changes once is an edge that
 * passes; one that changes and is soon what it was before flickers. */
#ifndef SIM_SHIMMER_H
#define SIM_SHIMMER_H

#include "measure/measurement.h"

/* A picture, the one in which pixels have changed, and the frames within which they may flip back. */
enum { SHIMMER_WITHIN = 3, SHIMMER_SPAN = 2 + SHIMMER_WITHIN };

/* Adds what changes from pictures[0] to pictures[1], and how much of that shows the colour of pictures[0] again in any
 * of the SHIMMER_WITHIN pictures that follow. */
void shimmer_add(struct shimmer_count *sum, const uint16_t *const pictures[SHIMMER_SPAN], size_t pixel_count);

/* Of the changed pixels, percent; 0 where nothing changes. */
double shimmer_percent(const struct shimmer_count *count);

/* Up to SHIMMER_STARTS of the views, evenly chosen: from each SHIMMER_STEPS frames of a turn, to the left and by
 * SHIMMER_TURN_DEG each, and as many of a walk, ahead and by SHIMMER_WALK_M each. What moves stands still. When time is
 * over (deadline.h), nothing is known: *known. */
#define SHIMMER_TURN_DEG 0.011
#define SHIMMER_WALK_M 0.001
enum { SHIMMER_STARTS = 4, SHIMMER_STEPS = 40 };
bool shimmer_measure(const struct measure_candidate *candidate, const struct measure_views *views, struct shimmer *out,
                     struct error *err);

#endif
