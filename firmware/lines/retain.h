/* SPDX-License-Identifier: MIT
 *
 * The polygons that have at least one visible pixel, by scan lines all that are in view, retained between SPAN and
 * PAINT: their points on the screen, a colour, and the line on which they start. A tenth of the memory that their
 * spans would take. The pool is lent by the caller. */
#ifndef LIM_RETAIN_H
#define LIM_RETAIN_H

#include "lines/share.h"
#include "screen/polygon.h"

static inline void lim_retained_clear(struct lim_retained *retained)
{
    retained->used = 0;
    retained->overhangs = false;
    if (LIM_HAS_MOVERS) *retained->told = 0;
    if (LIM_HAS_TRANSPARENT) retained->transparent = false;
    if (LIM_HAS_TEXTURE) retained->textured = false;
    if (LIM_HAS_MASKED) retained->masked = false;
}

struct lim_retained_polygon {
    const struct lim_point *at;
    uint8_t n, first;
    uint16_t top, bottom; /* lines top <= y < bottom, on the screen; bottom perhaps with LIM_RETAINED_TEXTURE */
    uint16_t colour;
    uint8_t alpha;
    const uint16_t *hidden; /* NULL: not in wireframe */
};

/* What is transparent has a masked texture or none; in wireframe all is opaque and has none. */
static inline struct lim_retained_polygon lim_retained_of(const struct lim_screen_polygon *polygon, int16_t top,
                                                          int16_t bottom, bool wireframe)
{
    struct lim_retained_polygon seen;

    seen.at = polygon->at;
    seen.n = polygon->n;
    seen.first = polygon->shape.first;
    seen.top = (uint16_t)top;
    seen.bottom = (uint16_t)bottom;
    seen.colour = polygon->colour;
    seen.alpha = wireframe ? (uint8_t)LIM_OPAQUE : lim_alpha_of(polygon);
    seen.hidden = wireframe ? lim_hidden_of(polygon) : NULL;
    if (LIM_HAS_TEXTURE && lim_screen_texture(polygon) != LIM_NONE && !wireframe &&
        (LIM_HAS_MASKED || lim_alpha_of(polygon) == LIM_OPAQUE)) {
        seen.colour = lim_screen_texture(polygon);
        seen.bottom |= LIM_RETAINED_TEXTURE;
    }
    return seen;
}

static inline uint16_t lim_retained_bottom(const union lim_retained_cell *cells)
{
    const uint16_t flags = (LIM_HAS_TRANSPARENT ? LIM_RETAINED_TRANSPARENT : 0u) |
                           (LIM_HAS_TEXTURE ? LIM_RETAINED_TEXTURE : 0u) | (LIM_HAS_MOVERS ? LIM_RETAINED_MET : 0u);

    return (uint16_t)(cells[1].look.bottom & ~flags);
}

static inline bool lim_retained_has_texture(const union lim_retained_cell *cells)
{
    return LIM_HAS_TEXTURE && cells[1].look.bottom & LIM_RETAINED_TEXTURE;
}

static inline uint8_t lim_retained_alpha(const union lim_retained_cell *cells)
{
    if (!LIM_HAS_TRANSPARENT || !(cells[1].look.bottom & LIM_RETAINED_TRANSPARENT)) return LIM_OPAQUE;
    if (LIM_HAS_NEWELL && !cells[0].link.n) return cells[0].link.first;
    return (uint8_t)cells[LIM_RETAINED_HEAD_CELLS + cells[0].link.n].alpha;
}

LIM_STATIC_ASSERT(sizeof(union lim_retained_cell) == sizeof(struct lim_point), "points lie one a cell");

/* Where the points of the next polygon would come to lie. */
static inline struct lim_point *lim_retained_end(const struct lim_retained *retained)
{
    return &retained->cells[retained->used + LIM_RETAINED_HEAD_CELLS].at;
}

/* Where the points of the next polygon of n corners would lie, or NULL: there is no room. */
static inline struct lim_point *lim_retained_place(const struct lim_spans *spans, const struct lim_retained *retained,
                                                   uint8_t n)
{
    return lim_share_has_cells(spans, retained, LIM_RETAINED_HEAD_CELLS + (uint32_t)n) ? lim_retained_end(retained)
                                                                                       : NULL;
}

/* Points that lie farther on move to the end. */
static inline const struct lim_point *lim_retained_move(const struct lim_retained *retained, const struct lim_point *at,
                                                        uint8_t n)
{
    struct lim_point *const to = lim_retained_end(retained);

    for (uint8_t k = 0; k < n; k++)
        to[k] = at[k];
    return to;
}

/* What the cells before a polygon tell is told of the next one, too. */
static inline void lim_retained_tell_again(struct lim_retained *retained)
{
    union lim_retained_cell *const to = &retained->cells[retained->used];
    const uint16_t told = *retained->told;
    const union lim_retained_cell *from = &retained->cells[*retained->last] - told;

    for (uint16_t k = 0; k < told; k++)
        to[k] = from[k];
    retained->used = (uint16_t)(retained->used + told);
}

/* Links a polygon that takes so many cells, of which there are as many, into its top line. Points and flags are the
 * caller's to write. */
static inline void lim_retained_link(struct lim_spans *spans, struct lim_retained *retained, struct lim_line *line,
                                     uint8_t n, uint8_t first, uint16_t bottom, uint16_t colour, uint16_t cell_count)
{
    const uint16_t self = retained->used;
    union lim_retained_cell *cells = &retained->cells[self];

    cells[0].link.next = line->retained;
    cells[0].link.n = n;
    cells[0].link.first = first;
    cells[1].look.bottom = bottom;
    cells[1].look.colour = colour;
    line->retained = self;
    retained->used = (uint16_t)(self + cell_count);
    if (LIM_HAS_MOVERS && *retained->told) {
        cells[1].look.bottom |= LIM_RETAINED_MET;
        *retained->last = self;
        lim_retained_tell_again(retained);
    }
    if (!LIM_HAS_FENCE) lim_share_set_lowest(spans);
}

/* Links the polygon into its top line. false: the pool is exhausted. */
bool lim_retain(struct lim_spans *spans, const struct lim_retained_polygon *polygon);

/* The cells before the next polygons: of a mover's record, or of what stands still, as movers' `met` have it. false:
 * there is no room. They are taken back. */
bool lim_retain_tell_mover(struct lim_spans *spans, const struct lim_met_polygon *polygon);
bool lim_retain_tell_still(struct lim_spans *spans, const struct lim_movers *movers,
                           const struct lim_met_polygon *polygon);
void lim_retain_told(struct lim_spans *spans);

#endif
