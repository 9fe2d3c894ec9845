/* SPDX-License-Identifier: MIT
 *
 * contact_sheet SHEET.png FOLDER...: joins what contact_sheet.sh left in each folder, 0.png and 1.png, of one size, and
 * the lines of `said`, which stand below. A picture that is missing is a dark field. */
#include <gd.h>
#include <gdfonts.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE_PX = 160, COLUMNS = 4, GAP_PX = 8, LETTER_PX = 6, LINE_PX = 13, LINES = 7 };
enum { CELL_W_PX = 2 * SIDE_PX + 2, CELL_H_PX = SIDE_PX + LINES * LINE_PX, LETTERS = CELL_W_PX / LETTER_PX };
enum { TEXT_B = 4096, PATH_B = 4096 };

static void draw_picture(gdImagePtr sheet, const char *folder, int which, int x, int y)
{
    char path[PATH_B];
    gdImageFilledRectangle(sheet, x, y, x + SIDE_PX - 1, y + SIDE_PX - 1, gdTrueColor(60, 30, 30));
    snprintf(path, sizeof path, "%s/%d.png", folder, which);
    FILE *file = fopen(path, "rb");
    gdImagePtr picture = file ? gdImageCreateFromPng(file) : NULL;
    if (picture)
        gdImageCopyResampled(sheet, picture, x, y, 0, 0, SIDE_PX, SIDE_PX, gdImageSX(picture), gdImageSY(picture));
    if (picture) gdImageDestroy(picture);
    if (file) fclose(file);
}

static size_t read_text(const char *folder, char text[TEXT_B])
{
    char path[PATH_B];
    snprintf(path, sizeof path, "%s/said", folder);
    FILE *file = fopen(path, "r");
    const size_t length = file ? fread(text, 1, TEXT_B - 1, file) : 0;
    text[length] = '\0';
    if (file) fclose(file);
    return length;
}

/* Lines that are too long go on below. */
static void draw_text(gdImagePtr sheet, const char *folder, int x, int y)
{
    char text[TEXT_B], *at = text;
    read_text(folder, text);
    for (int line = 0; line < LINES && *at; line++) {
        char part[LETTERS + 1];
        const size_t whole = strcspn(at, "\n"), length = whole < LETTERS ? whole : LETTERS;
        memcpy(part, at, length);
        part[length] = '\0';
        gdImageString(sheet, gdFontGetSmall(), x, y + line * LINE_PX, (unsigned char *)part,
                      line ? gdTrueColor(220, 200, 120) : gdTrueColor(255, 255, 255));
        at += length;
        at += *at == '\n';
    }
}

static bool write_sheet(gdImagePtr sheet, const char *path)
{
    FILE *file = fopen(path, "wb");
    if (!file) return false;
    gdImagePng(sheet, file);
    return !(ferror(file) | fclose(file));
}

int main(int argc, char **argv)
{
    const int count = argc - 2, rows = (count + COLUMNS - 1) / COLUMNS;
    if (count < 1) return fputs("usage: contact_sheet SHEET.png FOLDER...\n", stderr), EXIT_FAILURE;
    gdImagePtr sheet = gdImageCreateTrueColor(COLUMNS * (CELL_W_PX + GAP_PX), rows * (CELL_H_PX + GAP_PX));
    if (!sheet) return fputs("contact_sheet: out of memory\n", stderr), EXIT_FAILURE;
    gdImageFilledRectangle(sheet, 0, 0, gdImageSX(sheet), gdImageSY(sheet), gdTrueColor(40, 40, 48));
    for (int i = 0; i < count; i++) {
        const int x = i % COLUMNS * (CELL_W_PX + GAP_PX) + GAP_PX / 2,
                  y = i / COLUMNS * (CELL_H_PX + GAP_PX) + GAP_PX / 2;
        for (int which = 0; which < 2; which++)
            draw_picture(sheet, argv[2 + i], which, x + which * (SIDE_PX + 2), y);
        draw_text(sheet, argv[2 + i], x, y + SIDE_PX);
    }
    const bool ok = write_sheet(sheet, argv[1]);
    gdImageDestroy(sheet);
    if (!ok) fprintf(stderr, "contact_sheet: %s: cannot be written\n", argv[1]);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
