/* SPDX-License-Identifier: MIT
 *
 * Memory for polygons that cross a line: first what cells and gaps have left between them, then the pool, and all that
 * lies behind it: the cache of vertices and the walk's stack, which rest in pass two, and the lines that are painted.
 */
#include "lines/active.h"

#include "movers/meet.h"

#if LIM_HAS_SPANS

/* Bits of an address that are 0 where an active polygon may lie. */
enum { ALIGN_MASK = LIM_ALIGNOF(struct lim_active) - 1 };

static uint8_t *aligned(uint8_t *at)
{
    if (LIM_ALIGNOF(struct lim_active) <= LIM_ALIGNOF(union lim_retained_cell)) return at;
    return (uint8_t *)(((uintptr_t)at + ALIGN_MASK) & ~(uintptr_t)ALIGN_MASK);
}

/* Pass one is done: neither cells nor gaps get any more. Returns where gaps begin. What moves has closed none: for that
 * gaps keep half of what is left. */
static uint8_t *take_what_is_left(struct lim_spans *spans, bool shares)
{
    const uint16_t middle = (uint16_t)((spans->lowest + spans->fresh) / 2);
    spans->lowest = shares && middle < spans->fresh ? middle : spans->fresh;
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

void lim_actives_start(struct lim_actives *actives, struct lim_spans *spans, bool by_gaps)
{
    actives->first = actives->free = NULL;
    if (LIM_HAS_STATS || LIM_HAS_MOVERS) actives->used = 0;
    if (LIM_HAS_ANTIALIAS) actives->fresh = 0;
    if (LIM_HAS_MOVERS) {
        *actives->moving = NULL;
        *actives->met = NULL;
        *actives->cut_count = 0;
        *actives->crowded = false;
        *actives->grouped = false;
    }
    actives->in_pool = false;
    actives->end = take_what_is_left(spans, LIM_HAS_MOVERS && by_gaps && lim_moves(*actives->movers));
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

uint32_t lim_actives_counted_idle_b(const struct lim_actives *actives, const struct lim_spans *spans, uint16_t y)
{
    if (!LIM_HAS_STATS) return 0;
    const struct lim_counted *const counted = spans->counted;
    const size_t taken = actives->in_pool ? (size_t)(actives->at - actives->pool) / sizeof(struct lim_active) : 0;
    const uint32_t beside = *actives->between_b / counted->active_b; /* those that gaps and cells have room for */
    const uint32_t taken_b = taken > beside ? (uint32_t)(taken - beside) * counted->active_b : 0;
    const uint32_t all_b = counted->idle_b + y * (uint32_t)sizeof(struct lim_line);

    return all_b > taken_b ? all_b - taken_b : 0;
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

static struct lim_active **crowd_of(struct lim_actives *actives, const struct lim_active *active)
{
    return active->near->owner == LIM_STILL_MET ? actives->met : actives->moving;
}

void lim_active_enter_crowd(struct lim_actives *actives, struct lim_active *active,
                            const union lim_retained_cell *cells)
{
    const uint16_t owner = lim_met_owner(cells);

    if (!LIM_HAS_MOVERS) return;
    if (owner < LIM_STILL_MET && !lim_mover_is_crowded(*actives->movers, owner)) return;
    active->near->owner = owner;
    active->near->known = false;
    active->near->y = -1;
    active->near->still[0] = active->near->still[1] = active->polygon;
    struct lim_active **link = crowd_of(actives, active);
    while (*link && (*link)->polygon < active->polygon)
        link = &(*link)->near->next;
    active->near->next = *link;
    *link = active;
    *actives->grouped = false;
}

void lim_active_leave_crowd(struct lim_actives *actives, const struct lim_active *active)
{
    struct lim_active **link = crowd_of(actives, active);

    if (!LIM_HAS_MOVERS) return;
    while (*link != active)
        link = &(*link)->near->next;
    *link = active->near->next;
    *actives->grouped = false;
}

#endif
