/* SPDX-License-Identifier: MIT
 *
 * What the library has read of a file and nobody draws: a note for each kind. Formats that are looked at before the
 * library reads them (OBJ, glTF) tell it themselves. */
#ifndef SIM_LEFT_OUT_H
#define SIM_LEFT_OUT_H

#include "model/model.h"

#include <assimp/scene.h>

void left_out_tell(const struct aiScene *scene, struct model *model);

#endif
