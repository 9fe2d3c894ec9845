/* SPDX-License-Identifier: MIT
 *
 * WALK: the tree's polygons in visibility order, a run at a time. In: the scene, the eye, the open
 * view. Out: runs (scene.h) that face the eye. Memory: a stack as deep as the tree, lent by the
 * caller; no recursion. */
#ifndef LIM_WALK_H
#define LIM_WALK_H

#include "cull.h"
#include "eye.h"
#include "scene.h"
#include "stats.h"

/* A node whose near subtree is under way: its own polygons and its far subtree come later. */
struct lim_walk_pending {
    uint16_t node;
    int16_t side; /* of the eye: its sign counts */
};

struct lim_walk {
    const struct lim_scene *scene;
    const struct lim_eye *eye;
    struct lim_walk_pending *stack;
    uint16_t depth;
    uint16_t next; /* the subtree to enter, or LIM_NONE: the stack's top is due */
    bool back_to_front;
};

/* `stack` has scene->limits.depth entries. */
void lim_walk_begin(struct lim_walk *walk, const struct lim_scene *scene, const struct lim_eye *eye,
                    struct lim_walk_pending *stack, bool back_to_front);

/* The next run's word offset into scene->polygons, or LIM_NONE when the walk is over. `cull` may
 * have changed since the last call: the open view only ever shrinks. */
uint16_t lim_walk_next(struct lim_walk *walk, const struct lim_cull *cull, struct lim_stats *stats);

#endif
