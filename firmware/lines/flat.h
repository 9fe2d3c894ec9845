/* SPDX-License-Identifier: MIT
 *
 * PAINT where all is opaque and of one colour a polygon, as most frames are: each line from far to near over its
 * background. Filling a run again costs less than to find out which of its pixels are still open. */
#ifndef LIM_FLAT_H
#define LIM_FLAT_H

#include "lines/active.h"

struct lim_paint;

/* As lim_paint_band(). The gaps that SPAN has left in the lines are their background. */
LIM_MUST_CHECK int lim_flat_band(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                                 const struct lim_rect *band, uint16_t *y);

#endif
