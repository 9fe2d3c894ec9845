/* SPDX-License-Identifier: MIT
 *
 * Meshes for the compiler's tests: polygon by polygon, walls of plan views, closed solids. */
#ifndef TESTS_MESH_RIG_H
#define TESTS_MESH_RIG_H

#include "random.h"
#include "scene/compiled.h"

enum { RIG_COLOUR = 0x808080 };

/* An empty mesh whose grid has its origin at 0. mesh_rig_free() it. */
struct mesh mesh_rig(double units_per_m);
void mesh_rig_free(struct mesh *mesh);

/* Adds a polygon; equal corners of polygons become one point, faces are numbered from 1. */
struct mesh_polygon *mesh_rig_add(struct mesh *mesh, const double (*corners_m)[3], size_t count);

/* The triangle of the first corner and of two others. */
void mesh_rig_triangle(struct mesh *mesh, const double (*corners_m)[3], int second, int third);

/* A wall of a plan view, 2 m high, from (x0, y0) to (x1, y1) with its front on the left. Plan x is
 * the scene's z and plan y its x, so that the planes of walls along the axes face up or right in plan. */
void mesh_rig_wall(struct mesh *mesh, uint32_t face, double x0, double y0, double x1, double y1);

/* A closed box of quads, turned about two axes. */
void mesh_rig_box(struct mesh *mesh, const double centre_m[3], const double half_m[3], double yaw, double pitch);

/* A closed ball of quads and triangles, rings * 2 faces around. */
void mesh_rig_ball(struct mesh *mesh, const double centre_m[3], double radius_m, unsigned rings);

/* Boxes, needles and balls through one another: closed solids only, within 10 m of the origin. */
void mesh_rig_solids(struct mesh *mesh, struct random *random, unsigned count);

/* Compiles with the splitter and tolerance given; a failure ends the test. compiled_free() it. */
struct compiled mesh_rig_compile(const struct mesh *mesh, const char *splitter, double tolerance_units);

#endif
