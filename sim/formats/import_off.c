/* SPDX-License-Identifier: MIT
 *
 * OFF: a line a vertex, then a line a face. The first word says what lines of vertices have behind the coordinates:
 * [ST][C][N][4][n]OFF, the first three in any order, a divisor (4), a normal (N), a colour (C), a place in a picture
 * (ST, of which no file is named). Behind a face's corners may come a colour: three or four numbers, or one number of a
 * map that is not part of the file. Colours are whole numbers up to 255, or up to 1 where they have points. Source: the
 * manual of Geomview. */
#include "formats/own_formats.h"

#include "base/grow.h"
#include "files/text_lines.h"
#include "files/whole_file.h"
#include "formats/model_limits.h"
#include "model/note_words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct off {
    struct text text;
    struct model_build *build;
    size_t vertices, faces;
    bool has_divisor, has_dimension, has_normals, has_colours, has_places;
    double (*colours)[4]; /* of each vertex, if there are */
    size_t colour_capacity;
    size_t mapped;  /* faces with a number of a map */
    bool has_point; /* some number of a colour has */
};

static bool fail_at_line(const struct off *off, const char *what)
{
    return error_set(off->text.err, "%s:%zu: %s", off->text.path, off->text.line, what);
}

static bool whole_number(const struct off *off, const struct word *word, size_t end, size_t *out)
{
    enum { SHOWN = 40 };
    char *stop;
    *out = strtoul(word->text, &stop, 10);
    if (stop == word->text + word->length && word->text[0] != '-' && *out < end) return true;
    return error_set(off->text.err, "%s:%zu: '%.*s' is no whole number below %zu", off->text.path, off->text.line,
                     word->length < SHOWN ? (int)word->length : SHOWN, word->text, end);
}

/* The head --------------------------------------------------------------------------------------------------------- */

static bool takes(struct word *word, const char *prefix)
{
    const size_t length = strlen(prefix);
    if (word->length < length || memcmp(word->text, prefix, length) != 0) return false;
    word->text += length;
    word->length -= length;
    return true;
}

/* false: the word is none of these, but the first number, as the word may be left out. What follows it without a blank
 * is left of `found`. */
static bool read_keyword(struct off *off, struct word *found)
{
    struct word word = *found;
    for (const char *at = NULL; at != word.text;) { /* MeshLab has CSTOFF for STCOFF */
        at = word.text;
        off->has_places |= takes(&word, "ST");
        off->has_colours |= takes(&word, "C");
        off->has_normals |= takes(&word, "N");
    }
    off->has_divisor = takes(&word, "4");
    off->has_dimension = takes(&word, "n");
    if (!takes(&word, "OFF") || (word.length && (word.text[0] < '0' || word.text[0] > '9'))) return false;
    *found = word;
    return true;
}

static bool read_dimension(struct off *off)
{
    struct word word;
    size_t dimensions;
    if (!off->has_dimension) return true;
    if (!text_any_word(&off->text, &word)) return fail_at_line(off, "the file ends within its head");
    if (!whole_number(off, &word, SIZE_MAX, &dimensions)) return false;
    return dimensions == 3 || error_set(off->text.err, "%s:%zu: vertices of %zu dimensions; those of 3 can be drawn",
                                        off->text.path, off->text.line, dimensions);
}

/* The number of edges, behind these two, means nothing, and may be missing. */
static bool read_counts(struct off *off, struct word word)
{
    if (!whole_number(off, &word, MOST_CORNERS, &off->vertices)) return false;
    if (!text_any_word(&off->text, &word)) return fail_at_line(off, "the file ends within its head");
    return whole_number(off, &word, MOST_CORNERS, &off->faces);
}

static bool read_head(struct off *off)
{
    struct word word;
    if (!text_any_word(&off->text, &word)) return fail_at_line(off, "there is nothing in it");
    if (!read_keyword(off, &word)) {
        off->has_places = off->has_colours = off->has_normals = off->has_divisor = off->has_dimension = false;
        return read_counts(off, word);
    }
    if (!read_dimension(off)) return false;
    if (!word.length && !text_any_word(&off->text, &word)) return fail_at_line(off, "the file ends within its head");
    if (word_is(&word, "binary")) return fail_at_line(off, WORDS_OFF_OF_BYTES);
    return read_counts(off, word);
}

/* Colours ---------------------------------------------------------------------------------------------------------- */

/* As many numbers as there are, four at most. */
static bool read_rgba(struct off *off, size_t count, double rgba[4])
{
    struct word word;
    rgba[3] = NAN;
    for (size_t i = 0; i < count && i < 4 && text_word(&off->text, &word); i++) {
        for (size_t k = 0; k < word.length; k++)
            off->has_point |= word.text[k] == '.';
        if (!text_number(&off->text, &word, &rgba[i])) return false;
    }
    return true;
}

/* Vertices --------------------------------------------------------------------------------------------------------- */

static bool read_point(struct off *off, double at_m[3])
{
    double number[4] = {0, 0, 0, 1};
    struct word word;
    for (int i = 0; i < (off->has_divisor ? 4 : 3); i++) {
        if (!text_word(&off->text, &word)) return fail_at_line(off, "a vertex has fewer numbers than its head says");
        if (!text_number(&off->text, &word, &number[i])) return false;
    }
    if (number[3] == 0) return fail_at_line(off, "a vertex is divided by 0");
    for (int axis = 0; axis < 3; axis++)
        at_m[axis] = number[axis] / number[3];
    return true;
}

static bool read_vertex(struct off *off, size_t number)
{
    double at_m[3];
    struct word word;
    if (!text_next_line(&off->text)) return fail_at_line(off, "the file ends before its vertices");
    if (!read_point(off, at_m) || !build_vertex(off->build, at_m, false)) return false;
    for (int i = 0; off->has_normals && i < 3; i++)
        text_word(&off->text, &word);
    if (!off->has_colours) return true;
    const size_t places = off->has_places ? 2 : 0, left = text_words_left(&off->text);
    if (left < places + 3) return fail_at_line(off, "a vertex has fewer numbers than its head says");
    off->colours = grow(off->colours, number, &off->colour_capacity, sizeof *off->colours);
    return read_rgba(off, left - places, off->colours[number]);
}

/* Faces ------------------------------------------------------------------------------------------------------------ */

static bool read_corners(struct off *off, size_t corners, struct build_look *look)
{
    for (size_t i = 0; i < corners; i++) {
        struct word word;
        size_t corner;
        if (!text_word(&off->text, &word)) return fail_at_line(off, "a face has fewer corners than it says");
        if (!whole_number(off, &word, off->vertices, &corner)) return false;
        if (!build_corner(off->build, (double)corner, NULL)) return false;
        if (off->has_colours) mean_colour_add(&look->colour, off->colours[corner]);
    }
    return true;
}

static bool read_face(struct off *off)
{
    struct build_look look = {.two_sided = true};
    double rgba[4];
    struct word word;
    size_t corners;
    if (!text_next_line(&off->text)) return fail_at_line(off, "the file ends before its faces");
    if (!text_word(&off->text, &word) || !whole_number(off, &word, MOST_CORNERS, &corners)) return false;
    if (!read_corners(off, corners, &look)) return false;
    const size_t left = text_words_left(&off->text);
    if (left >= 3) {
        if (!read_rgba(off, left, rgba)) return false;
        look.colour = (struct mean_colour){.count = 0};
        mean_colour_add(&look.colour, rgba);
    }
    off->mapped += left == 1;
    return build_face(off->build, &look);
}

static bool read_lines(struct off *off)
{
    if (!read_head(off)) return false;
    off->text.at = off->text.line_end;
    build_vertices_begin(off->build);
    for (size_t i = 0; i < off->vertices; i++)
        if (!read_vertex(off, i)) return false;
    for (size_t i = 0; i < off->faces; i++)
        if (!read_face(off)) return false;
    return true;
}

bool import_off(struct model_build *build)
{
    struct whole_file file;
    struct off off = {.build = build};
    if (!whole_file_read(build->path, &file, build->err)) return false;
    const bool ok = text_begin(&off.text, build->path, file.bytes, file.size_b, build->err) && read_lines(&off);
    if (!off.has_point) build->full_colour = 255;
    if (off.mapped)
        model_note(build->model, "%zu faces have a number of a colour map, which is not in the file: drawn without it",
                   off.mapped);
    free(off.colours);
    whole_file_free(&file);
    return ok;
}
