/* SPDX-License-Identifier: MIT
 *
 * From a mesh to a compiled scene. */
#ifndef SIM_COMPILE_MESH_H
#define SIM_COMPILE_MESH_H

#include "compiler/compile_options.h"
#include "scene/compiled.h"

/* Builds the exact BSP tree of a mesh (T-vertices already in it), or another one, or none, and encodes it. */
bool compile_mesh(const struct mesh *mesh, const struct compile_options *options, struct compiled *out,
                  struct error *err);

#endif
