/* SPDX-License-Identifier: MIT */
#include "readers/numbering.h"

#include "files/decimal.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void numbering_write(struct numbering *work, const char *bytes, size_t size_b)
{
    if (work->out_capacity - work->out_b < size_b) {
        work->out_capacity = 2 * (work->out_b + size_b);
        char *larger = realloc(work->out, work->out_capacity);
        if (!larger) {
            fputs("limner: out of memory\n", stderr);
            exit(EXIT_FAILURE);
        }
        work->out = larger;
    }
    memcpy(work->out + work->out_b, bytes, size_b);
    work->out_b += size_b;
}

void numbering_print(struct numbering *work, const char *format, ...)
{
    char text[128];
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    numbering_write(work, text, (size_t)length);
}

bool numbering_parse(struct numbering *work, const struct word *word, double *value)
{
    enum { SHOWN = 40 };
    if (decimal_parse(word->text, word->length, value)) return true;
    return error_set(work->err, "%s:%zu: '%.*s' is not a decimal number up to 3.4e38", work->path, work->line,
                     word->length < SHOWN ? (int)word->length : SHOWN, word->text);
}

bool numbering_vertex(struct numbering *work, const double point[3])
{
    unsigned stand_in[3];
    if (work->table.count == VERTEX_TABLE_MOST)
        return error_set(work->err, "%s: more than %d vertices", work->path, VERTEX_TABLE_MOST);
    vertex_table_add(&work->table, point, stand_in);
    numbering_print(work, "%u %u %u", stand_in[0], stand_in[1], stand_in[2]);
    return true;
}
