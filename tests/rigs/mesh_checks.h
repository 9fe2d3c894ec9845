/* SPDX-License-Identifier: MIT
 *
 * What must hold of any mesh, checked by brute force. */
#ifndef TESTS_MESH_CHECKS_H
#define TESTS_MESH_CHECKS_H

#include "model/mesh.h"

/* Cleans a model that must be fit for it, and frees it. */
struct mesh cleaned(struct model *model);

/* The same from a file. */
struct mesh cleaned_file(const char *path);

/* The area of all polygons, each by Newell's formula, in square metres. */
double mesh_area_m2(const struct mesh *mesh);

/* Edges a -> b without exactly one edge b -> a. */
size_t mesh_open_edges(const struct mesh *mesh);

/* Corners of polygons strictly inside an edge of a polygon, each counted for each edge. */
size_t mesh_t_vertices_left(const struct mesh *mesh);

/* Corners off the plane by more than `units`, or where the polygon turns right by more than the
 * mesh takes for straight. */
size_t mesh_bad_corners(const struct mesh *mesh, double units);

#endif
