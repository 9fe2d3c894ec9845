/* SPDX-License-Identifier: MIT
 *
 * What the library has read of a file and nobody draws: a note for each kind. Formats that are looked at before the
 * library reads them (OBJ, glTF) tell it themselves. */
#ifndef SIM_LEFT_OUT_H
#define SIM_LEFT_OUT_H

#include "model/model.h"

#include <assimp/scene.h>
#include <stddef.h>

void left_out_tell(const char *path, const struct aiScene *scene, struct model *model);

/* Meshes of a Collada file that the library passes over, as they have morph targets. */
size_t left_out_morphed(const char *path);

#endif
