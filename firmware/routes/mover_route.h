/* SPDX-License-Identifier: MIT
 *
 * ROUTE carries movers down the static tree: a list of whole instances and of pieces goes with each subtree, and is
 * divided by its planes. Where the list comes to empty space it is put in order (mover_order.h). */
#ifndef LIM_MOVER_ROUTE_H
#define LIM_MOVER_ROUTE_H

#include "orders.h"

enum lim_route_event { LIM_ROUTE_END, LIM_ROUTE_RUN, LIM_ROUTE_LIST };

/* The route through the static scene. */
struct lim_route lim_route_static(struct lim_sorter *sorter, bool back_to_front);

/* What comes next: a run (its offset in *what), or a list. */
enum lim_route_event lim_route_next(struct lim_route *route, lim_index *what);

#endif
