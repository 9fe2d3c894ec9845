/* SPDX-License-Identifier: MIT
 *
 * The polygons that have at least one visible pixel, retained between SPAN and PAINT: their points
 * on the screen, a colour, and the line on which they start. A tenth of the memory that their
 * spans would take. The pool is lent by the caller. */
#ifndef LIM_RETAIN_H
#define LIM_RETAIN_H

#include "blend.h"
#include "profile.h"
#include "span.h"

/* A retained polygon is two head cells and one cell a vertex; if it is transparent, one more with its alpha; in
 * wireframe, as many as the flags of its edges take, an edge a bit. A piece of one (piece.h) has n = 0, its alpha in
 * the place of `first`, and a cell a line, bottom to top: x its first pixel, y the one after its last. */
union lim_retained_cell {
    struct {
        uint16_t next; /* the polygon retained before this one that starts on the same line */
        uint8_t n, first;
    } link;
    struct {
        uint16_t bottom; /* the line after its last, and LIM_RETAINED_TRANSPARENT */
        uint16_t colour; /* as it lies in memory */
    } look;
    struct lim_point at;
    uint16_t alpha;
    uint16_t hidden[sizeof(struct lim_point) / 2];
};

enum { LIM_RETAINED_HEAD_CELLS = 2 };
#define LIM_RETAINED_TRANSPARENT 0x8000u

struct lim_retained {
    union lim_retained_cell *cells;
    uint16_t size, used;
};

struct lim_retained_polygon {
    const struct lim_point *at;
    uint8_t n, first;
    uint16_t top, bottom; /* lines top <= y < bottom, on the screen */
    uint16_t colour;
#if LIM_HAS_TRANSPARENT
    uint8_t alpha;
#endif
#if LIM_HAS_WIREFRAME
    const uint16_t *hidden; /* NULL: not in wireframe */
#endif
};

static inline void lim_retained_set_hidden(struct lim_retained_polygon *polygon, const uint16_t *hidden)
{
#if LIM_HAS_WIREFRAME
    polygon->hidden = hidden;
#else
    (void)polygon, (void)hidden;
#endif
}

static inline void lim_retained_set_alpha(struct lim_retained_polygon *polygon, uint8_t alpha)
{
#if LIM_HAS_TRANSPARENT
    polygon->alpha = alpha;
#else
    (void)polygon, (void)alpha;
#endif
}

static inline int16_t lim_retained_bottom(const union lim_retained_cell *cells)
{
    const uint16_t bottom = cells[1].look.bottom;

    return (int16_t)(LIM_HAS_TRANSPARENT ? bottom & (LIM_RETAINED_TRANSPARENT - 1) : bottom);
}

static inline uint8_t lim_retained_alpha(const union lim_retained_cell *cells)
{
    if (!LIM_HAS_TRANSPARENT || !(cells[1].look.bottom & LIM_RETAINED_TRANSPARENT)) return LIM_OPAQUE;
    if (LIM_HAS_NEWELL && !cells[0].link.n) return cells[0].link.first;
    return (uint8_t)cells[LIM_RETAINED_HEAD_CELLS + cells[0].link.n].alpha;
}

/* Links the polygon into its top line. false: the pool is exhausted. */
bool lim_retain(struct lim_retained *retained, struct lim_line *lines, const struct lim_retained_polygon *polygon);

#endif
