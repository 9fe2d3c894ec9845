/* SPDX-License-Identifier: MIT
 *
 * Pictures of a model by OSMesa: somebody else's transformation, clipping, rasterizer and depth
 * buffer. Of the project only the list of faces and the meaning of a viewpoint are taken. */
#ifndef TESTS_OSMESA_H
#define TESTS_OSMESA_H

#include "cameras/camera_path.h"
#include "model/model.h"

struct osmesa {
    void *context;
    uint8_t *rgba; /* the picture, from the bottom left, denser than what is read from it */
    unsigned w_px, h_px;
    const char *renderer;           /* its own name for itself */
    int density;                    /* pixels drawn for each read, in both directions */
    int sub_pixel_bits, depth_bits; /* sub-pixels of those drawn */
};

bool osmesa_init(struct osmesa *osmesa, unsigned w_px, unsigned h_px, struct error *err);

/* Which face each pixel shows: w_px * h_px numbers from the top left, 0 = background. Faces must be
 * planar and convex. Which way one looks is decided here, from its plane in double precision; where faces
 * lie on one plane, the depth buffer decides by its rounding. */
void osmesa_draw(struct osmesa *osmesa, const struct model *model, const struct viewpoint *viewpoint,
                 const struct lens *lens, uint32_t *faces);

void osmesa_free(struct osmesa *osmesa);

#endif
