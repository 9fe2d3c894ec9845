/* SPDX-License-Identifier: MIT
 *
 * From a mesh to its tree. */
#ifndef SIM_BSP_BUILD_H
#define SIM_BSP_BUILD_H

#include "trees/tree.h"

/* Builds the tree. `points` holds exactly the mesh's points and receives those of the splits.
 * False if the pieces become too many. bsp_free() it either way. */
bool bsp_build(struct bsp *bsp, const struct mesh *mesh, const struct coplanar *coplanar, const struct tree_plan *plan,
               struct exact_points *points);

#endif
