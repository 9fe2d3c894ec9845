/* SPDX-License-Identifier: MIT
 *
 * From amounts of light to what a display is sent, by the sRGB curve of IEC 61966-2-1. */
#ifndef SIM_SRGB_H
#define SIM_SRGB_H

#include <stdint.h>

/* Of 0..1. */
double srgb_from_linear(double light);
double srgb_to_linear(double channel);

/* 0..255; beyond 0..1 the nearer of them, and NaN, which a file may hold, becomes black. */
uint32_t srgb_byte(double channel);

/* 0xRRGGBB: a texel of a texture, times a face's colour, as firmware multiplies them. */
uint32_t srgb_tinted(uint32_t texel, uint32_t colour);

/* 0xRRGGBB: the light of both together, a channel up to 255. */
uint32_t srgb_sum(uint32_t a, uint32_t b);

#endif
