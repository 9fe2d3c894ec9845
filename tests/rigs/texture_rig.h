/* SPDX-License-Identifier: MIT
 *
 * Models with textures for tests: faces of their own corners, coordinates and pictures. */
#ifndef TESTS_TEXTURE_RIG_H
#define TESTS_TEXTURE_RIG_H

#include "model/model.h"
#include "random.h"
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

#endif
