/* SPDX-License-Identifier: MIT
 *
 * How many bits coordinates get. What is asked of 16 bits is what would be refused: faces, the near plane, eyes. */
#ifndef SIM_COORDINATES_H
#define SIM_COORDINATES_H

#include "compiler/compile_options.h"
#include "model/mesh.h"

/* mesh_clean() on the grid that the options ask for; or on that of 16 bits, unless the model, the near plane or the
 * cameras want 32. */
bool coordinates_clean(const struct model *model, const struct compile_options *options, struct mesh *mesh,
                       struct error *err);

/* Whether a scene that was refused on a mesh's grid may be tried with 32 bits. */
bool coordinates_may_retry(const struct mesh *mesh, const struct compile_options *options);

#endif
