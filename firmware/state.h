/* SPDX-License-Identifier: MIT
 *
 * The renderer's state: what the stages share, and a struct for each stage that has one, as far as it is linked.
 * Complete here so that callers can place it; its members are private. */
#ifndef LIM_STATE_H
#define LIM_STATE_H

#include "config.h"

LIM_OPTIONAL_BEGIN

#include "orders/convex.h"
#include "orders/nearest.h"
#include "orders/painter.h"

/* For lim_movers_init(): `depth` of the static scene, `object_depth` and the rest as struct lim_movers_limits. */
#define LIM_MOVERS_MEM_B(depth, instance_count, object_depth, entry_count)                                             \
    LIM_MEM_ALIGNED_B((instance_count) * sizeof(struct lim_mover) +                                                    \
                      (entry_count) *                                                                                  \
                          (sizeof(struct lim_sorted) + sizeof(struct lim_newell_polygon) + sizeof(struct lim_cut)) +   \
                      LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) +                                        \
                      ((size_t)(depth) + (object_depth)) * sizeof(struct lim_route_pending))

/* A frame that lim_frame_begin() began. */
struct lim_ahead {
    enum lim_ahead_stage stage;
    LIM_OPTIONAL(struct lim_camera, camera, LIM_HAS_DELTA); /* what was taken in */
};

struct lim {
    struct lim_pass pass;
    LIM_OPTIONAL(struct lim_texturing, texturing, LIM_HAS_TEXTURE);
    LIM_OPTIONAL(struct lim_sorter, sorter, LIM_HAS_LISTS);
    LIM_OPTIONAL(struct lim_movers, movers, LIM_HAS_MOVERS);
    LIM_OPTIONAL(struct lim_painter, painter, LIM_HAS_PAINTED);
    LIM_OPTIONAL(struct lim_nearest, nearest, LIM_HAS_SPANS);
    LIM_OPTIONAL(struct lim_convex, convex, LIM_HAS_CONVEX);
    LIM_OPTIONAL(struct lim_delta *, delta, LIM_HAS_DELTA); /* NULL: every frame is sent whole */
    struct lim_ahead ahead;
};

/* If a frame was begun, it is no more, and has no instances. */
static inline void lim_drop_ahead(struct lim *lim)
{
    if (lim->ahead.stage == LIM_AHEAD_NONE) return;
    lim->ahead.stage = LIM_AHEAD_NONE;
    if (LIM_HAS_MOVERS) lim->movers->count = lim->movers->given = 0;
}

LIM_OPTIONAL_END

#endif
