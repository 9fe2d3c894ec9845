/* SPDX-License-Identifier: MIT
 *
 * Cells are handed out in walk order, so a greater index means farther away, and each line's list
 * runs from far to near. */
#include "lines/retain.h"

#if LIM_HAS_SPANS

enum { CELL_WORDS = sizeof(union lim_retained_cell) / 2 };

/* Over as many cells as it takes: they follow each other. */
static inline void copy_words(uint16_t *to, const uint16_t *from, uint8_t count)
{
    while (count--)
        *to++ = *from++;
}

bool lim_retain(struct lim_spans *spans, const struct lim_retained_polygon *polygon)
{
    struct lim_retained *const retained = spans->retained;
    const bool transparent = LIM_HAS_TRANSPARENT && polygon->alpha != LIM_OPAQUE;
    const bool is_piece = LIM_HAS_NEWELL && !polygon->n;
    const uint8_t words = (uint8_t)(LIM_HAS_WIREFRAME && polygon->hidden ? (polygon->n + 15) / 16 : 0);
    const uint16_t needed = (uint16_t)(LIM_RETAINED_HEAD_CELLS + polygon->n + (transparent && !is_piece) +
                                       (words + CELL_WORDS - 1) / CELL_WORDS);

    if (!lim_share_has_cells(spans, retained, needed)) return false;
    union lim_retained_cell *cells = &retained->cells[retained->used];
    lim_retained_link(spans, retained, &spans->lines[polygon->top], polygon->n, polygon->first, polygon->bottom,
                      polygon->colour, needed);
    retained->overhangs = true; /* not known here */
    for (uint8_t k = 0; k < polygon->n; k++)
        cells[LIM_RETAINED_HEAD_CELLS + k].at = polygon->at[k];
    if (transparent) {
        cells[1].look.bottom |= LIM_RETAINED_TRANSPARENT;
        if (is_piece)
            cells[0].link.first = polygon->alpha;
        else
            cells[LIM_RETAINED_HEAD_CELLS + polygon->n].alpha = polygon->alpha;
    }
    if (LIM_HAS_WIREFRAME && words)
        copy_words(cells[LIM_RETAINED_HEAD_CELLS + polygon->n].hidden, polygon->hidden, words);
    if (LIM_HAS_TEXTURE && polygon->bottom & LIM_RETAINED_TEXTURE) retained->textured = true;
    if (transparent && LIM_HAS_MASKED && polygon->bottom & LIM_RETAINED_TEXTURE)
        retained->masked = true;
    else if (transparent)
        retained->transparent = true;
    return true;
}

#endif
