/* SPDX-License-Identifier: MIT
 *
 * Antialiased lines of which all have the same pieces, from left to right: no edge of a polygon begins or ends on them,
 * and no two of those that matter cross. What is seen is found out once, by the edges where the run begins and where it
 * ends; then each line is stepped from edge to edge, and the two polygons that meet at one are mixed at once. The same
 * pixels as by smooth_band.c. Memory: that of lim_set_antialias(). */
#ifndef LIM_SMOOTH_RUN_H
#define LIM_SMOOTH_RUN_H

#include "stages.h"

/* Draws lines from y on, whose polygons are active, up to another. *err: an enum lim_error, or the target's. Returns
 * how many were drawn; 0: line y is no such line. */
LIM_MUST_CHECK uint16_t lim_smooth_run(struct lim_paint *paint, const struct lim_spans *spans,
                                       const struct lim_retained *retained, const struct lim_rect *band, uint16_t y,
                                       int *err);

#endif
