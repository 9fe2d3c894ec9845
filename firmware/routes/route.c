/* SPDX-License-Identifier: MIT
 *
 * ROUTE is WALK with movers: a list of movers goes with each subtree. At a node the list is divided by the node's
 * plane, so a mover is never cut by a plane that does not divide the space around it, and subtrees without movers cost
 * what they cost WALK. A subtree without a node is empty space: what has come there is handed out at once. So is
 * what has come to a subtree whose polygons are out of view: there is nothing in it to be sorted with. */
#include "routes/route.h"

#include "routes/mover_split.h"

#if LIM_HAS_MOVERS

void lim_route_begin(struct lim_route *route, uint16_t list)
{
    route->depth = 0;
    route->next = route->scene->node_count ? 0 : LIM_NO_INDEX;
    route->list = list;
}

/* The node to enter, or NULL: nothing of it can be seen. */
static const LIM_FLASH struct lim_node *node_to_enter(struct lim_route *route)
{
    const LIM_FLASH struct lim_node *node = &route->scene->nodes[route->next];

    if (lim_node_is_skipped(route->scene, node, route->shown, route->cull, route->depth,
                            lim_stats_of(route->sorter->pass))) {
        route->next = LIM_NO_INDEX;
        return NULL;
    }
    if (LIM_HAS_STATS) lim_stats_of(route->sorter->pass)->nodes++;
    LIM_ASSERT(route->depth < route->scene->limits.depth);
    return node;
}

static bool is_leaf(const LIM_FLASH struct lim_node *node)
{
    return LIM_HAS_LEAVES && node->split.plane == LIM_NO_INDEX;
}

/* The near subtree is next, with what moves in it; the rest waits. */
static void go_near(struct lim_route *route, const LIM_FLASH struct lim_node *node, int32_t side, uint16_t front,
                    uint16_t back)
{
    const bool front_first = (side > 0) != route->back_to_front;

    route->stack[route->depth++] =
        (struct lim_route_pending){route->next, front_first ? back : front, (int8_t)((side > 0) - (side < 0))};
    route->list = front_first ? front : back;
    route->next = front_first ? node->front : node->back;
}

/* A leaf's run comes when it is left. */
static void go_through_leaf(struct lim_route *route, uint16_t list)
{
    route->stack[route->depth++] = (struct lim_route_pending){route->next, list, 1};
    route->next = LIM_NO_INDEX;
}

/* Where nothing moves. */
static void enter_alone(struct lim_route *route)
{
    const LIM_FLASH struct lim_node *node = node_to_enter(route);

    if (!node) return;
    if (is_leaf(node))
        go_through_leaf(route, LIM_NONE);
    else
        go_near(route, node, lim_eye_side(route->eye, &node->split), LIM_NONE, LIM_NONE);
}

/* The order of its run knows nothing of movers: both are sorted together, or else movers are taken for nearer. */
static void enter_leaf(struct lim_route *route, lim_index run)
{
    const uint16_t list = route->list;

    if (lim_movers_join(route->sorter, run, list)) {
        route->next = LIM_NO_INDEX;
        return;
    }
    if (LIM_HAS_STATS) lim_stats_of(route->sorter->pass)->movers.unsorted++;
    if (route->back_to_front) route->list = LIM_NONE;
    go_through_leaf(route, route->back_to_front ? list : (uint16_t)LIM_NONE);
}

static void route_enter(struct lim_route *route)
{
    const LIM_FLASH struct lim_node *node = node_to_enter(route);
    uint16_t front, back;

    if (!node) return;
    if (is_leaf(node)) {
        enter_leaf(route, node->front_run);
        return;
    }
    const int32_t side = lim_eye_side(route->eye, &node->split);
    lim_movers_divide(route->sorter, route->next, side, route->list, &front, &back);
    go_near(route, node, side, front, back);
}

/* Takes up what waits on the stack. Returns the run that comes before it, or LIM_NO_INDEX. */
static lim_index leave(struct lim_route *route)
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

enum lim_route_event lim_route_next(struct lim_route *route, lim_index *what)
{
    for (;;) {
        while (route->next != LIM_NO_INDEX) {
            if (route->list == LIM_NONE)
                enter_alone(route);
            else
                route_enter(route);
        }
        if (route->list != LIM_NONE) {
            *what = route->list;
            route->list = LIM_NONE;
            return LIM_ROUTE_LIST;
        }
        if (!route->depth) return LIM_ROUTE_END;
        *what = leave(route);
        if (*what != LIM_NO_INDEX) return LIM_ROUTE_RUN;
    }
}

bool lim_route_next_alone(struct lim_route *route, lim_index *run)
{
    for (;;) {
        while (route->next != LIM_NO_INDEX)
            enter_alone(route);
        if (!route->depth) return false;
        *run = leave(route);
        if (*run != LIM_NO_INDEX) return true;
    }
}

struct lim_route lim_route_static(struct lim_sorter *sorter, bool back_to_front)
{
    struct lim_pass *pass = sorter->pass;

    return (struct lim_route){.sorter = sorter,
                              .scene = pass->scene,
                              .eye = lim_eye_of(pass),
                              .cull = lim_cull_of(pass),
                              .shown = pass->walk->shown,
                              .stack = sorter->movers->stack,
                              .back_to_front = back_to_front};
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
