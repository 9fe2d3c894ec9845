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

enum lim_paint_pool {
    LIM_PAINT_FITS,
    LIM_PAINT_ACTIVE, /* too many polygons cross the line */
    LIM_PAINT_LAYERS  /* too much of the line, which is lent, is transparent for the stack */
};

/* Where painting a band has ended, and which pool is too small for the line there. */
struct lim_paint_stop {
    uint16_t y;
    uint_fast8_t exhausted; /* enum lim_paint_pool */
};

static inline int lim_paint_stops(struct lim_paint_stop *stop, enum lim_paint_pool exhausted)
{
    stop->exhausted = (uint_fast8_t)exhausted;
    return 0;
}

/* Line y, to be painted; a line that is lent already, because what it took did not fit, is not lent again. */
static inline uint16_t *lim_paint_lend(struct lim_paint *paint, uint16_t y)
{
    const struct lim_target *target = &paint->pass->target;

    if (LIM_HAS_LENT && LIM_HAS_MOVERS && *paint->lent) {
        uint16_t *const line = *paint->lent;
        *paint->lent = NULL;
        return line;
    }
    return target->lend(target->ctx, y);
}

/* Paints the lines of `band` until it is done, a pool is exhausted or the target returns another number than 0, which
 * comes back. stop->exhausted is LIM_PAINT_FITS before. The pool of gaps is used up. */
LIM_MUST_CHECK int lim_paint_band(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                                  const struct lim_rect *band, struct lim_paint_stop *stop);

/* The same where all is opaque and of one colour a polygon, as most frames are (flat.c): each line from far to near
 * over its background, which is the gaps that SPAN has left. Filling a run again costs less than to find out which of
 * its pixels are still open. */
LIM_MUST_CHECK int lim_flat_band(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                                 const struct lim_rect *band, struct lim_paint_stop *stop);

/* The same, antialiased (smooth_band.c): what is nearer closes samples first. */
LIM_MUST_CHECK int lim_smooth_band(struct lim_paint *paint, struct lim_spans *spans,
                                   const struct lim_retained *retained, const struct lim_rect *band,
                                   struct lim_paint_stop *stop);

#endif
