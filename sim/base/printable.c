/* SPDX-License-Identifier: MIT
 *
 * UTF-8 by RFC 3629: neither overlong forms nor surrogates are characters. */
#define _GNU_SOURCE /* vasprintf() */
#include "base/printable.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

struct code_range {
    uint32_t first, last;
};

static const struct code_range CONTROLS[] = {
    {0x00, 0x1F},     {0x7F, 0x9F},     {0x061C, 0x061C}, {0x200E, 0x200F},   {0x2028, 0x202E},
    {0x2066, 0x206F}, {0xFEFF, 0xFEFF}, {0xFFF9, 0xFFFB}, {0xE0000, 0xE007F},
};

static bool is_control(uint32_t code)
{
    for (size_t i = 0; i < sizeof CONTROLS / sizeof *CONTROLS; i++)
        if (code >= CONTROLS[i].first && code <= CONTROLS[i].last) return true;
    return false;
}

/* 0: it is none. */
static size_t decode(const unsigned char *at, uint32_t *code)
{
    static const struct {
        unsigned char mask, lead;
        size_t length;
        uint32_t least;
    } forms[] = {{0x80, 0x00, 1, 0}, {0xE0, 0xC0, 2, 0x80}, {0xF0, 0xE0, 3, 0x800}, {0xF8, 0xF0, 4, 0x10000}};
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        if ((*at & forms[i].mask) != forms[i].lead) continue;
        *code = (uint32_t)(*at & (unsigned char)~forms[i].mask);
        for (size_t k = 1; k < forms[i].length; k++) {
            if ((at[k] & 0xC0) != 0x80) return 0;
            *code = *code << 6 | (at[k] & 0x3Fu);
        }
        const bool is_surrogate = *code >= 0xD800 && *code <= 0xDFFF;
        return *code < forms[i].least || *code > 0x10FFFF || is_surrogate ? 0 : forms[i].length;
    }
    return 0;
}

enum printable_kind printable_at(const char *at, size_t *length)
{
    uint32_t code;
    const size_t decoded_b = decode((const unsigned char *)at, &code);
    *length = decoded_b ? decoded_b : 1;
    if (!decoded_b) return PRINTABLE_INVALID;
    return is_control(code) ? PRINTABLE_CONTROL : PRINTABLE;
}

char *printable(char *text)
{
    char *to = text;
    for (size_t length, i = 0; text[i]; i += length) {
        const enum printable_kind kind = printable_at(text + i, &length);
        if (kind == PRINTABLE)
            memmove(to, text + i, length);
        else
            *to = kind == PRINTABLE_CONTROL ? ' ' : '?';
        to += kind == PRINTABLE ? length : 1;
    }
    *to = '\0';
    return text;
}

void printable_print(FILE *out, const char *format, ...)
{
    char *text;
    va_list values;
    va_start(values, format);
    const int length = vasprintf(&text, format, values);
    va_end(values);
    if (length < 0) return;
    const size_t format_b = strlen(format);
    const bool ends_line = format_b && length && format[format_b - 1] == '\n';
    if (ends_line) text[length - 1] = '\0';
    fputs(printable(text), out);
    if (ends_line) fputc('\n', out);
    free(text);
}
