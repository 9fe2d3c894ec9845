/* SPDX-License-Identifier: MIT
 *
 * Is a scene one convex solid, so that LIM_CONVEX can draw it? */
#ifndef SIM_CONVEXITY_H
#define SIM_CONVEXITY_H

#include "scene.h"

/* Every vertex lies on or behind the plane of every polygon, as far as rounding it to the grid and the
 * half unit that the compiler tolerates allow; and the tree is a chain, all else behind each node's polygons.
 * So the order of the nodes is the right one from every eye, and no face hides another. */
bool scene_is_convex(const struct lim_scene *scene);

#endif
