/* SPDX-License-Identifier: MIT */
#include "font_pictures.h"

#include "rigs/cmocka_ready.h"

#include <stdio.h>
#include <string.h>

#define FONT_FILE "tests/unit/firmware/font.expected"

/* Up to 16 glyphs side by side, their rows in lines of words. */
static int read_row(struct font_pictures *font, int first, int row, char *line)
{
    int n = 0;

    for (char *word = strtok(line, " \n"); word; word = strtok(NULL, " \n"), n++) {
        assert_int_equal(strspn(word, ".#"), FONT_COLUMNS);
        assert_int_equal(strlen(word), FONT_COLUMNS);
        assert_true(first + n < FONT_GLYPHS);
        for (int column = 0; column < FONT_COLUMNS; column++)
            font->is_ink[first + n][row][column] = word[column] == '#';
    }
    return n;
}

void font_pictures_read(struct font_pictures *font)
{
    FILE *file = fopen(FONT_FILE, "r");
    char line[256];
    int first = 0, row = 0;

    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        const int n = read_row(font, first, row, line);
        if (n == 0) continue;
        row = (row + 1) % FONT_ROWS;
        if (row == 0) first += n;
    }
    fclose(file);
    assert_int_equal(first, FONT_GLYPHS);
    assert_int_equal(row, 0);
}

bool font_pictures_at(const struct font_pictures *font, const char *text, int scale, int x, int y, bool *in_cell)
{
    const int cell = x >= 0 ? x / (FONT_CELL_PX * scale) : -1, column = x >= 0 ? x / scale % FONT_CELL_PX : 0;

    *in_cell = cell >= 0 && cell < (int)strlen(text) && y >= 0 && y < FONT_ROWS * scale;
    if (!*in_cell || column >= FONT_COLUMNS) return false;
    const int code = (unsigned char)text[cell];
    const bool is_known = code >= FONT_FIRST && code < FONT_FIRST + FONT_GLYPHS;
    return font->is_ink[(is_known ? code : '?') - FONT_FIRST][y / scale][column];
}
