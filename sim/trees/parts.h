/* SPDX-License-Identifier: MIT
 *
 * The parts of a mesh that hang together, and which of them are dense: what a tree may take whole, as a leaf that the
 * renderer orders by distance (firmware/SCENE.md, Mesh leaves). */
#ifndef SIM_PARTS_H
#define SIM_PARTS_H

#include "trees/parts_survey.h"

struct parts {
    uint32_t *of; /* of each polygon of the mesh, its part, counted from 1; 0: of none that is dense */
    struct part *items;
    size_t count;
};

/* `points` are the mesh's, in units. Parts are in the order of their first polygons. */
void parts_find(const struct mesh *mesh, double (*points)[3], struct parts *out);

/* Takes out part i, from 0; the others keep their numbers. */
void parts_leave_out(struct parts *parts, const struct mesh *mesh, size_t i);

/* Makes one part of all, if all of the mesh's polygons are in them, and one leaf has room for it; else there is none.
 */
void parts_unite(struct parts *parts, const struct mesh *mesh);

/* How many there are, without those left out. */
size_t parts_taken(const struct parts *parts);

void parts_free(struct parts *parts);

#endif
