/* SPDX-License-Identifier: MIT */
#include "cameras/facing.h"

#include "base/vec3.h"
#include "model/face_normal.h"

enum { INVISIBLE = 255 };

static bool faces_any(const struct model *model, const struct model_face *face, const struct camera_path *path)
{
    double normal[3], to_eye[3];
    face_normal(model, face, normal);
    for (size_t frame = 0; frame < path->count; frame++) {
        vec3_sub(to_eye, path->frames[frame].eye_m, model->points[model->corners[face->first]]);
        if (vec3_dot(normal, to_eye) > 0) return true;
    }
    return false;
}

bool facing_any(const struct model *model, const struct camera_path *path)
{
    for (size_t i = 0; i < model->face_count; i++) {
        const struct model_face *face = &model->faces[i];
        if (face->transparency == INVISIBLE) continue;
        if (face->two_sided || faces_any(model, face, path)) return true;
    }
    return false;
}
