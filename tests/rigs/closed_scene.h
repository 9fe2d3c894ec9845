/* SPDX-License-Identifier: MIT
 *
 * Random closed scenes: a room seen from inside, its walls of tiles that do not meet corner to
 * corner, and solids turned every way that stand in the room, in its walls and in one another. From
 * inside the room and outside of the solids no ray can miss, and none may see through. */
#ifndef TESTS_CLOSED_SCENE_H
#define TESTS_CLOSED_SCENE_H

#include "cameras/camera_path.h"
#include "model/model.h"
#include "random.h"

enum { CLOSED_MAX_SOLIDS = 24 };

struct closed_scene {
    struct model model;
    double half_m[3];                         /* of the room, centred on 0 */
    size_t first_face[CLOSED_MAX_SOLIDS + 1]; /* of each solid; the walls come before */
    size_t solids;
};

void closed_scene_make(struct closed_scene *scene, struct random *random);
void closed_scene_free(struct closed_scene *scene);

/* An eye in free space; often exactly on the plane of some face, or a hair off it. */
struct viewpoint closed_scene_viewpoint(const struct closed_scene *scene, struct random *random);

#endif
