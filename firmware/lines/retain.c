/* SPDX-License-Identifier: MIT
 *
 * Cells are handed out in walk order, so a greater index means farther away, and each line's list
 * runs from far to near. */
#include "lines/retain.h"

#include "movers/meet.h"

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

/* Told of what follows ------------------------------------------------------------------------------------------ */

static bool tell(struct lim_spans *spans, const struct lim_met_polygon *polygon, uint16_t cells)
{
    struct lim_retained *const retained = spans->retained;

    if (!LIM_HAS_MOVERS || !lim_share_has_cells(spans, retained, cells)) return false;
    retained->used = (uint16_t)(retained->used + cells);
    *retained->told = cells;
    union lim_retained_cell *const end = &retained->cells[retained->used];
    end[-LIM_TOLD_OWNER].met.owner = polygon->owner;
    end[-LIM_TOLD_RECORD].word = polygon->record;
    if (polygon->owner == LIM_STILL_MET) end[-LIM_TOLD_NODE].word = polygon->node;
    lim_share_set_lowest(spans);
    return true;
}

bool lim_retain_tell_mover(struct lim_spans *spans, const struct lim_met_polygon *polygon)
{
    return tell(spans, polygon, LIM_TOLD_RECORD);
}

bool lim_retain_tell_still(struct lim_spans *spans, const struct lim_movers *movers,
                           const struct lim_met_polygon *polygon)
{
    const uint16_t words = (uint16_t)((movers->count + 15) / 16);

    if (!tell(spans, polygon, (uint16_t)(LIM_TOLD_NODE + words))) return false;
    union lim_retained_cell *const last = &spans->retained->cells[spans->retained->used] - LIM_TOLD_MOVERS;
    for (uint16_t k = 0; k < words; k++)
        last[-(int_fast16_t)k].word = 0;
    for (uint16_t i = 0; i < movers->count; i++)
        last[-(int_fast16_t)(i / 16)].word |= (uint32_t)movers->movers[i].met << 2 * (i % 16);
    return true;
}

void lim_retain_told(struct lim_spans *spans)
{
    if (!LIM_HAS_MOVERS) return;
    spans->retained->used = (uint16_t)(spans->retained->used - *spans->retained->told);
    *spans->retained->told = 0;
    lim_share_set_lowest(spans);
}

#endif
