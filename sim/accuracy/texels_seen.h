/* SPDX-License-Identifier: MIT
 *
 * How much of each texture is seen, and at which level of detail: of rays in double precision, from the mesh's planes.
 */
#ifndef SIM_TEXELS_SEEN_H
#define SIM_TEXELS_SEEN_H

#include "accuracy/reference.h"
#include "cameras/camera_path.h"
#include "model/mesh.h"

enum { TEXELS_SEEN_LEVELS = 11 };

/* log2 of the texels to a pixel of a picture where the ray through a pixel of the reference ends, the mean of both
 * directions. pixel_area: of a pixel of that picture, on the plane at distance 1. */
double texel_level_at(const struct reference *reference, size_t pixel, const struct mapping *mapping,
                      const struct texture *texture, double pixel_area);

/* Pixels of all frames that show the texture at such a level. Where light is dim, less than one. */
struct texels_seen {
    double pixels[TEXELS_SEEN_LEVELS];
};

/* Adds what the path's cameras see on a display of w_px pixels to seen[texture], 0 .. mesh->texture_count. `mesh` as
 * mesh_clean() leaves it, `model` that it is of, with its light. */
bool texels_seen_add(const struct mesh *mesh, const struct model *model, const struct camera_path *path,
                     const struct lens *lens, unsigned w_px, struct texels_seen *seen, struct error *err);

#endif
