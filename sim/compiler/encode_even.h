/* SPDX-License-Identifier: MIT
 *
 * From how far away on texels advance evenly over a triangle of a mesh: scene.h, LIM_TRIANGLE_TEXTURES. */
#ifndef SIM_ENCODE_EVEN_H
#define SIM_ENCODE_EVEN_H

#include "scene/encoding.h"

/* Into the last words of all triangles, once places, textures and vertices are complete. */
void encode_even(struct encoding *out);

#endif
