/* SPDX-License-Identifier: MIT
 *
 * The kinds of trees that the scene compiler builds. All of them are walked by the same firmware. */
#ifndef SIM_TREE_KIND_H
#define SIM_TREE_KIND_H

#include "base/error.h"

enum tree_kind {
    TREE_AUTO,     /* the BSP tree, or whichever draws cheapest (tree_choice.h) */
    TREE_BSP,      /* planes of polygons, down to the last polygon */
    TREE_CLUSTERS, /* planes of polygons, until an order is right from everywhere (Schumacker) */
    TREE_AXIS,     /* axis planes at coordinates of vertices, down to small clusters */
    TREE_OCTREE,   /* axis planes that halve cubes, down to small clusters */
    TREE_NONE,     /* a set: one leaf, in no order. For methods that sort */
    TREE_MESH,     /* no nodes at all: triangles, for the methods of meshes */
    TREE_KINDS
};

extern const char *const tree_names[TREE_KINDS + 1]; /* and NULL */

/* By its name; an unknown one is refused with the list of those there are. */
bool tree_kind_parse(const char *text, enum tree_kind *out, struct error *err);

#endif
