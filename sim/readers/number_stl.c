/* SPDX-License-Identifier: MIT
 *
 * STL as text: words, of which `vertex` is followed by three numbers. Names of solids are left as they are, with all
 * that is on their line. Binary files have float32, which need no stand-ins. */
#include "readers/numbering.h"

#include <stdint.h>
#include <string.h>

/* As the library tells them apart. */
static bool is_binary(const struct numbering *work)
{
    enum { HEAD_B = 84, COUNT_AT_B = 80, FACET_B = 50 };
    const size_t size_b = (size_t)(work->end - work->at);
    uint32_t facets;
    if (size_b < HEAD_B) return false;
    memcpy(&facets, work->at + COUNT_AT_B, sizeof facets);
    return (uint32_t)(facets * FACET_B + HEAD_B) == size_b;
}

static bool is(const struct word *word, const char *text)
{
    return word->length == strlen(text) && memcmp(word->text, text, word->length) == 0;
}

static struct word next_word(struct numbering *work)
{
    while (work->at < work->end && (is_blank(*work->at) || is_line_end(*work->at)))
        numbering_copy(work, 1);
    const char *first = work->at;
    while (work->at < work->end && !is_blank(*work->at) && !is_line_end(*work->at))
        work->at++;
    return (struct word){first, (size_t)(work->at - first)};
}

static void copy_line(struct numbering *work)
{
    size_t length = 0;
    while (work->at + length < work->end && !is_line_end(work->at[length]))
        length++;
    numbering_copy(work, length);
}

static struct word skip_to_word(struct numbering *work)
{
    while (work->at < work->end && (is_blank(*work->at) || is_line_end(*work->at)))
        numbering_skip(work, 1);
    return next_word(work);
}

static bool number_vertex(struct numbering *work)
{
    double point[3];
    for (int i = 0; i < 3; i++) {
        const struct word word = skip_to_word(work);
        if (!word.length) return error_set(work->err, "%s:%zu: the file ends in a vertex", work->path, work->line);
        if (!numbering_parse(work, &word, &point[i])) return false;
    }
    numbering_write(work, " ", 1);
    return numbering_vertex(work, point);
}

bool number_stl(struct numbering *work)
{
    if (is_binary(work)) return true;
    for (;;) {
        const struct word word = next_word(work);
        if (!word.length) return true;
        numbering_write(work, word.text, word.length);
        if (is(&word, "solid") || is(&word, "endsolid"))
            copy_line(work);
        else if (is(&word, "vertex") && !number_vertex(work))
            return false;
    }
}
