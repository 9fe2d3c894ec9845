/* SPDX-License-Identifier: MIT
 *
 * Which plane divides a list of polygons: the heuristics of the tree builder. */
#ifndef SIM_SPLITTER_H
#define SIM_SPLITTER_H

#include "plane.h"

struct bsp;

/* A plane costs, for each polygon of the list: split_cost if it splits it, gain if it lies on it;
 * imbalance_cost for each polygon that one side has more than the other. */
struct splitter {
    const char *name;
    double split_cost, imbalance_cost, coplanar_gain;
    double lopsided_cost; /* for each polygon of a list of which one side gets less than a tenth */
};

/* All heuristics; the first takes the list's first polygon whatever it costs. */
extern const struct splitter splitters[];
extern const size_t splitter_count;

/* How a plane divides a list: pieces of its own group, in front, behind, and across. */
struct splitter_tally {
    size_t on, front, back, splits;
};

/* What dividing a list of `count` pieces costs by a plane of that kind. */
double splitter_cost(const struct splitter *splitter, enum plane_kind kind, const struct splitter_tally *tally,
                     size_t count);

/* The group whose plane divides the pieces list[0 .. count), count > 0; what that costs. */
uint32_t splitter_choose(const struct splitter *splitter, const struct bsp *bsp, const uint32_t *list, size_t count,
                         double *cost);

#endif
