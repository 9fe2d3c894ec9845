/* SPDX-License-Identifier: MIT */
#include "model/face_normal.h"

#include "base/vec3.h"

void face_normal(const struct model *model, const struct model_face *face, double normal[3])
{
    const uint32_t *corners = &model->corners[face->first];
    normal[0] = normal[1] = normal[2] = 0;
    for (uint32_t k = 2; k < face->count; k++) {
        double a[3], b[3];
        vec3_sub(a, model->points[corners[k - 1]], model->points[corners[0]]);
        vec3_sub(b, model->points[corners[k]], model->points[corners[0]]);
        for (int axis = 0; axis < 3; axis++)
            normal[axis] += a[(axis + 1) % 3] * b[(axis + 2) % 3] - a[(axis + 2) % 3] * b[(axis + 1) % 3];
    }
}
