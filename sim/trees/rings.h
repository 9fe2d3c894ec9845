/* SPDX-License-Identifier: MIT
 *
 * Polygons that hide one another in rings: no cluster can hold them (cluster.h). */
#ifndef SIM_RINGS_H
#define SIM_RINGS_H

#include "trees/hiding.h"

/* Who hides whom, and what finding rings takes. */
struct rings {
    struct hiding hiding; /* `count` is 0: nothing is known */
    struct rings_side {
        uint32_t *near;                      /* the witness to ask first, or HIDING_NONE */
        uint32_t *witness_at, *first, *next; /* of a set under way */
    } sides[2];
    uint32_t *used, *gone;
};

/* Among the polygons of the pieces list[0 .. count). */
void rings_find(struct rings *rings, const struct bsp *bsp, const uint32_t *list, size_t count);

/* How many polygons of a set are in a ring or between two: these it leaves in the set, which is a row. Pieces count as
 * their polygons. Takes time in proportion to the set times a row's words, at most. */
size_t rings_left(struct rings *rings, uint64_t *set);

/* The same, for a set of which many parts will be asked for: finds for each polygon left witnesses near to it. */
size_t rings_prepare(struct rings *rings, uint64_t *set);

/* Whether there is a ring among those pieces of a list that are whole polygons: then the list has no order. */
bool rings_hold(struct rings *rings, const struct bsp *bsp, const uint32_t *list, size_t count);

void rings_free(struct rings *rings);

#endif
