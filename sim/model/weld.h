/* SPDX-License-Identifier: MIT
 *
 * Points that are meant to be one, made one. */
#ifndef SIM_WELD_H
#define SIM_WELD_H

#include "model/mesh.h"

/* Fills the mesh's points with those of the model's faces, no two nearer than weld_m: of points that
 * are, the first in the file's order stays. Returns, for each point of the model, its index in the
 * mesh; free() it. Points that no face uses have the index UINT32_MAX. */
uint32_t *weld_points(const struct model *model, double weld_m, struct mesh *mesh);

#endif
