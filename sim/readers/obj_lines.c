/* SPDX-License-Identifier: MIT */
#include "readers/obj_lines.h"

#include "base/grow.h"
#include "files/whole_file.h"

#include <stdlib.h>
#include <string.h>

void obj_lines_begin(struct obj_lines *lines, const char *bytes, size_t size_b)
{
    const int mark_b = whole_file_mark_b(bytes, size_b);
    *lines = (struct obj_lines){.at = bytes + (mark_b > 0 ? mark_b : 0), .end = bytes + size_b, .next = 1};
}

/* Past a line's end, of one or two characters. */
static void skip_end(struct obj_lines *lines)
{
    const bool is_double = lines->end - lines->at > 1 && lines->at[0] == '\r' && lines->at[1] == '\n';
    lines->at += is_double ? 2 : 1;
    lines->next++;
}

static bool is_continued(const struct obj_lines *lines)
{
    return lines->at[0] == '\\' && lines->end - lines->at > 1 && is_line_end(lines->at[1]);
}

/* Copies a line into `line`. */
static void join(struct obj_lines *lines)
{
    size_t length = 0;
    for (;;) {
        const bool is_over = lines->at == lines->end || is_line_end(*lines->at);
        lines->line = grow(lines->line, length, &lines->capacity, 1);
        lines->line[length++] = is_over ? '\0' : *lines->at;
        if (is_over) break;
        if (is_continued(lines)) {
            length--;
            lines->at++;
            skip_end(lines);
        } else {
            lines->at++;
        }
    }
    if (lines->at < lines->end) skip_end(lines);
}

bool obj_lines_next(struct obj_lines *lines)
{
    while (lines->at < lines->end) {
        lines->number = lines->next;
        join(lines);
        const char *first = lines->line + strspn(lines->line, " \t");
        lines->statement = (struct word){first, strcspn(first, " \t")};
        lines->rest = first + lines->statement.length;
        if (lines->statement.length && *first != '#') return true;
    }
    return false;
}

void obj_lines_free(struct obj_lines *lines)
{
    free(lines->line);
    *lines = (struct obj_lines){0};
}

size_t obj_lines_words(const struct obj_lines *lines, struct word *words, size_t most)
{
    size_t count = 0;
    for (const char *at = lines->rest + strspn(lines->rest, " \t"); *at && *at != '#'; at += strspn(at, " \t")) {
        const size_t length = strcspn(at, " \t#");
        if (count < most) words[count] = (struct word){at, length};
        at += length;
        count++;
    }
    return count;
}

struct word obj_lines_name(const struct obj_lines *lines)
{
    const char *first = lines->rest + strspn(lines->rest, " \t");
    size_t length = strlen(first);
    while (length && is_blank(first[length - 1]))
        length--;
    return (struct word){first, length};
}
