/* SPDX-License-Identifier: MIT
 *
 * Eye in front of a plane: nearest first is front subtree, own polygons that face the front, back
 * subtree. Eye behind: the mirror image. Eye exactly on it: its own polygons are edge-on and not
 * drawn; either order of the subtrees is right, and the one of an eye behind is taken. */
#include "walk.h"

void walk_begin(struct walk *walk, const struct lim_scene *scene, const struct eye *eye, struct walk_pending *stack,
                bool back_to_front)
{
    walk->scene = scene;
    walk->eye = eye;
    walk->stack = stack;
    walk->depth = 0;
    walk->next = scene->node_count ? 0 : LIM_NONE;
    walk->back_to_front = back_to_front;
}

static uint16_t child(const struct walk *walk, const LIM_FLASH struct lim_node *node, int8_t side, bool first)
{
    const bool eye_in_front = side > 0;

    return (eye_in_front == first) != walk->back_to_front ? node->front : node->back;
}

static bool skipped(const struct walk *walk, const LIM_FLASH struct lim_node *node, const struct cull *cull,
                    struct lim_stats *stats)
{
    if (node->box == LIM_NONE) return false;
    if (LIM_HAS_STATS) stats->boxes++;
    if (cull_sees(cull, &walk->scene->boxes[node->box])) return false;
    if (LIM_HAS_STATS) stats->boxes_out++;
    return true;
}

static void enter(struct walk *walk, const struct cull *cull, struct lim_stats *stats)
{
    const uint16_t index = walk->next;
    const LIM_FLASH struct lim_node *node = &walk->scene->nodes[index];

    walk->next = LIM_NONE;
    if (skipped(walk, node, cull, stats)) return;
    if (LIM_HAS_STATS) stats->nodes++;
    const int8_t side = eye_side(walk->eye, walk->scene, node);
    LIM_ASSERT(walk->depth < walk->scene->limits.depth);
    walk->stack[walk->depth++] = (struct walk_pending){index, side};
    walk->next = child(walk, node, side, true);
}

/* Takes the top of the stack: its far subtree is next. Returns its own run. */
static uint16_t leave(struct walk *walk)
{
    const struct walk_pending *top = &walk->stack[--walk->depth];
    const LIM_FLASH struct lim_node *node = &walk->scene->nodes[top->node];

    walk->next = child(walk, node, top->side, false);
    if (top->side == 0) return LIM_NONE;
    return top->side > 0 ? node->front_run : node->back_run;
}

uint16_t walk_next(struct walk *walk, const struct cull *cull, struct lim_stats *stats)
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
