/* SPDX-License-Identifier: MIT
 *
 * Which part of a texture a polygon shows, as an affine function of space. Such a function is the same for every piece
 * of the polygon, so that merging, T-vertices and splits have nothing to interpolate. */
#ifndef SIM_MAPPING_H
#define SIM_MAPPING_H

#include "model/loop.h"
#include "model/mesh.h"

/* Adds a polygon's mapping to the mesh: `loop` has the polygon's corners, `face` the model's face that they are of,
 * `welded` for each point of the model that of the mesh. Returns its index; 0 if the face shows no texture, or none
 * that its coordinates make sense of, which is counted. *is_affine: no corner is off by more than an eighth of a texel.
 */
uint32_t mapping_add(struct mesh *mesh, const struct model *model, const struct model_face *face,
                     const uint32_t *welded, const struct loop *loop, bool *is_affine);

/* Do both show the same wherever these corners are, within a 16th of a texel? Textures repeat. */
bool mapping_agree(const struct mesh *mesh, uint32_t a, uint32_t b, const uint32_t *corners, size_t count);

/* "N faces ...": why they do not show their texture. */
const char *unmapped_words(enum unmapped kind);

/* In pictures, across and down, at a point in metres. */
void mapping_at(const struct mapping *mapping, const double point_m[3], double uv[2]);

#endif
