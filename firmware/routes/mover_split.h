/* SPDX-License-Identifier: MIT
 *
 * Lists of movers on their way down a tree (mover_list.h): planes of the static scene divide them, into pieces where it
 * must be. Memory: the sorter's entries. */
#ifndef LIM_MOVER_SPLIT_H
#define LIM_MOVER_SPLIT_H

#include "orders.h"

/* Divides a list by the plane of the node that the route is to enter. What lies in it goes to the eye's side; so does
 * what reaches through it, if nothing beyond can stand before it. */
void lim_movers_divide(const struct lim_route *route, int32_t eye_side, uint16_t list, uint16_t *front, uint16_t *back);

#endif
