/* SPDX-License-Identifier: MIT
 *
 * A transparent colour over pixels that are there, in the panel's format. Each channel is
 *
 *     round((colour w + behind (256 - w)) / 256),  w = alpha + (alpha >> 7), which is 0..256 for alpha 0..255
 *
 * w / 256 differs from alpha / 255 by less than 1/507, an eighth of a green level; with the rounding a layer is off
 * by less than 0.63 of a level. */
#ifndef LIM_BLEND_H
#define LIM_BLEND_H

#include "config.h"

/* n pixels from x on. `colour` and the pixels are as they lie in memory (colour.h). */
void lim_blend(uint16_t *line, uint16_t x_px, uint16_t n_px, uint16_t colour, uint8_t alpha);

#endif
