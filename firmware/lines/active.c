/* SPDX-License-Identifier: MIT
 *
 * Memory for polygons that cross a line: first what cells and gaps have left between them, then the pool, and all that
 * lies behind it: the cache of vertices and the walk's stack, which rest in pass two, and the lines that are painted.
 */
#include "lines/active.h"

#if LIM_HAS_SPANS

/* Bits of an address that are 0 where an active polygon may lie. */
enum { ALIGN_MASK = LIM_ALIGNOF(struct lim_active) - 1 };

static uint8_t *aligned(uint8_t *at)
{
    if (LIM_ALIGNOF(struct lim_active) <= LIM_ALIGNOF(union lim_retained_cell)) return at;
    return (uint8_t *)(((uintptr_t)at + ALIGN_MASK) & ~(uintptr_t)ALIGN_MASK);
}

/* Pass one is done: neither cells nor gaps get any more. Returns where gaps begin. */
static uint8_t *take_what_is_left(struct lim_spans *spans)
{
    spans->lowest = spans->fresh;
    if (LIM_HAS_ANTIALIAS && lim_spans_have_strips(spans)) {
        const uint16_t kept =
            *spans->kept ? *spans->kept : 1; /* a line of strips takes one before anything is closed */
        const uint16_t unkept = (uint16_t)(lim_share_gaps_end(spans) - kept);
        if (unkept < spans->lowest) spans->lowest = unkept;
    }
    const size_t gap_b = lim_spans_have_strips(spans) ? LIM_GAP_MEM_B : sizeof(struct lim_gap);
    return (uint8_t *)spans->pool + spans->lowest * gap_b;
}

static LIM_IF_CALLED uint32_t counted_between_b(const struct lim_spans *spans)
{
    return spans->lowest * lim_share_gap_b(spans, lim_spans_have_strips(spans)) -
           spans->retained->used * lim_share_cell_b(spans);
}

void lim_actives_start(struct lim_actives *actives, struct lim_spans *spans)
{
    actives->first = actives->free = NULL;
    if (LIM_HAS_STATS) actives->used = 0;
    if (LIM_HAS_ANTIALIAS) actives->fresh = 0;
    actives->in_pool = false;
    actives->end = take_what_is_left(spans);
    actives->at = aligned((uint8_t *)&spans->retained->cells[spans->retained->used]);
    if (!LIM_HAS_STATS) return;
    *actives->between_b = counted_between_b(spans);
    if (spans->counted->is_apart) actives->end = actives->at;
}

/* As the processor has it that is counted for. */
static LIM_IF_CALLED bool is_full(const struct lim_actives *actives, const struct lim_spans *spans, uint16_t y)
{
    const struct lim_counted *const counted = spans->counted;
    const uint32_t line_b = y * (uint32_t)sizeof(struct lim_line);

    return actives->used >= *actives->between_b / counted->active_b + (counted->idle_b + line_b) / counted->active_b;
}

struct lim_active *lim_active_fresh(struct lim_actives *actives, const struct lim_spans *spans, uint16_t y)
{
    uint8_t *const end = (uint8_t *)&spans->lines[y];

    if (LIM_HAS_STATS && is_full(actives, spans, y)) return NULL;
    if (actives->end - actives->at < (ptrdiff_t)sizeof(struct lim_active)) {
        if (!actives->in_pool) actives->at = aligned(actives->pool);
        actives->in_pool = true;
        actives->end = end;
        if (end - actives->at < (ptrdiff_t)sizeof(struct lim_active)) return NULL;
    }
    void *const active = actives->at;
    actives->at += sizeof(struct lim_active);
    if (LIM_HAS_ANTIALIAS) actives->fresh++;
    return active;
}

#endif
