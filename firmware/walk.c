/* SPDX-License-Identifier: MIT
 *
 * Eye in front of a plane: nearest first is front subtree, own polygons that face the front, back
 * subtree. Eye behind: the mirror image. Eye exactly on it: its own polygons are edge-on and not
 * drawn; either order of the subtrees is right, and the one of an eye behind is taken. */
#include "walk.h"

#if LIM_HAS_TREE

void lim_walk_begin(struct lim_walk *walk, struct lim_walk_pending *stack, bool back_to_front)
{
    walk->stack = stack;
    walk->depth = 0;
    walk->next = walk->eye.scene->node_count ? 0 : LIM_NONE;
    walk->back_to_front = back_to_front;
}

/* NULL: all may be seen. */
static inline const uint8_t *shown_of(const struct lim_walk *walk)
{
#if LIM_HAS_PORTALS
    return walk->shown;
#else
    (void)walk;
    return NULL;
#endif
}

/* Its run is due at once. */
static inline uint16_t enter_leaf(struct lim_walk *walk, const LIM_FLASH struct lim_node *node)
{
    LIM_ASSERT(walk->depth < walk->eye.scene->limits.depth);
    walk->stack[walk->depth++] = (struct lim_walk_pending){node->front_run, LIM_NONE};
    return LIM_NONE;
}

/* Remembers what comes after the node's near subtree. Returns the root of that, or LIM_NONE. */
static inline uint16_t enter(struct lim_walk *walk, uint16_t index, const struct lim_cull *cull,
                             struct lim_stats *stats)
{
    const LIM_FLASH struct lim_node *node = &walk->eye.scene->nodes[index];

    if (lim_node_is_skipped(walk->eye.scene, node, shown_of(walk), cull, stats)) return LIM_NONE;
    if (LIM_HAS_STATS) stats->nodes++;
    if (LIM_HAS_LEAVES && node->split.plane == LIM_NONE) return enter_leaf(walk, node);
    const int32_t side = lim_eye_side(&walk->eye, &node->split);
    const bool front_first = (side > 0) != walk->back_to_front;
    LIM_ASSERT(walk->depth < walk->eye.scene->limits.depth);
    struct lim_walk_pending *pending = &walk->stack[walk->depth++];
    pending->run = side > 0 ? node->front_run : side < 0 ? node->back_run : (uint16_t)LIM_NONE;
    pending->far = front_first ? node->back : node->front;
    return front_first ? node->front : node->back;
}

uint16_t lim_walk_next(struct lim_walk *walk, const struct lim_cull *cull, struct lim_stats *stats)
{
    uint16_t next = walk->next;

    for (;;) {
        while (next != LIM_NONE)
            next = enter(walk, next, cull, stats);
        if (!walk->depth) break;
        const struct lim_walk_pending *top = &walk->stack[--walk->depth];
        next = top->far;
        if (top->run == LIM_NONE) continue;
        walk->next = next;
        return top->run;
    }
    walk->next = LIM_NONE;
    return LIM_NONE;
}

#endif
