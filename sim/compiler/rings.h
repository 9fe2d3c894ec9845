/* SPDX-License-Identifier: MIT
 *
 * Which polygons of a mesh can hide which, found once for a tree: so candidates for dividing a list are judged by
 * what they leave in rings (cluster.h), without looking at a plane again. */
#ifndef SIM_RINGS_H
#define SIM_RINGS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct bsp;

/* A bit matrix: row p has the polygons that p can hide, as far as they are whole. */
struct rings {
    uint64_t *hides, *hidden_by;
    size_t words, count; /* of a row; of polygons, which are the tree's first pieces */
};

/* All pieces of the tree are whole polygons, in the mesh's order, as when it is begun. */
void rings_find(struct rings *rings, const struct bsp *bsp);

/* How many polygons of a set are in a ring or between two. Pieces count as their polygons. The set is a row: bit p for
 * polygon p. It is changed. */
size_t rings_left(const struct rings *rings, uint64_t *set);

/* Whether there is a ring among those pieces of a list that are whole polygons: then the list has no order. */
bool rings_hold(const struct rings *rings, const uint32_t *list, size_t count);

void rings_free(struct rings *rings);

#endif
