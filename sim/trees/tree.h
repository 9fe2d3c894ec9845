/* SPDX-License-Identifier: MIT
 *
 * What makes a tree be of a kind: where it ends in a leaf, and which plane divides what does not. */
#ifndef SIM_TREE_H
#define SIM_TREE_H

#include "scene/tree_kind.h"
#include "trees/bsp.h"
#include "trees/rings.h"
#include "trees/splitter.h"

/* How a tree is to be built. */
struct tree_plan {
    enum tree_kind kind;
    const struct splitter *splitter; /* chooses among the planes of the polygons */
    double tolerance_units;
    const struct parts *parts; /* dense ones, that shall become mesh leaves; NULL: none */
};

/* Whether the pieces list[0 .. count) make a leaf; their order, nearest first, goes to `order`. `rings` spares time; it
 * may be empty. */
bool tree_ends(const struct bsp *bsp, enum tree_kind kind, struct rings *rings, const uint32_t *list, size_t count,
               uint32_t *order);

/* Whether they are all of dense parts, and make a mesh leaf. */
bool tree_ends_dense(struct bsp *bsp, const struct tree_plan *plan, const uint32_t *list, size_t count);

/* Whether both take rings for a list so long. */
bool tree_wants_rings(const struct tree_plan *plan, size_t pieces);

/* The group, or cut, whose plane divides the list; `rings` is empty if it does not take them. */
uint32_t tree_divider(struct bsp *bsp, const struct tree_plan *plan, struct rings *rings, struct bsp_place place,
                      const uint32_t *list, size_t count);

#endif
