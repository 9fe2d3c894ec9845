/* SPDX-License-Identifier: MIT
 *
 * Where a mover is by the reference's own reading of the file (model/source_motion.h), not by the model's keys. */
#ifndef SIM_SOURCE_POSE_H
#define SIM_SOURCE_POSE_H

#include "model/model.h"

/* false: the reference has none for this file. */
bool source_pose(const struct model *model, size_t mover, double time_s, struct model_pose *out);

#endif
