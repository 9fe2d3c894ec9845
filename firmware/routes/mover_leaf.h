/* SPDX-License-Identifier: MIT
 *
 * Movers that come to a leaf of the static tree. */
#ifndef LIM_MOVER_LEAF_H
#define LIM_MOVER_LEAF_H

#include "orders.h"

/* The list route->list has come to the leaf that the route is to enter: sets what comes next. */
void lim_movers_enter_leaf(struct lim_route *route, lim_index run);

#endif
