/* SPDX-License-Identifier: MIT
 *
 * Which plane divides a list of polygons: the heuristics of the tree builder. */
#ifndef SIM_SPLITTER_H
#define SIM_SPLITTER_H

#include "base/error.h"
#include "scene/plane.h"

struct bsp;

/* A plane costs, for each polygon of the list: split_cost if it splits it, gain if it lies on it;
 * imbalance_cost for each polygon that one side has more than the other. */
struct splitter {
    const char *name;
    double split_cost, imbalance_cost, coplanar_gain;
    double lopsided_cost; /* for each polygon of a list of which one side gets less than a tenth */
    bool for_many;        /* "auto" tries it on more than SPLITTER_MANY polygons, too */
    bool for_dense;       /* and on more than SPLITTER_SEVERAL where the first tree splits much */
    size_t samples;       /* candidates, drawn at random from the list; 0: as many as time allows, evenly chosen */
};

enum { SPLITTER_SEVERAL = 2000, SPLITTER_MANY = 20000 };

/* All heuristics. The first takes the list's first polygon whatever it costs. */
extern const struct splitter splitters[];
extern const size_t splitter_count;

/* Which is tried first, if it is wanted: never far from the best. */
extern const struct splitter *const splitter_scout;

/* Their names for people; "weighted" is all of those weights, "auto" all of them and "fewest". */
extern const char *const splitter_names[];
extern const size_t splitter_name_count;

/* Whether one of those names, or a heuristic's own, means this heuristic. */
bool splitter_answers(const struct splitter *splitter, const char *name);

/* Refuses a name that means none, with the list of those there are. */
bool splitter_check(const char *name, struct error *err);

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
