/* SPDX-License-Identifier: MIT
 *
 * TEXTURE of a triangle whose corners have places in the picture, as a mesh's have: in perspective, for
 * lim_texture_fill(). In: the corners in view space, also those that clipping takes away. Out: struct lim_gradients. */
#ifndef LIM_TEXTURE_TRIANGLE_H
#define LIM_TEXTURE_TRIANGLE_H

#include "pixels/texture.h"
#include "view/view.h"

/* |place| < 2^16, as struct lim_uv. */
struct lim_texture_corner {
    struct lim_view_point at;
    int32_t place[2];
};

/* `at`: what is seen of it, n corners on the screen. */
void lim_texture_set_triangle(const struct lim_texturing *texturing, const LIM_FLASH struct lim_texture *texture,
                              const struct lim_texture_corner corners[3], const struct lim_point *at, uint8_t n,
                              struct lim_gradients *out);

#endif
