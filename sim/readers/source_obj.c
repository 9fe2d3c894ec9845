/* SPDX-License-Identifier: MIT
 *
 * OBJ for the reference: `v` and `f` lines, all else is passed over. */
#include "readers/source.h"

#include "base/grow.h"
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

static bool add_vertex(struct vertices *vertices, const char *line)
{
    double numbers[7];
    size_t count = 0;
    char *rest;
    for (const char *at = line; count < 7; at = rest, count++) {
        at += strspn(at, " \t");
        if (!*at || *at == '#') break;
        numbers[count] = strtod(at, &rest);
        if (rest == at) return false;
    }
    if (count != 3 && count != 4 && count != 6) return false;
    vertices->at_m = grow(vertices->at_m, vertices->count, &vertices->capacity, sizeof *vertices->at_m);
    for (int axis = 0; axis < 3; axis++)
        vertices->at_m[vertices->count][axis] = count == 4 ? numbers[axis] / numbers[3] : numbers[axis];
    vertices->count++;
    return true;
}

/* Corners are v, v/vt, v//vn or v/vt/vn; from 1, or backwards from the last vertex. */
static bool add_face(struct source *source, const struct vertices *vertices, const char *line)
{
    for (const char *at = line + strspn(line, " \t"); *at && *at != '#'; at += strspn(at, " \t")) {
        char *rest;
        const long number = strtol(at, &rest, 10);
        const long index = number < 0 ? (long)vertices->count + number : number - 1;
        if (rest == at || index < 0 || (size_t)index >= vertices->count) return false;
        source_corner(source, vertices->at_m[index]);
        at += strcspn(at, " \t");
    }
    source_face(source);
    return true;
}

enum source_result source_obj_read(const char *path, struct source *source, struct error *err)
{
    struct vertices vertices = {0};
    struct whole_file file;
    if (!whole_file_read(path, &file, err)) return SOURCE_BAD;
    if (strlen(file.bytes) != file.size_b) {
        whole_file_free(&file);
        return SOURCE_UNKNOWN;
    }
    join_continued_lines(file.bytes);
    bool ok = true;
    char *line = file.bytes, *next;
    for (size_t number = 1; ok && *line; line = next, number++) {
        next = line + strcspn(line, "\r\n");
        if (*next) *next++ = '\0';
        line += strspn(line, " \t\xEF\xBB\xBF");
        if (line[0] == 'v' && isblank((unsigned char)line[1])) ok = add_vertex(&vertices, line + 1);
        if (line[0] == 'f') ok = add_face(source, &vertices, line + strcspn(line, " \t"));
        if (!ok) error_set(err, "%s: the reference's reader does not understand '%.60s'", path, line);
    }
    free(vertices.at_m);
    whole_file_free(&file);
    return ok ? SOURCE_READ : SOURCE_BAD;
}
