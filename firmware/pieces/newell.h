/* SPDX-License-Identifier: MIT
 *
 * The depth sort of Newell, Newell and Sancha: from farthest to nearest, each polygon P is compared with every Q
 * that its extent in z overlaps, until it is certain that P may be painted before all of them; else Q goes
 * first, and where that goes round in a circle, or the two pass through each other, they are split.
 *
 * "Behind a plane" is the side on which the eye is not. A vertex within |n0| + |n1| + |n2| of a plane n . p = d
 * is on it, and counts for either side: rounding to units moves it by half of that, and the compiler's tolerance by
 * as much. A polygon is never split twice by one plane: its pieces remember. */
#ifndef LIM_NEWELL_H
#define LIM_NEWELL_H

#include "orders.h"

/* What LIM_NEWELL knows of a polygon of the scene, which is an entry of the list already: its nearest point, where its
 * plane is, and which pixels it may have. false: nothing of it can be seen. */
bool lim_newell_add(struct lim_sorter *sorter, uint16_t entry, int32_t near_qv, lim_index node, bool eye_in_front);

/* From a list sorted by farthest points, farthest first, to the right order, nearest first. */
void lim_newell_order(struct lim_sorter *sorter);

#endif
