/* SPDX-License-Identifier: MIT
 *
 * The display of the example. On a board this sends pixels to a panel; in the tests it prints a
 * hash of all it was given. */
#ifndef EXAMPLE_DISPLAY_H
#define EXAMPLE_DISPLAY_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { DISPLAY_W_PX = 240, DISPLAY_H_PX = 240 };

/* n_px pixels from (x_px, y_px) to the right, RGB565 in bus byte order; ctx is NULL. 0, or a negative error. */
int display_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px);

#ifdef __cplusplus
}
#endif

#endif
