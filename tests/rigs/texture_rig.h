/* SPDX-License-Identifier: MIT
 *
 * Models with textures for tests: faces of their own corners, coordinates and pictures. */
#ifndef TESTS_TEXTURE_RIG_H
#define TESTS_TEXTURE_RIG_H

#include "camera.h"
#include "model/model.h"
#include "random.h"
#include "render/simulator.h"
#include "scene/compiled.h"

/* A picture of random colours; its number. */
uint32_t texture_rig_picture(struct model *model, uint32_t w_px, uint32_t h_px, struct random *random);

/* A face that shows it. Start from a zeroed model; model_free() it. */
void texture_rig_face(struct model *model, uint32_t picture, size_t count, const double (*places)[3],
                      const double (*uvs)[2]);

/* A room 2 m wide round the origin, seen from inside: `repeat` pictures along each side. */
void texture_rig_room(struct model *model, uint32_t picture, double repeat);

/* Compiled without any light. */
struct compiled texture_rig_compile(const struct model *model, struct mesh *mesh, const struct core *core);

/* Within `reach_m` of the room's middle along each axis, with any turn of the head and a lens from one tangent to
 * another, for pictures of that size. */
struct lim_camera texture_rig_camera(struct random *random, const struct grid *grid, double reach_m,
                                     const double tans[2], unsigned w_px, unsigned h_px);
void texture_rig_draw(struct simulator *simulator, const struct lim_camera *camera);

/* Yaw, pitch and roll as camera.h has them, written down a second time. */
void texture_rig_axes(const struct lim_camera *camera, double right[3], double down[3], double ahead[3]);

#endif
