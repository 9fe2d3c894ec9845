/* SPDX-License-Identifier: MIT
 *
 * SORT takes WALK's place where there is no tree, or none is wanted: every polygon that faces the eye, listed
 * by its farthest point. In: the scene, the eye, the view. Out: polygons, nearest first, for the same SPAN and
 * PAINT. Memory: an entry a polygon, lent by the caller; for LIM_NEWELL more, and room for pieces. Once a frame,
 * however many bands it takes. */
#ifndef LIM_SORTED_H
#define LIM_SORTED_H

#include "orders.h"

/* Lists and orders. The camera is taken in. */
void lim_sorted_order(struct lim_sorter *sorter);

#endif
