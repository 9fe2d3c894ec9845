/* SPDX-License-Identifier: MIT
 *
 * Transparent polygons in the nearest-first order. Pass one only looks whether any of their pixels is open; pass two
 * puts their open pieces on a stack, and when all that is opaque is in the line, blends the stack from its top:
 * far to near, which is the painter's order. In: gaps. Out: blended pixels. Memory: the stack, lent, or idle in pass
 * two. */
#ifndef LIM_LAYERS_H
#define LIM_LAYERS_H

#include "stages.h"

/* Whether any of the pixels x0 <= x < x1 of a line is open. */
bool lim_layers_see_line(const struct lim_spans *spans, uint16_t y, int16_t x0, int16_t x1);

/* Whether any pixel of a polygon that is not non-monotone is open, on the lines top <= y < bottom that it has. */
bool lim_layers_see(const struct lim_spans *spans, const struct lim_screen_polygon *polygon, int16_t top,
                    int16_t bottom);

/* Before a line's first piece, when all that crosses it is active: the stack lies where it may be highest, in memory of
 * its own, or in the pool of active polygons and what follows that (active.c), as far as no polygon took it. */
void lim_layers_open(struct lim_layers *layers, const struct lim_actives *actives, const struct lim_spans *spans,
                     uint16_t y);

/* The same in its own memory: antialiased, how many layers fit is seen, as a line with more of them is not smooth. */
static inline void lim_layers_open_own(struct lim_layers *layers)
{
    layers->pool = layers->own;
    layers->size = layers->own_size;
}

/* Pushes what is open of the piece's pixels. */
void lim_layers_push(struct lim_layers *layers, const struct lim_spans *spans, const struct lim_line *line,
                     const struct lim_layer *piece);

/* Empties the stack into `line`, or, if it was too small, only empties it. false: it was. */
bool lim_layers_finish(struct lim_layers *layers, uint16_t *line, struct lim_stats *stats);

#endif
