/* SPDX-License-Identifier: MIT
 *
 * What hides what as seen from sampled eyes: an approximation of the relation that cluster.h proves, with less in it.
 * Orders that follow it may be wrong from other eyes. */
#ifndef SIM_SAMPLED_ORDER_H
#define SIM_SAMPLED_ORDER_H

#include "compiler/rings.h"
#include "scene/compiled.h"

enum { SAMPLED_VIEWS = 64, SAMPLED_SIDE = 32 };

/* `scene` is the mesh compiled with any exact tree: its free space is where the eyes are. SAMPLED_VIEWS cameras with
 * SAMPLED_SIDE * SAMPLED_SIDE rays each. */
void sampled_order_find(struct rings *rings, const struct mesh *mesh, const struct compiled *scene);

/* Puts pieces of a tree in an order that follows bsp->rings, nearest first. False: there is none. */
bool sampled_order_sort(const struct bsp *bsp, const uint32_t *list, size_t count, uint32_t *order);

#endif
