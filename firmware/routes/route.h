/* SPDX-License-Identifier: MIT
 *
 * A way through a tree: of an object's own, alone, or of the static scene's with movers (mover_route.h). */
#ifndef LIM_ROUTE_H
#define LIM_ROUTE_H

#include "orders.h"

/* The route through an object in the view of `open`; it is begun. */
void lim_route_object(struct lim_route *route, struct lim_sorter *sorter, uint16_t mover, const struct lim_rect *open,
                      bool back_to_front);

/* Begins at the root with a list. */
void lim_route_begin(struct lim_route *route, uint16_t list);

/* The next run, as far as nothing moves: LIM_NO_INDEX where there is none, or a list comes first. What moves in what
 * comes next is in route->list. */
lim_index lim_route_next_alone(struct lim_route *route);

/* Steps. The node to enter, or NULL: nothing of it can be seen. */
const LIM_FLASH struct lim_node *lim_route_node_to_enter(struct lim_route *route);

/* Where the eye is: as lim_eye_side(), which is long, where it is asked seldom. */
int32_t lim_route_side(const struct lim_route *route, const LIM_FLASH struct lim_node *node);

/* The near subtree is next, with what moves in it; the rest waits. */
void lim_route_go_near(struct lim_route *route, const LIM_FLASH struct lim_node *node, int32_t side, uint16_t front,
                       uint16_t back);

/* A leaf's run comes when it is left. */
void lim_route_go_through_leaf(struct lim_route *route, uint16_t list);

#endif
