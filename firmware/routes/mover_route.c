/* SPDX-License-Identifier: MIT
 *
 * ROUTE is WALK with movers: a list of movers goes with each subtree. At a node the list is divided by the node's
 * plane, so a mover is never cut by a plane that does not divide the space around it, and subtrees without movers cost
 * what they cost WALK. A subtree without a node is empty space: what has come there is handed out at once. So is
 * what has come to a subtree whose polygons are out of view: there is nothing in it to be sorted with. */
#include "routes/mover_route.h"

#include "eye.h"
#include "routes/mover_leaf.h"
#include "routes/mover_split.h"
#include "routes/route.h"
#include "view/pass.h"

#if LIM_HAS_MOVERS

/* Whether a node's plane has something on both sides that may hide, or be hidden: what faces the eye lies in the plane,
 * between what moves before it and what does behind. Else all of a list goes where something is. */
static bool has_two_sides(const LIM_FLASH struct lim_node *node, int32_t side)
{
    if ((side > 0 ? node->front_run : side < 0 ? node->back_run : (lim_index)LIM_NO_INDEX) != LIM_NO_INDEX) return true;
    return node->front != LIM_NO_INDEX && node->back != LIM_NO_INDEX;
}

static void route_enter(struct lim_route *route)
{
    const LIM_FLASH struct lim_node *node = lim_route_node_to_enter(route);
    uint16_t front = LIM_NONE, back = LIM_NONE;

    if (!node) return;
    if (lim_node_is_leaf(node)) {
        lim_movers_enter_leaf(route, node->front_run);
        return;
    }
    const int32_t side = lim_route_side(route, node);
    if (has_two_sides(node, side))
        lim_movers_divide(route, side, route->list, &front, &back);
    else
        *(node->front != LIM_NO_INDEX ? &front : &back) = route->list;
    lim_route_go_near(route, node, side, front, back);
}

enum lim_route_event lim_route_next(struct lim_route *route, lim_index *what)
{
    for (;;) {
        while (route->next != LIM_NO_INDEX && route->list != LIM_NONE)
            route_enter(route);
        if (route->list != LIM_NONE) {
            *what = route->list;
            route->list = LIM_NONE;
            return LIM_ROUTE_LIST;
        }
        *what = lim_route_next_alone(route);
        if (*what != LIM_NO_INDEX) return LIM_ROUTE_RUN;
        if (route->list == LIM_NONE) return LIM_ROUTE_END;
    }
}

struct lim_route lim_route_static(struct lim_sorter *sorter, bool back_to_front)
{
    struct lim_pass *pass = sorter->pass;

    return (struct lim_route){.sorter = sorter,
                              .scene = pass->scene,
                              .mover = LIM_NONE,
                              .eye = lim_eye_of(pass),
                              .cull = lim_cull_of(pass),
                              .shown = pass->walk->shown,
                              .stack = sorter->movers->stack,
                              .back_to_front = back_to_front};
}

#endif
