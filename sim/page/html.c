/* SPDX-License-Identifier: MIT */
#include "page/html.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { NUMBER_B = 64, GROUP = 3 };
static const char THIN_SPACE[] = "&#8239;", UNKNOWN[] = "&#65533;", DASH[] = "&#8211;";

/* Bytes of the character of UTF-8 at `at`; 0: it is none. Neither overlong ones nor surrogates are. */
static size_t utf8_length(const unsigned char *at)
{
    static const struct {
        unsigned char mask, lead;
        size_t length;
        uint32_t least;
    } forms[] = {{0xE0, 0xC0, 2, 0x80}, {0xF0, 0xE0, 3, 0x800}, {0xF8, 0xF0, 4, 0x10000}};
    if (*at < 0x80) return 1;
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        if ((*at & forms[i].mask) != forms[i].lead) continue;
        uint32_t code = (uint32_t)(*at & (unsigned char)~forms[i].mask);
        for (size_t k = 1; k < forms[i].length; k++) {
            if ((at[k] & 0xC0) != 0x80) return 0;
            code = code << 6 | (at[k] & 0x3Fu);
        }
        const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF, is_control = code < 0xA0;
        return code < forms[i].least || code > 0x10FFFF || is_surrogate || is_control ? 0 : forms[i].length;
    }
    return 0;
}

static const char *escape_of(unsigned char letter)
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
        return letter < ' ' || letter == 0x7F ? " " : NULL;
    }
}

void html_text(FILE *file, const char *text)
{
    for (const unsigned char *at = (const unsigned char *)text; *at;) {
        const size_t length = utf8_length(at);
        const char *escape = length ? escape_of(*at) : UNKNOWN;
        if (escape)
            fputs(escape, file);
        else
            fwrite(at, 1, length, file);
        at += length ? length : 1;
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
