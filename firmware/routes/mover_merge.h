/* SPDX-License-Identifier: MIT
 *
 * Movers that pass through each other: one of them takes the static scene's place, and its tree divides the others. */
#ifndef LIM_MOVER_MERGE_H
#define LIM_MOVER_MERGE_H

#include "orders.h"

/* Puts a list of instances, or parts of such, in the order of one's tree, nearest first: polygons of that one, and
 * between them the others' parts. Several of these that have come to one place follow each other in no order; the last
 * one is marked as `last`. false: no tree is small enough, or there is no room; nothing has changed. */
bool lim_movers_merge(struct lim_sorter *sorter, uint16_t *list);

#endif
