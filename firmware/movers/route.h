/* SPDX-License-Identifier: MIT
 *
 * ROUTE is WALK with a place for what is told of a node: which one a run is of, and on which side of it the eye is. It
 * goes through an object's own tree, or, step by step, through the static scene's among movers (meet.h). */
#ifndef LIM_ROUTE_H
#define LIM_ROUTE_H

#include "orders.h"

/* The route through an object in the view of `open`; it is begun. */
void lim_route_object(struct lim_route *route, struct lim_pass *pass, struct lim_movers *movers, uint16_t mover,
                      const struct lim_rect *open);

/* The next run, nearest first: LIM_NO_INDEX where there is none. */
lim_index lim_route_next(struct lim_route *route);

/* Steps. The node to enter, or NULL: nothing of it can be seen. */
const LIM_FLASH struct lim_node *lim_route_node_to_enter(struct lim_route *route);

/* Where the eye is: as lim_eye_side(), which is long, where it is asked seldom. */
int32_t lim_route_side(const struct lim_route *route, const LIM_FLASH struct lim_node *node);

#endif
