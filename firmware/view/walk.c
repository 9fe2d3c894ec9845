/* SPDX-License-Identifier: MIT
 *
 * Eye in front of a plane: nearest first is front subtree, own polygons that face the front, back
 * subtree. Eye behind: the mirror image. Eye exactly on it: its own polygons are edge-on and not
 * drawn; either order of the subtrees is right, and the one of an eye behind is taken. */
#include "view/walk.h"

#include "camera.h"
#include "eye.h"

#if LIM_HAS_TREE

void lim_walk_look_around(struct lim_walk *walk, const struct lim_camera *camera, uint32_t far_units)
{
    const struct lim_portals *portals = walk->portals;

    walk->shown = NULL;
    if (!LIM_HAS_PORTALS || !portals->bits) return;
    if (lim_portals_unpack(portals, &walk->eye, lim_portals_ball_units(camera, far_units))) walk->shown = portals->bits;
}

void lim_walk_begin(struct lim_walk *walk, bool back_to_front)
{
    walk->depth = 0;
    walk->next = walk->eye.scene->node_count ? 0 : LIM_NO_INDEX;
    walk->back_to_front = back_to_front;
}

/* Only these walk from back to front: else there is nothing to ask. */
static inline bool is_back_to_front(const struct lim_walk *walk)
{
    return (LIM_HAS_PAINTER || LIM_HAS_FALLBACK) && walk->back_to_front;
}

/* Says what comes after the node's near subtree. Returns the root of that, or LIM_NO_INDEX. */
static inline lim_index enter(const struct lim_walk *walk, const LIM_FLASH struct lim_node *node,
                              struct lim_walk_pending *pending)
{
    const int32_t side = lim_eye_side(&walk->eye, &node->split);
    const bool front_first = (side > 0) != is_back_to_front(walk);

    pending->run = side > 0 ? node->front_run : side < 0 ? node->back_run : (lim_index)LIM_NO_INDEX;
    pending->far = front_first ? node->back : node->front;
    return front_first ? node->front : node->back;
}

lim_index lim_walk_next(struct lim_walk *walk, struct lim_cull *cull, struct lim_stats *stats)
{
    const LIM_FLASH struct lim_node *nodes = walk->eye.scene->nodes;
    lim_index next = walk->next, run = LIM_NO_INDEX;
    uint16_t depth = walk->depth;

    do {
        if (next == LIM_NO_INDEX) {
            if (!depth) break;
            const struct lim_walk_pending *top = &walk->stack[--depth];
            next = top->far;
            run = top->run;
            continue;
        }
        const LIM_FLASH struct lim_node *node = &nodes[next];
        next = LIM_NO_INDEX;
        if (lim_node_is_skipped(walk->eye.scene, node, walk->shown, &walk->eye, cull, depth, stats)) continue;
        if (LIM_HAS_STATS) stats->nodes++;
        if (lim_node_is_leaf(node)) {
            run = node->front_run;
            continue;
        }
        LIM_DEBUG_ASSERT(depth < walk->eye.scene->limits.depth);
        next = enter(walk, node, &walk->stack[depth++]);
    } while (run == LIM_NO_INDEX);
    walk->next = next;
    walk->depth = depth;
    return run;
}

#endif
