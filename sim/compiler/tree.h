/* SPDX-License-Identifier: MIT
 *
 * What makes a tree be of a kind: where it ends in a leaf, and which plane divides what does not. */
#ifndef SIM_TREE_H
#define SIM_TREE_H

#include "compiler/bsp.h"

/* Whether the pieces list[0 .. count) make a leaf; their order, nearest first, goes to `order`. */
bool tree_ends(const struct bsp *bsp, enum tree_kind kind, const uint32_t *list, size_t count, uint32_t *order);

/* Whether the dividers look at bsp->rings. */
bool tree_wants_rings(const struct bsp_plan *plan, size_t polygons);

/* Where a list stands: to become the front or the back child of a node, or the root (BSP_NONE). */
struct tree_place {
    uint32_t parent;
    bool in_front;
};

/* The group, or cut, whose plane divides the list. */
uint32_t tree_divider(struct bsp *bsp, const struct bsp_plan *plan, struct tree_place place, const uint32_t *list,
                      size_t count);

#endif
