/* SPDX-License-Identifier: MIT
 *
 * PAINT: line by line, the retained polygons' pixels into the memory that the target lends. In: retained polygons,
 * listed by their top line, and what SPAN has left open. Out: finished lines, top to bottom. Where all is flat colour
 * each line is painted from far to near (flat.c). Else it closes its gaps once more, nearest polygon first, so every
 * pixel is written exactly once; what stays open is background. Memory: a list of the polygons that cross the line,
 * lent, and a stack for what is transparent (layers.h). */
#ifndef LIM_PAINT_H
#define LIM_PAINT_H

#include "stages.h"

/* lim_paint_band(): what it could not finish. */
enum {
    LIM_PAINT_ACTIVE = 1, /* too many polygons cross line *y for the pool */
    LIM_PAINT_LAYERS = 2  /* too much of line *y, which is lent, is transparent for the stack */
};

/* Paints the lines of `band`; *y moves with those that are finished. The pool of gaps is used up. Positive: above;
 * negative: the target's error. */
LIM_MUST_CHECK int lim_paint_band(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                                  const struct lim_rect *band, uint16_t *y);

/* The same where all is opaque and of one colour a polygon, as most frames are (flat.c): each line from far to near
 * over its background, which is the gaps that SPAN has left. Filling a run again costs less than to find out which of
 * its pixels are still open. */
LIM_MUST_CHECK int lim_flat_band(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                                 const struct lim_rect *band, uint16_t *y);

/* The same, antialiased (smooth_band.c): what is nearer closes samples first. */
LIM_MUST_CHECK int lim_smooth_band(struct lim_paint *paint, struct lim_spans *spans,
                                   const struct lim_retained *retained, const struct lim_rect *band, uint16_t *y);

#endif
