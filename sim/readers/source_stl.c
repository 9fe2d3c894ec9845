/* SPDX-License-Identifier: MIT
 *
 * STL for the reference: float32 triangles behind a head, or words. */
#include "readers/source.h"

#include "files/whole_file.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { HEAD_B = 84, FACET_B = 50, NORMAL_B = 12, CORNERS = 3 };

static uint32_t little_endian(const unsigned char *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static double float_at(const unsigned char *at)
{
    const uint32_t bits = little_endian(at);
    float number;
    memcpy(&number, &bits, sizeof number);
    return (double)number;
}

static void read_binary(const unsigned char *bytes, size_t facets, struct source *source)
{
    for (size_t i = 0; i < facets; i++) {
        const unsigned char *at = bytes + HEAD_B + i * FACET_B + NORMAL_B;
        for (int k = 0; k < CORNERS; k++, at += 12)
            source_corner(source, (const double[3]){float_at(at), float_at(at + 4), float_at(at + 8)});
        source_face(source);
    }
}

/* Three numbers behind `vertex`. */
static const char *read_vertex(const char *at, struct source *source)
{
    double corner[3];
    for (int axis = 0; axis < 3; axis++) {
        char *rest;
        corner[axis] = strtod(at, &rest);
        if (rest == at) return NULL;
        at = rest;
    }
    source_corner(source, corner);
    return at;
}

static bool is(const char *word, size_t length, const char *name)
{
    return length == strlen(name) && strncasecmp(word, name, length) == 0;
}

static bool read_text(const char *at, struct source *source)
{
    static const char SPACE[] = " \t\r\n\f\v";
    while (at && *(at += strspn(at, SPACE))) {
        const char *word = at;
        const size_t length = strcspn(at, SPACE);
        at += length;
        if (is(word, length, "vertex")) at = read_vertex(at, source);
        if (is(word, length, "endloop")) source_face(source);
        if (is(word, length, "solid") || is(word, length, "endsolid")) at += strcspn(at, "\r\n");
    }
    return at != NULL;
}

enum source_result source_stl_read(const char *path, struct source *source, struct error *err)
{
    struct whole_file file;
    if (!whole_file_read(path, &file, err)) return SOURCE_BAD;
    const unsigned char *bytes = (const unsigned char *)file.bytes;
    const size_t facets = file.size_b < HEAD_B ? 0 : little_endian(bytes + HEAD_B - 4);
    const bool has_room = file.size_b >= HEAD_B + facets * FACET_B && facets > 0;
    const bool is_binary = has_room && (file.size_b == HEAD_B + facets * FACET_B || memchr(bytes, 0, HEAD_B));
    bool ok = true;
    if (is_binary)
        read_binary(bytes, facets, source);
    else
        ok = read_text(file.bytes, source) || error_set(err, "%s: a vertex has no three numbers", path);
    whole_file_free(&file);
    return ok ? SOURCE_READ : SOURCE_BAD;
}
