/* SPDX-License-Identifier: MIT
 *
 * SKY: a picture on a cylinder around the eye, endlessly far away, wherever a polygon with such a texture is seen. In:
 * the camera, once a frame; spans. Out: their pixels. Memory: the caller's struct, which remembers two rows of nodes.
 *
 * Nodes are pixels of the screen some apart in either direction. What each shows is found by an arctangent and a root,
 * and between four of them a straight line is taken in either direction. Whoever asks first for a node has it computed:
 * all orders of drawing paint the same. */
#ifndef LIM_SKY_H
#define LIM_SKY_H

#include "camera.h"
#include "scene.h"
#include "stages.h"

/* Once a frame, on a screen of this size, with the camera's axes, of lim_orientation_set(). */
void lim_sky_begin(struct lim_sky *sky, const struct lim_camera *camera, const int32_t axes_q30[9], uint16_t w_px,
                   uint16_t h_px);

/* Once a polygon whose texture is a sky. */
void lim_sky_set(const struct lim_texturing *texturing, const LIM_FLASH struct lim_mapping *mapping,
                 struct lim_gradients *out);

/* Paints pixels x0 <= x < x1 of a line, one at least, on the screen. */
void lim_sky_fill(const struct lim_textured_span *span, uint16_t *pixels, int32_t x0, int32_t x1);

#endif
