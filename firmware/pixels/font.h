/* SPDX-License-Identifier: MIT
 *
 * The font of text.h: glyphs of 5x8 pixels, of which capitals have the upper seven lines. */
#ifndef LIM_FONT_H
#define LIM_FONT_H

#include "config.h"

enum { LIM_FONT_FIRST = 32, LIM_FONT_COUNT = 95, LIM_FONT_COLUMNS = 5 };

/* A byte for each column, from the left; bit 0 is the uppermost pixel. */
extern const LIM_FLASH uint8_t lim_font[LIM_FONT_COUNT][LIM_FONT_COLUMNS];

#endif
