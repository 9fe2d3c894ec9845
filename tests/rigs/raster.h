/* SPDX-License-Identifier: MIT
 *
 * The raw intervals of EDGE, SPAN bypassed: for tests that count how often each pixel is covered. */
#ifndef TESTS_RASTER_H
#define TESTS_RASTER_H

#include "screen/edge.h"

/* Pixels x0 .. x0 + w - 1, y0 .. y0 + h - 1 of the plane; may be negative. */
struct coverage {
    int16_t x0, y0, w, h;
    uint8_t *count; /* w * h, row by row; saturates at 255 */
};

/* Adds one to every pixel that the polygon covers, drawing it as the renderer does: as a fan of
 * triangles if it is non-monotone. Returns whether it was. */
bool raster_add(struct coverage *coverage, const struct lim_point *at, uint8_t n);

#endif
