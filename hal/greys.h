/* SPDX-License-Identifier: MIT
 *
 * A picture of 16 dithered greys (PANEL_GREY4) in memory, painted by pieces of lines in one colour: for who knows a
 * colour before there are pixels. The dither repeats each four columns and lines, so sixteen greys are all of a colour.
 */
#ifndef HAL_GREYS_H
#define HAL_GREYS_H

#include "pixels.h"

HAL_C_BEGIN

struct greys {
    uint8_t *picture; /* 4-byte aligned */
    uint16_t line_b;  /* a multiple of 4 */
    uint16_t colour;  /* RGB565 as it lies in memory */
    uint32_t rows[4]; /* bytes of that colour as they lie in memory, for the lines y_px % 4 */
};

/* Takes another colour: just what pixels_gather() makes of it. */
void greys_set(struct greys *greys, uint16_t colour);

/* Pixels x0_px <= x < x1_px of the line y_px become that colour. */
void greys_fill(const struct greys *greys, uint16_t y_px, uint16_t x0_px, uint16_t x1_px);

HAL_C_END

#endif
