/* SPDX-License-Identifier: MIT
 *
 * Which edges of a mesh are no edges of the model: diagonals of faces that were triangulated. They lie between
 * triangles of one face, and wireframe does not draw them. */
#ifndef SIM_INNER_H
#define SIM_INNER_H

#include "model/mesh.h"

/* The edge between points a and b divides a face. */
void inner_add(struct mesh *mesh, uint32_t a, uint32_t b);

/* It is a face's own edge as well, and stays drawn. */
void inner_remove(struct mesh *mesh, uint32_t a, uint32_t b);

bool inner_has(const struct mesh *mesh, uint32_t a, uint32_t b);

/* The edge from a to b is now one from a to `middle` and one from there to b. */
void inner_divide(struct mesh *mesh, uint32_t a, uint32_t middle, uint32_t b);

#endif
