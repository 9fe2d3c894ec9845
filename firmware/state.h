/* SPDX-License-Identifier: MIT
 *
 * The renderer's state: a stage a member, in the order in which data passes them. Complete here so
 * that callers can place it; its members are private. */
#ifndef LIM_STATE_H
#define LIM_STATE_H

#include "cull.h"
#include "eye.h"
#include "paint.h"
#include "retain.h"
#include "span.h"
#include "stats.h"
#include "target.h"
#include "view.h"
#include "walk.h"

/* Bytes that lim_init() cuts up: a constant expression when its arguments are. A scene's header has
 * it with the scene's limits filled in: NAME_SCENE_MEM_B(h_px). */
#define LIM_MEM_B(h_px, depth, cell_count, gap_count, active_count)                                                    \
    ((LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) + (h_px) * sizeof(struct lim_line) +                     \
      (depth) * sizeof(struct lim_walk_pending) + (cell_count) * sizeof(union lim_retained_cell) +                     \
      (gap_count) * sizeof(struct lim_gap) + (active_count) * sizeof(struct lim_active) + 3) &                         \
     ~(size_t)3)

struct lim {
    const struct lim_scene *scene;
    struct lim_target target;
    struct lim_eye eye;
    struct lim_cull cull;
    struct lim_walk walk;
    struct lim_walk_pending *stack;
    struct lim_view view;
    struct lim_spans spans;
    struct lim_retained retained;
    struct lim_paint paint;
    struct lim_stats stats;
};

#endif
