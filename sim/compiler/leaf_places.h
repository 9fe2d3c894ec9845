/* SPDX-License-Identifier: MIT
 *
 * What a mesh leaf costs where the eye is near it. The cameras that a scene is measured by stand all over it, and of a
 * large one few of them stand near a given part: walls that enclose many rooms would be cheap in their mean, and dear
 * in each of these rooms. */
#ifndef SIM_LEAF_PLACES_H
#define SIM_LEAF_PLACES_H

#include "core/core.h"
#include "scene/compiled.h"
#include "trees/parts.h"

/* Leaves out the parts near which frames are predicted to take a tenth more instructions `with` leaves than `without`,
 * on a few cameras each, and returns how many. Out of time, what has not been looked at stays. */
size_t leaf_places_leave_out(const struct compiled *without, const struct compiled *with, const struct core *core,
                             const struct mesh *mesh, struct parts *parts);

#endif
