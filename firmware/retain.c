/* SPDX-License-Identifier: MIT
 *
 * Cells are handed out in walk order, so a greater index means farther away, and each line's list
 * runs from far to near. */
#include "retain.h"

#if LIM_HAS_SPANS

static inline uint8_t alpha_of(const struct lim_retained_polygon *polygon)
{
#if LIM_HAS_TRANSPARENT
    return polygon->alpha;
#else
    (void)polygon;
    return LIM_OPAQUE;
#endif
}

bool lim_retain(struct lim_retained *retained, struct lim_line *lines, const struct lim_retained_polygon *polygon)
{
    const uint8_t alpha = alpha_of(polygon);
    const bool transparent = LIM_HAS_TRANSPARENT && alpha != LIM_OPAQUE;
    const bool is_piece = LIM_HAS_NEWELL && !polygon->n;
    const uint16_t needed = (uint16_t)(LIM_RETAINED_HEAD_CELLS + polygon->n + (transparent && !is_piece));

    if (needed > retained->size - retained->used) return false;
    const uint16_t self = retained->used;
    union lim_retained_cell *cells = &retained->cells[self];
    struct lim_line *line = &lines[polygon->top];

    cells[0].link.next = line->retained;
    cells[0].link.n = polygon->n;
    cells[0].link.first = polygon->first;
    cells[1].look.bottom = polygon->bottom;
    cells[1].look.colour = polygon->colour;
    for (uint8_t k = 0; k < polygon->n; k++)
        cells[LIM_RETAINED_HEAD_CELLS + k].at = polygon->at[k];
    if (transparent) {
        cells[1].look.bottom |= LIM_RETAINED_TRANSPARENT;
        if (is_piece)
            cells[0].link.first = alpha;
        else
            cells[LIM_RETAINED_HEAD_CELLS + polygon->n].alpha = alpha;
    }
    line->retained = self;
    retained->used = (uint16_t)(self + needed);
    return true;
}

#endif
