/* SPDX-License-Identifier: MIT
 *
 * Units that files have and the importer library leaves to its callers: of FBX, AMF and OpenGEX. Collada's, IFC's and
 * glTF's coordinates come in metres. */
#ifndef SIM_MODEL_UNIT_H
#define SIM_MODEL_UNIT_H

#include "model/model.h"

#include <assimp/scene.h>

/* How long the unit is of what the library hands over. */
double model_unit_m(const char *path, const struct aiScene *scene);

/* Makes metres of such units, of points and of what moves. */
void model_to_metres(struct model *model, double unit_m);

/* FBX again: its UpAxis is z, and the library hands it over as it is. */
bool model_says_z_up(const char *path, const struct aiScene *scene);

#endif
