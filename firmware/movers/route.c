/* SPDX-License-Identifier: MIT
 *
 * As WALK, but a node waits on the stack instead of its run: what comes is told with its node and the eye's side. */
#include "movers/route.h"

#include "eye.h"
#include "movers/mover.h"
#include "movers/mover_long.h"
#include "view/cull.h"
#include "view/pass.h"
#include "view/walk.h"

#if LIM_HAS_MOVERS

/* The node to enter, or NULL: nothing of it can be seen. */
const LIM_FLASH struct lim_node *lim_route_node_to_enter(struct lim_route *route)
{
    const LIM_FLASH struct lim_node *node = &route->scene->nodes[route->next];

    if (lim_node_is_skipped(route->scene, node, route->shown, route->eye, route->cull, route->depth,
                            lim_stats_of(route->pass))) {
        route->next = LIM_NO_INDEX;
        return NULL;
    }
    if (LIM_HAS_STATS) lim_stats_of(route->pass)->nodes++;
    LIM_DEBUG_ASSERT(route->depth < route->scene->limits.depth);
    return node;
}

int32_t lim_route_side(const struct lim_route *route, const LIM_FLASH struct lim_node *node)
{
    return lim_eye_side(route->eye, &node->split);
}

/* WALK's loop, with locals for what it changes. Objects are mostly chains of nodes with one child: nothing has to wait
 * where there is nothing before a run, and nothing where none comes and nothing after it. */
lim_index lim_route_next(struct lim_route *route)
{
    const struct lim_scene *const scene = route->scene;
    const LIM_FLASH struct lim_node *const nodes = scene->nodes;
    const struct lim_eye *const eye = route->eye;
    struct lim_stats *const stats = lim_stats_of(route->pass);
    lim_index next = route->next, run = LIM_NO_INDEX;
    uint16_t depth = route->depth;

    while (run == LIM_NO_INDEX) {
        if (next == LIM_NO_INDEX) {
            if (!depth) break;
            const struct lim_route_pending *top = &route->stack[--depth];
            const LIM_FLASH struct lim_node *node = &nodes[top->node];
            next = top->side > 0 ? node->back : node->front;
            run = top->side > 0 ? node->front_run : top->side < 0 ? node->back_run : (lim_index)LIM_NO_INDEX;
            route->node = top->node;
            route->side = top->side;
            continue;
        }
        const LIM_FLASH struct lim_node *node = &nodes[next];
        const lim_index self = next;
        next = LIM_NO_INDEX;
        if (lim_node_is_skipped(scene, node, route->shown, eye, route->cull, depth, stats)) continue;
        if (LIM_HAS_STATS) stats->nodes++;
        if (lim_node_is_leaf(node)) {
            run = node->front_run;
            route->node = self;
            route->side = 1;
            continue;
        }
        const int32_t side = lim_eye_side(eye, &node->split);
        const lim_index near = side > 0 ? node->front : node->back, far = side > 0 ? node->back : node->front;
        const lim_index own = side > 0 ? node->front_run : side < 0 ? node->back_run : (lim_index)LIM_NO_INDEX;
        if (near == LIM_NO_INDEX) {
            next = far;
            run = own;
            route->node = self;
            route->side = (int8_t)((side > 0) - (side < 0));
            continue;
        }
        next = near;
        if (far == LIM_NO_INDEX && own == LIM_NO_INDEX) continue;
        LIM_DEBUG_ASSERT(depth < scene->limits.depth);
        route->stack[depth++] = (struct lim_route_pending){self, 0, (int8_t)((side > 0) - (side < 0))};
    }
    route->next = next;
    route->depth = depth;
    return run;
}

/* Whether an object that the whole screen shows has no box but that of all: what has come here is in view. */
static bool is_all_in_view(const struct lim_pass *pass, const struct lim_scene *object, const struct lim_rect *open)
{
    const struct lim_target *target = &pass->target;

    return object->box_count <= 1 && !open->x0 && !open->y0 && open->x1 == target->w_px && open->y1 == target->h_px;
}

/* Each field for itself: an initialiser would be a call of memset(). */
void lim_route_object(struct lim_route *route, struct lim_pass *pass, struct lim_movers *movers, uint16_t mover,
                      const struct lim_rect *open)
{
    const struct lim_mover *self = &movers->movers[mover];

    route->pass = pass;
    route->scene = movers->instances[mover].object;
    route->eye = &self->eye;
    route->cull = movers->cull;
    route->shown = NULL;
    route->stack = movers->object_stack;
    route->node = LIM_NO_INDEX;
    route->side = 0;
    route->depth = 0;
    route->next = 0;
    if (LIM_HAS_CULL && is_all_in_view(pass, route->scene, open)) {
        movers->cull->inside_depth = 0;
    } else if (LIM_HAS_CULL && LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers)) {
        (void)lim_mover_view(movers, mover); /* sets its rows */
        lim_mover_set_far_cull(movers->cull, self, open);
    } else if (LIM_HAS_CULL) {
        lim_cull_set(movers->cull, lim_mover_view(movers, mover), self->eye.at_q8, open);
    }
}

#endif
