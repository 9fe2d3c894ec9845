/* SPDX-License-Identifier: MIT
 *
 * Whether a model is inside out. */
#ifndef SIM_WINDING_H
#define SIM_WINDING_H

#include "model/model.h"

/* Whether the model's one-sided faces enclose something, with each edge between two of them that run along it in
 * opposite directions, and the volume that they enclose is negative: seen from outside their corners run clockwise.
 * Points at one place count as one. */
bool winding_is_clockwise(const struct model *model);

#endif
