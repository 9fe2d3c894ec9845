/* SPDX-License-Identifier: MIT
 *
 * WALK: the tree's polygons in visibility order, a run at a time. In: the scene, the eye, the open
 * view. Out: runs (scene.h) that face the eye, and leaves' runs, whose records may or may not. Memory: a stack as deep
 * as the tree, lent by the caller; no recursion. */
#ifndef LIM_WALK_H
#define LIM_WALK_H

#include "camera.h"
#include "eye.h"
#include "stages.h"
#include "view/cull.h"
#include "view/portals.h"

static inline bool lim_box_is_out(const struct lim_scene *scene, lim_index number, const struct lim_eye *eye,
                                  struct lim_cull *cull, uint16_t depth)
{
    if (LIM_HAS_LONG && lim_scene_long(scene)) {
        struct lim_box box;
        lim_eye_long_box(eye, &lim_scene_long(scene)->boxes[number], &box);
        return !lim_cull_enters(cull, (const LIM_FLASH struct lim_box *)&box, depth);
    }
    return !lim_cull_enters(cull, &scene->boxes[number], depth);
}

/* Whether a subtree is out of view, or cannot be seen from where the eye is. shown: as in lim_walk; depth: of the
 * walk's stack. */
static inline bool lim_node_is_skipped(const struct lim_scene *scene, const LIM_FLASH struct lim_node *node,
                                       const uint8_t *shown, const struct lim_eye *eye, struct lim_cull *cull,
                                       uint16_t depth, struct lim_stats *stats)
{
    if (!LIM_HAS_CULL || node->box == LIM_NO_INDEX) return false;
    if (LIM_HAS_PORTALS && shown && !lim_portals_show(shown, node->box)) {
        if (LIM_HAS_STATS) stats->hidden++;
        return true;
    }
    if (cull->inside_depth <= depth) return false;
    if (LIM_HAS_STATS) stats->boxes++;
    if (!lim_box_is_out(scene, node->box, eye, cull, depth)) return false;
    if (LIM_HAS_STATS) stats->boxes_out++;
    return true;
}

/* Lends a scene's walk its memory: a stack of limits.depth entries, and lim_portals_mem_b() bytes. */
static inline void lim_walk_lend(struct lim_walk *walk, const struct lim_scene *scene, struct lim_walk_pending *stack,
                                 void *portals_mem)
{
    walk->stack = stack;
    if (LIM_HAS_PORTALS) lim_portals_lend(walk->portals, scene, portals_mem);
}

/* What can be seen from around the eye, which is set: until it is set anew. */
void lim_walk_look_around(struct lim_walk *walk, const struct lim_camera *camera, uint32_t far_units);

/* Through the scene of walk->eye, which is set. */
void lim_walk_begin(struct lim_walk *walk, bool back_to_front);

/* The next run's word offset into scene->polygons, or LIM_NO_INDEX when the walk is over. `cull` may
 * have changed since the last call: the open view only ever shrinks. */
lim_index lim_walk_next(struct lim_walk *walk, struct lim_cull *cull, struct lim_stats *stats);

#endif
