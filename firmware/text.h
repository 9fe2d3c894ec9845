/* SPDX-License-Identifier: MIT
 *
 * Text over a frame (overlay.h), in a font of 5x8 pixels, and numbers as text. A program that does not call lim_text()
 * has no font: its linker drops it, or LIM_HAS_OVERLAY is 0. */
#ifndef LIM_TEXT_H
#define LIM_TEXT_H

#include "overlay.h"

LIM_C_BEGIN

/* A character's cell, times the scale: the glyph at its upper left, and a column that stays free. */
#define LIM_TEXT_W_PX 6
#define LIM_TEXT_H_PX 8

/* Delta output keeps a line as runs of one colour: by a text of n characters in that scale there are at most so many
 * more. What else is drawn is not counted: a box or a bar has two a line, a frame four. */
#define LIM_TEXT_RUNS(n, scale) (LIM_TEXT_H_PX * 6u * (n) * ((scale) ? (scale) : 1u))

/* Zero is black, and what lies below shows between the strokes. */
struct lim_text_style {
    uint16_t colour;
    bool solid;          /* cells are filled with the background */
    uint16_t background; /* if solid */
    uint8_t scale;       /* pixels of the screen to a pixel of the font, in each direction; 0 is 1 */
};

/* Draws a text whose first cell's upper left pixel is x_px, y_px. What is not in ASCII 32 to 126 is shown as `?`. The
 * text lies in RAM. */
void lim_text(const struct lim_overlay_line *line, int16_t x_px, int16_t y_px, const char *text,
              const struct lim_text_style *style);

/* Numbers are written once a frame, not once a line. Each function writes a number and a 0 behind it, and returns where
 * the 0 is, so that another one may follow. */

/* At most LIM_TEXT_INTEGER_B bytes. */
#define LIM_TEXT_INTEGER_B 12u
char *lim_text_integer(char *to, int32_t value);

/* value / 2^fraction_bits with 0..4 decimals, rounded to nearest, halves away from zero; fraction_bits: 0..16. At most
 * LIM_TEXT_FIXED_B bytes. */
#define LIM_TEXT_FIXED_B 17u
char *lim_text_fixed(char *to, int32_t value, uint8_t fraction_bits, uint8_t decimals);

LIM_C_END

#endif
