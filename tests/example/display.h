/* SPDX-License-Identifier: MIT
 *
 * The display of the example. On a board this sends pixels to a panel; in the tests it prints a
 * hash of all it was given. */
#ifndef EXAMPLE_DISPLAY_H
#define EXAMPLE_DISPLAY_H

#include <stdint.h>

enum { DISPLAY_W_PX = 240, DISPLAY_H_PX = 240 };

/* n_px pixels from (x_px, y_px) to the right, RGB565 in bus byte order. 0, or a negative error. */
int display_line(uint16_t y_px, uint16_t x_px, const uint16_t *pixels, uint16_t n_px);

#endif
