/* SPDX-License-Identifier: MIT
 *
 * A line of a mesh: the triangles that cross it over one another. */
#ifndef LIM_MESH_LINE_H
#define LIM_MESH_LINE_H

#include "meshes.h"

/* Paints the triangles of both lists in their order, and puts those that cross the next line, stepped to it, into the
 * first. */
void lim_mesh_paint(struct lim_mesh *mesh, const struct lim_mesh_line *line);

#endif
