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

/* A grid of many scales, for a long scene: units are a small part of what the smallest face takes, and as large as they
 * have to be for the whole scene to span 2^30 of them, and for a near plane at near_m, or 0, if it is not known. */
bool grid_choose_long(const struct model *model, double near_m, struct grid *grid, struct error *err);

/* Points nearer than this are one: 1/16 unit, 2^-20 of the scene's longest side. A float32 importer
 * is 16 times finer. */
double grid_weld_m(const struct grid *grid);

/* A point nearer than this to an edge lies on it: half of grid_weld_m(), so that dividing an edge
 * at the points on it always comes to an end. */
double grid_near_m(const struct grid *grid);

/* A polygon is flat while its corners stay this near to its plane: half a unit. */
double grid_flat_m(const struct grid *grid);

#endif
