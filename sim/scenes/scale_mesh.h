/* SPDX-License-Identifier: MIT
 *
 * A dense closed mesh: the tube round a torus knot, ribbed, in triangles of about equal length and breadth. */
#ifndef SCALE_MESH_H
#define SCALE_MESH_H

#include <stdbool.h>
#include <stdio.h>

enum { SCALE_TRIANGLES_MIN = 500, SCALE_TRIANGLES_MAX = 1000000 };

/* As near to `triangles` as whole rings come. The material of a face is one of scale_mesh_materials(). */
bool scale_mesh_write(FILE *obj, long triangles, const char *materials_name);
bool scale_mesh_materials(FILE *mtl);

/* Once round it, and nearer and farther, as a camera file. */
bool scale_mesh_flight(FILE *cam, int frames);

#endif
