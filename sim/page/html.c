/* SPDX-License-Identifier: MIT */
#include "page/html.h"

#include "base/printable.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { NUMBER_B = 64, GROUP = 3 };
static const char THIN_SPACE[] = "&#8239;", UNKNOWN[] = "&#65533;", DASH[] = "&#8211;";

static const char *escape_of(char letter)
{
    switch (letter) {
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '&':
        return "&amp;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        return NULL;
    }
}

void html_text(FILE *file, const char *text)
{
    for (size_t length; *text; text += length) {
        const enum printable_kind kind = printable_at(text, &length);
        const char *escape = kind == PRINTABLE ? escape_of(*text) : kind == PRINTABLE_CONTROL ? " " : UNKNOWN;
        if (escape)
            fputs(escape, file);
        else
            fwrite(text, 1, length, file);
    }
}

void html_number(FILE *file, double number, int decimals)
{
    char digits[NUMBER_B];
    if (!isfinite(number)) {
        fputs(DASH, file);
        return;
    }
    snprintf(digits, sizeof digits, "%.*f", decimals, number);
    const size_t sign = digits[0] == '-', whole = strcspn(digits, ".");
    for (size_t i = 0; digits[i]; i++) {
        if (i > sign && i < whole && (whole - i) % GROUP == 0) fputs(THIN_SPACE, file);
        fputc(digits[i], file);
    }
}

static void write_base64(FILE *file, const unsigned char *bytes, size_t count)
{
    static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < count; i += 3) {
        const size_t left = count - i;
        const uint32_t three = (uint32_t)bytes[i] << 16 | (left > 1 ? (uint32_t)bytes[i + 1] << 8 : 0) |
                               (left > 2 ? (uint32_t)bytes[i + 2] : 0);
        for (unsigned k = 0; k < 4; k++)
            fputc(k <= left ? letters[three >> (18 - 6 * k) & 63] : '=', file);
    }
}

bool html_picture(FILE *file, gdImagePtr image, const char *alt, struct error *err)
{
    int size_b = 0;
    unsigned char *bytes = image ? gdImagePngPtr(image, &size_b) : NULL;
    if (!bytes) return error_set(err, "a picture of the page: out of memory");
    fprintf(file, "<img width=\"%d\" height=\"%d\" alt=\"", gdImageSX(image), gdImageSY(image));
    html_text(file, alt);
    fputs("\" src=\"data:image/png;base64,", file);
    write_base64(file, bytes, (size_t)size_b);
    fputs("\">", file);
    gdFree(bytes);
    return true;
}

void html_row_begin(FILE *file, const char *name)
{
    fputs("<tr><th scope=\"row\">", file);
    html_text(file, name);
    fputs("</th>", file);
}

void html_cell(FILE *file, double number, int decimals)
{
    fputs("<td>", file);
    html_number(file, number, decimals);
    fputs("</td>", file);
}

void html_bar(FILE *file, double bar)
{
    fprintf(file, "<td class=\"bar\" style=\"background-size:%.1f%% 12px\"></td>",
            bar > 0.0 ? 100.0 * fmin(bar, 1.0) : 0.0);
}

void html_row_end(FILE *file)
{
    fputs("</tr>\n", file);
}

void html_section(FILE *file, const char *id, const char *title)
{
    fprintf(file, "<section id=\"%s\">\n<h2>%s</h2>\n", id, title);
}

void html_section_end(FILE *file)
{
    fputs("</section>\n", file);
}
