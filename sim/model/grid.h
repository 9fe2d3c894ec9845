/* SPDX-License-Identifier: MIT
 *
 * The scene's integer grid, chosen from the corners of a model's faces. */
#ifndef SIM_GRID_H
#define SIM_GRID_H

#include "model/mesh.h"

/* The largest scale at which every corner of a face fits -32767..32767, the origin in the middle of
 * the bounds; or one up to a third smaller at which most corners round without error, because they
 * lie on multiples of a millimetre, say. Refuses a model whose corners are all at one place, and one whose farthest
 * corners squeeze the rest: without them, 1 in 100, it would be 1000 times smaller. */
bool grid_choose(const struct model *model, struct grid *grid, struct error *err);

#endif
