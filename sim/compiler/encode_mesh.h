/* SPDX-License-Identifier: MIT
 *
 * From a mesh to the arrays of a scene without a tree: scene.h, LIM_TRIANGLE_WORDS. */
#ifndef SIM_ENCODE_MESH_H
#define SIM_ENCODE_MESH_H

#include "scene/encoding.h"
#include "trees/exact.h"

/* Encodes all polygons as triangles, two-sided ones twice; `points` are the mesh's. Refuses what such a scene does not
 * draw, and a mesh of which rounding leaves nothing. The caller frees *out either way. */
bool encode_mesh(const struct mesh *mesh, const struct exact_points *points, bool with_fractions, struct encoding *out,
                 struct error *err);

#endif
