/* SPDX-License-Identifier: MIT
 *
 * The scene's integer grid, chosen from the corners of a model's faces, and what is near or flat on it. */
#ifndef SIM_GRID_H
#define SIM_GRID_H

#include "model/mesh.h"

/* The largest scale at which every corner of a face fits -32767..32767, the origin in the middle of
 * the bounds; or one up to a third smaller at which most corners round without error, because they
 * lie on multiples of a millimetre, say. Refuses a model whose corners are all at one place, and one whose farthest
 * corners squeeze the rest: without them, 1 in 100, it would be 1000 times smaller. */
bool grid_choose(const struct model *model, struct grid *grid, struct error *err);

/* From where a scene is seen. 0: it is not known. */
struct grid_views {
    double near_m; /* the near plane's distance */
    double far_m;  /* how far the farthest eye is from the middle of the scene, along an axis */
};

/* A grid of many scales, for a long scene: units are a small part of what the smallest face takes, and of the near
 * plane's distance; and as large as they have to be for the whole scene to span 2^30 of them, for that near plane, and
 * for that eye. */
bool grid_choose_long(const struct model *model, const struct grid_views *views, struct grid *grid, struct error *err);

/* The scale of such a grid, and whether it needs fractions, for a scene that is longest_m long. */
void grid_scale_long(double longest_m, double least_face_m, const struct grid_views *views, struct grid *grid);

/* Points nearer than this are one: 1/16 unit, 2^-20 of the scene's longest side. A float32 importer
 * is 16 times finer. */
double grid_weld_m(const struct grid *grid);

/* A point nearer than this to an edge lies on it: half of grid_weld_m(), so that dividing an edge
 * at the points on it always comes to an end. */
double grid_near_m(const struct grid *grid);

/* A polygon is flat while its corners stay this near to its plane: half a unit. */
double grid_flat_m(const struct grid *grid);

#endif
