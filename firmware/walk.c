/* SPDX-License-Identifier: MIT
 *
 * Eye in front of a plane: nearest first is front subtree, own polygons that face the front, back
 * subtree. Eye behind: the mirror image. Eye exactly on it: its own polygons are edge-on and not
 * drawn; either order of the subtrees is right, and the one of an eye behind is taken. */
#include "walk.h"

#if LIM_HAS_TREE

void lim_walk_begin(struct lim_walk *walk, const struct lim_scene *scene, const struct lim_eye *eye,
                    struct lim_walk_pending *stack, bool back_to_front)
{
    walk->scene = scene;
    walk->eye = eye;
    walk->stack = stack;
    walk->depth = 0;
    walk->next = scene->node_count ? 0 : LIM_NONE;
    walk->back_to_front = back_to_front;
}

static uint16_t child(const struct lim_walk *walk, const LIM_FLASH struct lim_node *node, int16_t side, bool first)
{
    const bool eye_in_front = side > 0;

    return (eye_in_front == first) != walk->back_to_front ? node->front : node->back;
}

static bool skipped(const struct lim_walk *walk, const LIM_FLASH struct lim_node *node, const struct lim_cull *cull,
                    struct lim_stats *stats)
{
    if (!LIM_HAS_CULL || node->box == LIM_NONE) return false;
    if (LIM_HAS_STATS) stats->boxes++;
    if (lim_cull_sees(cull, &walk->scene->boxes[node->box])) return false;
    if (LIM_HAS_STATS) stats->boxes_out++;
    return true;
}

static void enter(struct lim_walk *walk, const struct lim_cull *cull, struct lim_stats *stats)
{
    const uint16_t index = walk->next;
    const LIM_FLASH struct lim_node *node = &walk->scene->nodes[index];

    walk->next = LIM_NONE;
    if (skipped(walk, node, cull, stats)) return;
    if (LIM_HAS_STATS) stats->nodes++;
    const int16_t side = lim_eye_side(walk->eye, walk->scene, node);
    LIM_ASSERT(walk->depth < walk->scene->limits.depth);
    walk->stack[walk->depth++] = (struct lim_walk_pending){index, side};
    walk->next = child(walk, node, side, true);
}

/* Takes the top of the stack: its far subtree is next. Returns its own run. */
static uint16_t leave(struct lim_walk *walk)
{
    const struct lim_walk_pending *top = &walk->stack[--walk->depth];
    const LIM_FLASH struct lim_node *node = &walk->scene->nodes[top->node];

    walk->next = child(walk, node, top->side, false);
    if (top->side == 0) return LIM_NONE;
    return top->side > 0 ? node->front_run : node->back_run;
}

uint16_t lim_walk_next(struct lim_walk *walk, const struct lim_cull *cull, struct lim_stats *stats)
{
    for (;;) {
        if (walk->next != LIM_NONE) {
            enter(walk, cull, stats);
        } else if (walk->depth) {
            const uint16_t run = leave(walk);
            if (run != LIM_NONE) return run;
        } else {
            return LIM_NONE;
        }
    }
}

#endif
