/* SPDX-License-Identifier: MIT */
#ifndef SIM_FACE_NORMAL_H
#define SIM_FACE_NORMAL_H

#include "model/model.h"

/* The sum of the normals of a face's triangles, as long as twice its area. */
void face_normal(const struct model *model, const struct model_face *face, double normal[3]);

#endif
