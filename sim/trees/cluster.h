/* SPDX-License-Identifier: MIT
 *
 * Clusters (Schumacker, 1969): sets of polygons that can be put into an order which is right from every
 * viewpoint, so that no plane has to divide them. */
#ifndef SIM_CLUSTER_H
#define SIM_CLUSTER_H

#include "trees/bsp.h"
#include "trees/hiding.h"

/* Which of two pieces hides a part of the other from some eyes, as far as their planes tell. */
struct cluster_pair {
    bool p_hides_q, q_hides_p;
};
struct cluster_pair cluster_pair(const struct bsp *bsp, uint32_t p, uint32_t q);

/* Puts the pieces list[0 .. count) in order, nearest first. Where nothing decides, they stay as they are in the
 * list. False: some hide one another in a ring, and there is no such order. `hiding` spares looking at planes; NULL:
 * nothing is known of these pieces' polygons. */
bool cluster_order(const struct bsp *bsp, const struct hiding *hiding, const uint32_t *list, size_t count,
                   uint32_t *order);

#endif
