/* SPDX-License-Identifier: MIT
 *
 * A rectangle of the screen. */
#ifndef LIM_RECT_H
#define LIM_RECT_H

#include <stdint.h>

/* Pixels x0 <= x < x1, y0 <= y < y1. */
struct lim_rect {
    uint16_t x0, y0, x1, y1;
};

#endif
