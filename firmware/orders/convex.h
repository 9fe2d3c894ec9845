/* SPDX-License-Identifier: MIT
 *
 * One convex solid, line by line. In: a scene whose tree is a chain: each node's polygons face away
 * from all that comes after it, so the order of the nodes is right from everywhere. Out: every line
 * painted once, from top to bottom. Memory, lent: a head a line, three numbers a polygon that faces the eye, and the
 * faces that cross one line. */
#ifndef LIM_CONVEX_H
#define LIM_CONVEX_H

#include "orders.h"

/* `active`: for how many faces on a line; 0 is the least. */
size_t lim_convex_mem_b(const struct lim_scene *scene, const struct lim_target *target, uint16_t active);
void lim_convex_init(struct lim_convex *convex, void *mem, size_t mem_b);

/* A frame, of a camera that is taken in. 0, an enum lim_error, or the target's error. */
LIM_MUST_CHECK int lim_convex_frame(struct lim_convex *convex);

#endif
