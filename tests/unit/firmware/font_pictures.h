/* SPDX-License-Identifier: MIT
 *
 * The font as pictures, tests/unit/firmware/font.expected: what tests take text from, instead of the font's bytes. */
#ifndef TESTS_FONT_PICTURES_H
#define TESTS_FONT_PICTURES_H

#include <stdbool.h>

enum { FONT_GLYPHS = 95, FONT_FIRST = 32, FONT_ROWS = 8, FONT_COLUMNS = 5, FONT_CELL_PX = 6 };

struct font_pictures {
    bool is_ink[FONT_GLYPHS][FONT_ROWS][FONT_COLUMNS];
};

/* A failure ends the test. */
void font_pictures_read(struct font_pictures *font);

/* Whether a text of so many pixels to a pixel of the font has ink at x, y, from its upper left; *in_cell: whether it
 * has a cell there. */
bool font_pictures_at(const struct font_pictures *font, const char *text, int scale, int x, int y, bool *in_cell);

#endif
