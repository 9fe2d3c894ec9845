/* SPDX-License-Identifier: MIT
 *
 * As WALK, but a node waits on the stack instead of its run: what comes is told with its node and the eye's side. */
#include "routes/route.h"

#include "eye.h"
#include "view/cull.h"
#include "view/pass.h"
#include "view/walk.h"

#if LIM_HAS_MOVERS

void lim_route_begin(struct lim_route *route, uint16_t list)
{
    route->depth = 0;
    route->next = route->scene->node_count ? 0 : LIM_NO_INDEX;
    route->list = list;
}

/* The node to enter, or NULL: nothing of it can be seen. */
const LIM_FLASH struct lim_node *lim_route_node_to_enter(struct lim_route *route)
{
    const LIM_FLASH struct lim_node *node = &route->scene->nodes[route->next];

    if (lim_node_is_skipped(route->scene, node, route->shown, route->cull, route->depth,
                            lim_stats_of(route->sorter->pass))) {
        route->next = LIM_NO_INDEX;
        return NULL;
    }
    if (LIM_HAS_STATS) lim_stats_of(route->sorter->pass)->nodes++;
    LIM_DEBUG_ASSERT(route->depth < route->scene->limits.depth);
    return node;
}

/* The near subtree is next, with what moves in it; the rest waits. */
void lim_route_go_near(struct lim_route *route, const LIM_FLASH struct lim_node *node, int32_t side, uint16_t front,
                       uint16_t back)
{
    const bool front_first = (side > 0) != route->back_to_front;

    route->stack[route->depth++] =
        (struct lim_route_pending){route->next, front_first ? back : front, (int8_t)((side > 0) - (side < 0))};
    route->list = front_first ? front : back;
    route->next = front_first ? node->front : node->back;
}

/* A leaf's run comes when it is left. */
void lim_route_go_through_leaf(struct lim_route *route, uint16_t list)
{
    route->stack[route->depth++] = (struct lim_route_pending){route->next, list, 1};
    route->next = LIM_NO_INDEX;
}

/* Where nothing moves. */
void lim_route_enter_alone(struct lim_route *route)
{
    const LIM_FLASH struct lim_node *node = lim_route_node_to_enter(route);

    if (!node) return;
    if (lim_route_is_leaf(node))
        lim_route_go_through_leaf(route, LIM_NONE);
    else
        lim_route_go_near(route, node, lim_eye_side(route->eye, &node->split), LIM_NONE, LIM_NONE);
}

/* Takes up what waits on the stack. Returns the run that comes before it, or LIM_NO_INDEX. */
lim_index lim_route_leave(struct lim_route *route)
{
    const struct lim_route_pending *top = &route->stack[--route->depth];
    const LIM_FLASH struct lim_node *node = &route->scene->nodes[top->node];
    const bool front_first = (top->side > 0) != route->back_to_front;

    route->node = top->node;
    route->side = top->side;
    route->list = top->list;
    route->next = front_first ? node->back : node->front;
    return top->side > 0 ? node->front_run : top->side < 0 ? node->back_run : (lim_index)LIM_NO_INDEX;
}

bool lim_route_next_alone(struct lim_route *route, lim_index *run)
{
    for (;;) {
        while (route->next != LIM_NO_INDEX)
            lim_route_enter_alone(route);
        if (!route->depth) return false;
        *run = lim_route_leave(route);
        if (*run != LIM_NO_INDEX) return true;
    }
}

struct lim_route lim_route_object(struct lim_sorter *sorter, uint16_t mover, const struct lim_rect *open,
                                  bool back_to_front)
{
    struct lim_movers *movers = sorter->movers;
    const struct lim_mover *self = &movers->movers[mover];
    struct lim_route route = {.sorter = sorter,
                              .scene = movers->instances[mover].object,
                              .eye = &self->eye,
                              .cull = movers->cull,
                              .stack = movers->object_stack,
                              .back_to_front = back_to_front};

    if (LIM_HAS_CULL) lim_cull_set(movers->cull, &self->view, self->eye.at_q8, open);
    lim_route_begin(&route, LIM_NONE);
    return route;
}

#endif
