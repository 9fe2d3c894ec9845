/* SPDX-License-Identifier: MIT
 *
 * Costs are in pixels. Those of a rectangle are known while it grows: a stretch of a line is tried with each of them.
 */
#include "pixels/rects.h"

#if LIM_HAS_DELTA

static inline struct lim_rect around(const struct lim_rect *a, const struct lim_rect *b)
{
    return (struct lim_rect){a->x0 < b->x0 ? a->x0 : b->x0, a->y0 < b->y0 ? a->y0 : b->y0,
                             a->x1 > b->x1 ? a->x1 : b->x1, a->y1 > b->y1 ? a->y1 : b->y1};
}

static inline uint32_t area(const struct lim_rect *rect)
{
    return (uint32_t)(rect->x1 - rect->x0) * (uint32_t)(rect->y1 - rect->y0);
}

static void set(struct lim_rects *rects, uint16_t i, const struct lim_rect *rect)
{
    rects->rect[i] = *rect;
    rects->area_px[i] = area(rect);
}

static void rects_swap(struct lim_rects *rects, uint16_t i, uint16_t k)
{
    const struct lim_rect rect = rects->rect[i];
    const uint32_t area_px = rects->area_px[i];

    rects->rect[i] = rects->rect[k];
    rects->area_px[i] = rects->area_px[k];
    rects->rect[k] = rect;
    rects->area_px[k] = area_px;
}

/* Growing from y1 to line y takes a rectangle's own width for each line between, and line y: where that is a window's
 * cost, what it would grow over can as well be on its own, now and on all lines below. */
static void retire(struct lim_rects *rects, uint16_t y)
{
    rects->y = y;
    for (uint16_t i = 0; i < rects->growing;) {
        const struct lim_rect *rect = &rects->rect[i];
        if (rect->y1 < y && (uint32_t)(y - rect->y1) * (uint32_t)(rect->x1 - rect->x0) >= rects->window_px)
            rects_swap(rects, i, --rects->growing);
        else
            i++;
    }
}

/* No rectangle begins below this one. One that grows by no more than what joins it cannot be bettered. */
bool lim_rects_add(struct lim_rects *rects, const struct lim_rect *rect)
{
    const uint32_t own_px = area(rect);
    uint32_t least_px = own_px + rects->window_px;
    uint16_t best = rects->count;

    if (rect->y0 != rects->y) retire(rects, rect->y0);
    for (uint16_t i = 0; i < rects->growing && least_px > own_px; i++) {
        const struct lim_rect *at = &rects->rect[i];
        const uint32_t x0 = at->x0 < rect->x0 ? at->x0 : rect->x0, x1 = at->x1 > rect->x1 ? at->x1 : rect->x1;
        const uint32_t more_px = (x1 - x0) * (uint32_t)(rect->y1 - at->y0) - rects->area_px[i];
        if (more_px >= least_px) continue;
        least_px = more_px;
        best = i;
    }
    if (best == LIM_DELTA_RECTS) return false;
    const struct lim_rect grown = best < rects->count ? around(&rects->rect[best], rect) : *rect;
    set(rects, best, &grown);
    if (best < rects->count) return true;
    rects->count++;
    rects_swap(rects, rects->growing++, best);
    return true;
}

/* Puts rectangle i into one of those before it, whose index comes back; i: it stays on its own. */
static uint16_t join_before(struct lim_rects *rects, uint16_t i)
{
    for (uint16_t k = 0; k < i; k++) {
        const struct lim_rect both = around(&rects->rect[i], &rects->rect[k]);
        if (area(&both) > rects->area_px[i] + rects->area_px[k] + rects->window_px) continue;
        set(rects, k, &both);
        set(rects, i, &rects->rect[--rects->count]);
        return k;
    }
    return i;
}

/* What has grown is tried again: with those before it, and those behind it are tried with it. */
void lim_rects_join(struct lim_rects *rects)
{
    for (uint16_t i = 0; i < rects->count;) {
        const uint16_t joined = join_before(rects, i);
        i = joined < i ? joined : (uint16_t)(i + 1);
    }
    rects->growing = 0;
}

void lim_rects_clear(struct lim_rects *rects)
{
    rects->count = rects->growing = 0;
}

#endif
