/* SPDX-License-Identifier: MIT
 *
 * Transparent polygons in the nearest-first order. Pass one only looks whether any of their pixels is open; pass two
 * puts their open pieces on a stack, and when all that is opaque is in the line, blends the stack from its top:
 * far to near, which is the painter's order. In: gaps. Out: blended pixels. Memory: the stack, lent, or idle in pass
 * two. */
#ifndef LIM_LAYERS_H
#define LIM_LAYERS_H

#include "colour.h"
#include "stages.h"

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

/* Of masked textures, before a line's first piece. */
static inline void lim_layers_begin(struct lim_layers *layers, const struct lim_texturing *texturing, uint16_t y)
{
    *layers->texturing = texturing;
    *layers->y = (int16_t)y;
}

/* Pieces that are pushed from now on show this masked texture, of a polygon with pixels left <= x < right on the line;
 * NULL: their colour. */
static inline void lim_layers_mask(struct lim_layers *layers, struct lim_gradients *gradients, int16_t left,
                                   int16_t right)
{
    *layers->masked = (struct lim_masked){gradients, left, right};
}

/* Of the piece that was pushed last. */
static inline void lim_layers_note(struct lim_layers *layers)
{
    const struct lim_masked *const masked = layers->masked;
    const uint8_t *const at = (const uint8_t *)masked->gradients;

    *layers->pool[layers->used - 1].masked =
        (struct lim_masked_layer){at ? (int32_t)(at - (const uint8_t *)layers->own) : 0, masked->left, masked->right};
}

/* What of its pixels a polygon of this alpha changes: where its texels are not clear, all. */
static inline uint8_t lim_layers_alpha(const struct lim_layers *layers, uint8_t alpha)
{
    return LIM_HAS_MASKED && layers->masked->gradients ? (uint8_t)LIM_OPAQUE : alpha;
}

/* Pushes what is open of the piece's pixels. */
void lim_layers_push(struct lim_layers *layers, const struct lim_spans *spans, const struct lim_line *line,
                     const struct lim_layer *piece);

/* Empties the stack into `line`, or, if it was too small, only empties it. false: it was. */
bool lim_layers_finish(struct lim_layers *layers, uint16_t *line, struct lim_stats *stats);

#endif
