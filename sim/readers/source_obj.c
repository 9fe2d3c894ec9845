/* SPDX-License-Identifier: MIT
 *
 * OBJ for the reference: `v` and `f` lines, all else is passed over. */
#include "readers/source.h"

#include "base/grow.h"
#include "files/utf16.h"
#include "files/whole_file.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

struct vertices {
    double (*at_m)[3];
    size_t count, capacity;
};

/* Takes out each backslash at a line's end, with that end. */
static void join_continued_lines(char *text)
{
    char *to = text;
    for (const char *from = text; *from;) {
        const size_t end = from[0] == '\\' ? strspn(from + 1, "\r\n") : 0;
        if (end)
            from += 1 + (from[1] == '\r' && from[2] == '\n' ? 2 : 1);
        else
            *to++ = *from++;
    }
    *to = '\0';
}

/* Three numbers, then perhaps a weight, or a colour with or without an alpha: these say nothing of where it is. */
static bool add_vertex(struct vertices *vertices, const char *line)
{
    double numbers[8];
    size_t count = 0;
    char *rest;
    for (const char *at = line; count < 8; at = rest, count++) {
        at += strspn(at, " \t");
        if (!*at) break;
        numbers[count] = strtod(at, &rest);
        if (rest == at) return false;
    }
    if (count != 3 && count != 4 && count != 6 && count != 7) return false;
    vertices->at_m = grow(vertices->at_m, vertices->count, &vertices->capacity, sizeof *vertices->at_m);
    memcpy(vertices->at_m[vertices->count++], numbers, sizeof *vertices->at_m);
    return true;
}

/* Corners are v, v/vt, v//vn or v/vt/vn; from 1, or backwards from the last of the vertices that stand before. */
static bool add_face(struct source *source, const struct vertices *vertices, size_t before, const char *line)
{
    for (const char *at = line + strspn(line, " \t"); *at; at += strspn(at, " \t")) {
        char *rest;
        const long number = strtol(at, &rest, 10);
        const long index = number < 0 ? (long)before + number : number - 1;
        if (rest == at || index < 0 || (size_t)index >= vertices->count) return false;
        source_corner(source, vertices->at_m[index]);
        at += strcspn(at, " \t");
    }
    source_face(source);
    return true;
}

/* Cuts a line off the text, blanks for its comment, and none before it; the next one begins at *text. */
static char *cut_line(char **text)
{
    char *line = *text, *end = line + strcspn(line, "\r\n"), *comment = line + strcspn(line, "#\r\n");
    *text = end + (*end != '\0');
    memset(comment, ' ', (size_t)(end - comment));
    *end = '\0';
    return line + strspn(line, " \t\xEF\xBB\xBF");
}

static bool is_statement(const char *line, const char *word)
{
    const size_t length = strlen(word);
    return strncmp(line, word, length) == 0 && isblank((unsigned char)line[length]);
}

/* Faces may name vertices that come later, so lines are gone through twice, each a string of its own after that. */
static bool read_lines(char *text, const char *end, struct vertices *vertices, struct source *source, struct error *err)
{
    size_t before = 0;
    bool ok = true;
    for (char *at = text; ok && at < end;) {
        const char *line = cut_line(&at);
        if (is_statement(line, "v")) ok = add_vertex(vertices, line + 1);
        if (!ok) error_set(err, "the reference's reader does not understand '%.60s'", line);
    }
    for (char *at = text; ok && at < end; at += strlen(at) + 1) {
        const char *line = at + strspn(at, " \t\xEF\xBB\xBF");
        before += is_statement(line, "v");
        if (is_statement(line, "f") || is_statement(line, "fo"))
            ok = add_face(source, vertices, before, line + strcspn(line, " \t"));
        if (!ok) error_set(err, "the reference's reader does not understand '%.60s'", line);
    }
    return ok;
}

enum source_result source_obj_read(const char *path, struct source *source, struct error *err)
{
    struct vertices vertices = {0};
    struct whole_file file;
    if (!whole_file_read(path, &file, err)) return SOURCE_BAD;
    utf8_from_utf16(&file);
    if (strlen(file.bytes) != file.size_b) {
        whole_file_free(&file);
        return SOURCE_UNKNOWN;
    }
    join_continued_lines(file.bytes);
    const bool ok = read_lines(file.bytes, file.bytes + strlen(file.bytes), &vertices, source, err);
    if (!ok) error_prefix(err, path);
    free(vertices.at_m);
    whole_file_free(&file);
    return ok ? SOURCE_READ : SOURCE_BAD;
}
