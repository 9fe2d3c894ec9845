/* SPDX-License-Identifier: MIT
 *
 * Whether a model is inside out. */
#ifndef SIM_WINDING_H
#define SIM_WINDING_H

#include "model/model.h"

/* Whether the model's faces, all of one side or all of two, enclose something, with each edge between two of them that
 * run along it in opposite directions, and the volume that they enclose is negative: seen from outside their corners
 * run clockwise. Of faces of two sides, of which light asks for the right one, a tenth of the edges may be open. Points
 * at one place count as one. */
bool winding_is_clockwise(const struct model *model);

#endif
