/* SPDX-License-Identifier: MIT
 *
 * OFF: a line a vertex, then a line a face. The library takes faces of up to nine corners, leaves out others without a
 * word, and moves corners that are out of range to the last vertex: these are refused here. */
#include "readers/numbering.h"

#include <stdlib.h>
#include <string.h>

enum { LIBRARY_CORNERS = 9, MOST_WORDS = 16 };

struct off {
    size_t vertices, faces;
    bool homogeneous, has_dimension, colours;
};

/* Copies what is before the next word, but for comments. */
static void to_word(struct numbering *work)
{
    while (work->at < work->end && (is_blank(*work->at) || is_line_end(*work->at) || *work->at == '#'))
        if (*work->at != '#')
            numbering_copy(work, 1);
        else
            while (work->at < work->end && !is_line_end(*work->at))
                numbering_skip(work, 1);
}

static bool copy_if(struct numbering *work, const char *text)
{
    const size_t length = strlen(text);
    if ((size_t)(work->end - work->at) < length || memcmp(work->at, text, length) != 0) return false;
    numbering_copy(work, length);
    return true;
}

static bool copy_count(struct numbering *work, size_t *count)
{
    char *end;
    to_word(work);
    if (work->at == work->end || *work->at < '0' || *work->at > '9')
        return error_set(work->err, "%s:%zu: no count where one must be", work->path, work->line);
    *count = strtoul(work->at, &end, 10);
    numbering_copy(work, (size_t)(end - work->at));
    return true;
}

static bool copy_head(struct numbering *work, struct off *off)
{
    size_t dimensions, edges;
    to_word(work);
    copy_if(work, "ST");
    off->colours = copy_if(work, "C");
    copy_if(work, "N");
    off->homogeneous = copy_if(work, "4");
    off->has_dimension = copy_if(work, "n");
    if (!copy_if(work, "OFF")) off->homogeneous = false;
    if (off->has_dimension) return copy_count(work, &dimensions);
    if (!copy_count(work, &off->vertices) || !copy_count(work, &off->faces) || !copy_count(work, &edges)) return false;
    to_word(work);
    return true;
}

/* The next line that is not empty and no comment: its length and words. */
static size_t next_line(struct numbering *work, struct word *words, size_t *length)
{
    for (;;) {
        while (work->at < work->end && (is_blank(*work->at) || is_line_end(*work->at)))
            numbering_skip(work, 1);
        for (*length = 0; work->at + *length < work->end && !is_line_end(work->at[*length]);)
            ++*length;
        const size_t count = words_of(work->at, work->at + *length, words, MOST_WORDS);
        if (count || work->at == work->end) return count;
        numbering_skip(work, *length);
    }
}

static bool number_vertex(struct numbering *work, const struct off *off)
{
    struct word words[MOST_WORDS];
    double point[3], divisor = 1;
    size_t length;
    const size_t count = next_line(work, words, &length), least = off->homogeneous ? 4 : 3;
    if (!count) return error_set(work->err, "%s:%zu: the file ends before its vertices", work->path, work->line);
    if (count < least || count > MOST_WORDS)
        return error_set(work->err, "%s:%zu: a vertex of %zu numbers", work->path, work->line, count);
    for (int i = 0; i < 3; i++)
        if (!numbering_parse(work, &words[i], &point[i])) return false;
    if (off->homogeneous && !numbering_parse(work, &words[3], &divisor)) return false;
    if (divisor == 0) return error_set(work->err, "%s:%zu: a vertex is divided by 0", work->path, work->line);
    for (int i = 0; off->homogeneous && i < 3; i++)
        point[i] /= divisor;
    if (!numbering_vertex(work, point)) return false;
    if (off->homogeneous) numbering_write(work, " 1", 2);
    for (size_t i = least; i < count; i++)
        numbering_word(work, &words[i]);
    numbering_write(work, "\n", 1);
    numbering_skip(work, length);
    return true;
}

static bool whole_number(struct numbering *work, const struct word *word, size_t end, size_t *out)
{
    char *stop;
    *out = strtoul(word->text, &stop, 10);
    if (stop == word->text + word->length && word->text[0] != '-' && *out < end) return true;
    return error_set(work->err, "%s:%zu: '%.*s' is no whole number below %zu", work->path, work->line,
                     word->length < 40 ? (int)word->length : 40, word->text, end);
}

static bool copy_face(struct numbering *work, const struct off *off)
{
    struct word words[MOST_WORDS];
    size_t length, corners, corner;
    const size_t count = next_line(work, words, &length);
    if (!count) return error_set(work->err, "%s:%zu: the file ends before its faces", work->path, work->line);
    if (!whole_number(work, &words[0], VERTEX_TABLE_MOST, &corners)) return false;
    if (corners < 1 || corners > LIBRARY_CORNERS)
        return error_set(work->err, "%s:%zu: a face of %zu corners; in OFF files it may have 1 to %d", work->path,
                         work->line, corners, LIBRARY_CORNERS);
    for (size_t i = 1; i <= corners; i++) {
        if (i >= count)
            return error_set(work->err, "%s:%zu: a face has fewer corners than it says", work->path, work->line);
        if (!whole_number(work, &words[i], off->vertices, &corner)) return false;
    }
    numbering_copy(work, length);
    numbering_write(work, "\n", 1);
    return true;
}

bool number_off(struct numbering *work)
{
    struct off off = {0};
    if (!copy_head(work, &off)) return false;
    if (off.has_dimension) return true;
    for (size_t i = 0; i < off.vertices; i++)
        if (!number_vertex(work, &off)) return false;
    for (size_t i = 0; i < off.faces; i++)
        if (!copy_face(work, &off)) return false;
    return true;
}
