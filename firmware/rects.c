/* SPDX-License-Identifier: MIT
 *
 * Costs are in bits on the bus: 1024 x 1024 pixels of 24 bits, and a window of 65535 bytes, take 26. */
#include "rects.h"

#if LIM_HAS_DELTA

static uint32_t cost_bits(const struct lim_target_costs *costs, const struct lim_rect *rect)
{
    const uint32_t area_px = (uint32_t)(uint16_t)(rect->x1 - rect->x0) * (uint16_t)(rect->y1 - rect->y0);

    return costs->window_b * UINT32_C(8) + area_px * costs->pixel_bits;
}

static struct lim_rect around(const struct lim_rect *a, const struct lim_rect *b)
{
    return (struct lim_rect){a->x0 < b->x0 ? a->x0 : b->x0, a->y0 < b->y0 ? a->y0 : b->y0,
                             a->x1 > b->x1 ? a->x1 : b->x1, a->y1 > b->y1 ? a->y1 : b->y1};
}

bool lim_rects_add(struct lim_rects *rects, const struct lim_target_costs *costs, const struct lim_rect *rect)
{
    struct lim_rect *best = NULL;
    uint32_t least_bits = cost_bits(costs, rect);

    for (struct lim_rect *at = rects->rect; at < rects->rect + rects->count; at++) {
        const struct lim_rect grown = around(at, rect);
        const uint32_t more_bits = cost_bits(costs, &grown) - cost_bits(costs, at);
        if (more_bits >= least_bits) continue;
        least_bits = more_bits;
        best = at;
    }
    if (!best && rects->count == LIM_DELTA_RECTS) return false;
    if (best)
        *best = around(best, rect);
    else
        rects->rect[rects->count++] = *rect;
    return true;
}

static bool join_two(struct lim_rects *rects, const struct lim_target_costs *costs)
{
    for (uint16_t i = 1; i < rects->count; i++) {
        for (uint16_t k = 0; k < i; k++) {
            const struct lim_rect both = around(&rects->rect[i], &rects->rect[k]);
            if (cost_bits(costs, &both) > cost_bits(costs, &rects->rect[i]) + cost_bits(costs, &rects->rect[k]))
                continue;
            rects->rect[k] = both;
            rects->rect[i] = rects->rect[--rects->count];
            return true;
        }
    }
    return false;
}

void lim_rects_join(struct lim_rects *rects, const struct lim_target_costs *costs)
{
    while (join_two(rects, costs)) {
    }
}

#endif
