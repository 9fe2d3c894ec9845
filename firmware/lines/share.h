/* SPDX-License-Identifier: MIT
 *
 * Cells of retained polygons (retain.h) and gaps (gaps.h) share their memory: cells come from its beginning, gaps from
 * its end, each until it meets the other. In pass two polygons that cross a line lie in what neither took (active.h).
 */
#ifndef LIM_SHARE_H
#define LIM_SHARE_H

#include "stages.h"

static inline bool lim_spans_have_strips(const struct lim_spans *spans)
{
    return LIM_HAS_ANTIALIAS && *spans->has_strips;
}

static inline uint32_t lim_share_gap_b(const struct lim_spans *spans, bool strips)
{
    if (LIM_HAS_STATS && spans->counted->gap_b) return spans->counted->gap_b;
    return strips ? (uint32_t)LIM_GAP_MEM_B : (uint32_t)sizeof(struct lim_gap);
}

static inline uint32_t lim_share_cell_b(const struct lim_spans *spans)
{
    return LIM_HAS_STATS ? spans->counted->cell_b : (uint32_t)sizeof(union lim_retained_cell);
}

/* Gaps that all of the memory would hold. */
static inline uint16_t lim_share_gaps_end(const struct lim_spans *spans)
{
    return lim_spans_have_strips(spans) ? *spans->strips_size : spans->pool_size;
}

/* The first gap that begins behind so many bytes, or one of the next two where that saves a division. */
static inline uint16_t lim_share_gap_behind(const struct lim_spans *spans, uint32_t size_b)
{
    const bool is_usual = !LIM_HAS_STATS && sizeof(struct lim_gap) == 6 && sizeof(union lim_retained_cell) == 4;

    if (is_usual && !lim_spans_have_strips(spans)) return (uint16_t)((size_b / 2 * 21846u >> 16) + 1);
    const uint32_t gap_b = lim_share_gap_b(spans, lim_spans_have_strips(spans));
    return (uint16_t)((size_b + gap_b - 1) / gap_b);
}

/* Where scan lines are the only order a band has a fence between cells and gaps: few bands leave gaps, and polygons
 * shall not have to ask for them. */
#define LIM_HAS_FENCE (LIM_HAS_SCANLINE && !LIM_HAS_NEAREST && !LIM_HAS_SORTED)

/* Where it is: half, but cells for one polygon at least. */
static inline uint16_t lim_share_cells_before_fence(const struct lim_retained *retained)
{
    const uint16_t half = retained->whole / 2, least = (uint16_t)(retained->pending + CLIP_PLANES);

    return half > least ? half : least;
}

/* After cells were taken, or given back. */
static inline void lim_share_set_lowest(struct lim_spans *spans)
{
    const struct lim_retained *retained = spans->retained;
    const uint32_t pending = LIM_OPTIMISE_SIZE && !LIM_HAS_NEWELL ? 0 : retained->pending; /* points are copied */
    const uint32_t taken = LIM_HAS_FENCE ? retained->size : retained->used + pending;

    spans->lowest = lim_share_gap_behind(spans, taken * lim_share_cell_b(spans));
}

/* Whether so many cells are free. */
static inline bool lim_share_has_cells(const struct lim_spans *spans, const struct lim_retained *retained,
                                       uint32_t needed)
{
    const uint32_t end = retained->used + needed + (LIM_HAS_MOVERS ? *retained->told : 0u);

    if ((LIM_HAS_SCANLINE || LIM_HAS_ANTIALIAS) && end > retained->size) return false;
    if (LIM_HAS_FENCE) return true;
    return end * lim_share_cell_b(spans) <= spans->fresh * lim_share_gap_b(spans, lim_spans_have_strips(spans));
}

#endif
