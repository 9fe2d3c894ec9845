/* SPDX-License-Identifier: MIT
 *
 * The plane that leaves the fewest polygons in rings, which no cluster can hold. */
#ifndef SIM_CLUSTER_CUT_H
#define SIM_CLUSTER_CUT_H

#include "trees/bsp.h"
#include "trees/rings.h"
#include "trees/splitter.h"

/* Among axis planes and the planes of polygons in the list: the cheapest by the splitter's weights and by what is left
 * in rings. */
uint32_t cluster_cut_best(struct bsp *bsp, const struct splitter *splitter, struct rings *rings, const uint32_t *list,
                          size_t count);

#endif
