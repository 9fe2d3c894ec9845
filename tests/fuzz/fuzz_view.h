/* SPDX-License-Identifier: MIT
 *
 * Legal cameras from bytes. */
#ifndef TESTS_FUZZ_VIEW_H
#define TESTS_FUZZ_VIEW_H

#include "fuzz_scene.h"
#include "fuzz_show.h"

/* Most values of any size about as likely. */
struct lim_camera fuzz_legal_camera(struct fuzz_bytes *bytes);

/* Of a long scene: puts the camera's origin near one of the vertices, or anywhere. */
void fuzz_view_move_origin(struct lim_camera *camera, const struct fuzz_scene *made, struct fuzz_bytes *bytes);

/* A picture's size, and two cameras: the second is the first one, that turned or moved, or any other. */
void fuzz_view_from(struct fuzz_bytes *bytes, struct fuzz_subject *subject);

#endif
