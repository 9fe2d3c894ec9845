/* SPDX-License-Identifier: MIT
 *
 * The reference of a model with moving objects. */
#ifndef SIM_MOVING_REFERENCE_H
#define SIM_MOVING_REFERENCE_H

#include "accuracy/reference.h"
#include "scene/moving.h"

/* Which faces of the model count as one once coplanar neighbours are merged, as mesh.merged_into; the caller's. */
bool moving_groups(const struct moving *moving, uint32_t **groups, struct error *err);

/* The reference; and where everything is at a time, in double precision. */
bool moving_reference(const struct moving *moving, struct reference *reference, unsigned w_px, unsigned h_px,
                      struct error *err);
void moving_pose_reference(const struct moving *moving, struct reference *reference, double time_s);

#endif
