/* SPDX-License-Identifier: MIT
 *
 * Wavefront OBJ. Vertices are `v x y z`, with a divisor or with a colour behind; all else is copied, but for objects
 * and groups, which are left out (vertex_numbers.h says why), and blanks before a line's first word, with which the
 * library would overlook the line. */
#include "readers/numbering.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_NUMBERS = 6 };

/* A line's length in the file, its ends and those of the lines that it is continued on left in. */
static size_t line_length(const struct numbering *work)
{
    const char *at = work->at;
    while (at < work->end && !is_line_end(*at))
        if (*at == '\\' && at + 1 < work->end && is_line_end(at[1]))
            at += at[1] == '\r' && at + 2 < work->end && at[2] == '\n' ? 3 : 2;
        else
            at++;
    return (size_t)(at - work->at);
}

/* The line without its continuations, a 0 behind it. */
static char *joined(const char *text, size_t length, size_t *joined_length)
{
    char *line = malloc(length + 1);
    *joined_length = 0;
    if (!line) return NULL;
    for (size_t i = 0; i < length; i++) {
        const bool continues = text[i] == '\\' && i + 1 < length && is_line_end(text[i + 1]);
        if (continues)
            i += text[i + 1] == '\r' && i + 2 < length && text[i + 2] == '\n' ? 2 : 1;
        else
            line[(*joined_length)++] = text[i];
    }
    line[*joined_length] = '\0';
    return line;
}

static bool write_vertex(struct numbering *work, const struct word *words, size_t count)
{
    double point[3], divisor = 1;
    for (int i = 0; i < 3; i++)
        if (!numbering_parse(work, &words[i], &point[i])) return false;
    if (count == 4 && !numbering_parse(work, &words[3], &divisor)) return false;
    if (divisor == 0) return error_set(work->err, "%s:%zu: a vertex is divided by 0", work->path, work->line);
    for (int i = 0; count == 4 && i < 3; i++)
        point[i] /= divisor;
    numbering_write(work, "v ", 2);
    if (!numbering_vertex(work, point)) return false;
    for (size_t i = 3; count == 6 && i < 6; i++) {
        double colour;
        if (!numbering_parse(work, &words[i], &colour)) return false;
        numbering_word(work, &words[i]);
    }
    return true;
}

static bool write_texture_place(struct numbering *work, const struct word *words, size_t count)
{
    numbering_write(work, "vt", 2);
    for (size_t i = 0; i < count && i < 3; i++)
        numbering_word(work, &words[i]);
    return true;
}

static bool number_words(struct numbering *work, const char *line, size_t length)
{
    struct word words[MOST_NUMBERS + 1];
    const size_t count = words_of(line, line + length, words, MOST_NUMBERS + 1) - 1;
    if (words[0].length == 2) return write_texture_place(work, words + 1, count);
    if (count != 3 && count != 4 && count != 6)
        return error_set(work->err,
                         "%s:%zu: a vertex of %zu numbers; it has three, a divisor behind them or a colour of three",
                         work->path, work->line, count);
    return write_vertex(work, words + 1, count);
}

static bool is_word(const struct numbering *work, const char *word)
{
    const size_t length = strlen(word), left = (size_t)(work->end - work->at);
    return left > length && memcmp(work->at, word, length) == 0 && is_blank(work->at[length]);
}

static bool number_line(struct numbering *work)
{
    const size_t length = line_length(work);
    if (length > 0 && (*work->at == 'o' || *work->at == 'g')) {
        numbering_skip(work, length);
    } else if (is_word(work, "v") || is_word(work, "vt")) {
        size_t joined_length;
        char *line = joined(work->at, length, &joined_length);
        const bool ok =
            line ? number_words(work, line, joined_length) : error_set(work->err, "%s: not enough memory", work->path);
        free(line);
        if (!ok) return false;
        numbering_skip(work, length);
    } else {
        numbering_copy(work, length);
    }
    while (work->at < work->end && is_line_end(*work->at))
        numbering_skip(work, 1);
    numbering_write(work, "\n", 1);
    return true;
}

bool number_obj(struct numbering *work)
{
    while (work->at < work->end) {
        if (is_blank(*work->at) || is_line_end(*work->at))
            numbering_skip(work, 1);
        else if (!number_line(work))
            return false;
    }
    return true;
}
