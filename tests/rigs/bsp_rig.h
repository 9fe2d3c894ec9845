/* SPDX-License-Identifier: MIT
 *
 * A mesh with everything that a tree of it needs, for tests that look into trees. */
#ifndef TESTS_BSP_RIG_H
#define TESTS_BSP_RIG_H

#include "trees/bsp_build.h"

struct bsp_rig {
    struct exact_points points;
    struct coplanar coplanar;
    struct bsp bsp;
    uint32_t *all; /* the pieces placed, node by node: of a set, all of them in the mesh's order */
};

/* Builds the tree; the mesh must outlive it. bsp_rig_free() it. */
void bsp_rig_make(struct bsp_rig *rig, const struct mesh *mesh, enum tree_kind kind);
void bsp_rig_free(struct bsp_rig *rig);

#endif
