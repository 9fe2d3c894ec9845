/* SPDX-License-Identifier: MIT
 *
 * PLY for the reference: the numbers of all elements one after the other, as words or bytes. */
#include "readers/source.h"

#include "base/grow.h"
#include "files/whole_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_B = 32, LEVELS = 64 };

struct stream {
    const char *at, *end;
    enum { WORDS, LITTLE_ENDIAN_BYTES, BIG_ENDIAN_BYTES } kind;
    bool failed;
};

struct vertices {
    double (*at_m)[3];
    size_t count, capacity;
};

/* A line `property ...` or `element ...`, with what the elements' instances take. */
struct line {
    char words[5][NAME_B];
    int count;
};

static size_t width_of(const char *type)
{
    static const char *const names[] = {"char",  "uchar",   "int8",   "uint8",   "short",   "ushort",
                                        "int16", "uint16",  "int",    "uint",    "int32",   "uint32",
                                        "float", "float32", "double", "float64", "double64"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(type, names[i]) == 0) return i < 4 ? 1 : i < 8 ? 2 : i < 14 ? 4 : 8;
    return 0;
}

static double whole_from(uint64_t bits, size_t width, bool is_signed)
{
    const uint64_t sign = UINT64_C(1) << (8 * width - 1);
    return is_signed && (bits & sign) ? (double)bits - 2.0 * (double)sign : (double)bits;
}

static double number_from(uint64_t bits, size_t width, const char *type)
{
    if (strncmp(type, "float", 5) && strncmp(type, "double", 6)) return whole_from(bits, width, type[0] != 'u');
    if (width == 8) {
        double number;
        memcpy(&number, &bits, sizeof number);
        return number;
    }
    const uint32_t half = (uint32_t)bits;
    float number;
    memcpy(&number, &half, sizeof number);
    return (double)number;
}

static double next_number(struct stream *stream, const char *type)
{
    const size_t width = width_of(type);
    if (stream->kind == WORDS) {
        char *rest;
        const double number = strtod(stream->at, &rest);
        stream->failed |= rest == stream->at;
        stream->at = rest;
        return number;
    }
    stream->failed |= !width || (size_t)(stream->end - stream->at) < width;
    if (stream->failed) return 0;
    uint64_t bits = 0;
    for (size_t i = 0; i < width; i++) {
        const size_t place = stream->kind == LITTLE_ENDIAN_BYTES ? i : width - 1 - i;
        bits |= (uint64_t)(unsigned char)stream->at[i] << 8 * place;
    }
    stream->at += width;
    return number_from(bits, width, type);
}

static bool is_corners(const struct line *property)
{
    return strcmp(property->words[4], "vertex_index") == 0 || strcmp(property->words[4], "vertex_indices") == 0;
}

/* What an element is to the reader. */
enum element_kind { OTHER_ELEMENT, VERTEX_ELEMENT, FACE_ELEMENT, STRIPS_ELEMENT };

static enum element_kind kind_of(const struct line *element)
{
    const char *name = element->words[1];
    return strcmp(name, "vertex") == 0      ? VERTEX_ELEMENT
           : strcmp(name, "face") == 0      ? FACE_ELEMENT
           : strcmp(name, "tristrips") == 0 ? STRIPS_ELEMENT
                                            : OTHER_ELEMENT;
}

static void add_corner(struct stream *stream, double index, const struct vertices *vertices, struct source *source)
{
    stream->failed |= !(index >= 0 && index < (double)vertices->count);
    if (!stream->failed) source_corner(source, vertices->at_m[(size_t)index]);
}

/* The last three indices of a strip; every other triangle runs the other way. */
struct strip {
    double corner[3];
    size_t length;
};

static void next_of_strip(struct strip *strip, double index, struct stream *stream, const struct vertices *vertices,
                          struct source *source)
{
    double *corner = strip->corner;
    corner[0] = corner[1], corner[1] = corner[2], corner[2] = index;
    strip->length = index == -1 ? 0 : strip->length + 1;
    if (strip->length < 3 || corner[0] == corner[1] || corner[1] == corner[2] || corner[0] == corner[2]) return;
    const bool other = strip->length % 2 == 0;
    add_corner(stream, corner[other ? 1 : 0], vertices, source);
    add_corner(stream, corner[other ? 0 : 1], vertices, source);
    add_corner(stream, corner[2], vertices, source);
    source_face(source);
}

static void next_list(struct stream *stream, const struct line *property, enum element_kind kind,
                      const struct vertices *vertices, struct source *source)
{
    const double length = next_number(stream, property->words[2]);
    struct strip strip = {.length = 0};
    for (double i = 0; i < length && !stream->failed; i++) {
        const double index = next_number(stream, property->words[3]);
        if (!source || !is_corners(property)) continue;
        if (kind == FACE_ELEMENT) add_corner(stream, index, vertices, source);
        if (kind == STRIPS_ELEMENT) next_of_strip(&strip, index, stream, vertices, source);
    }
}

/* Without a source it keeps the vertices, with one it makes faces of those that were kept. */
static void next_instance(struct stream *stream, const struct line *element, size_t properties,
                          struct vertices *vertices, struct source *source)
{
    const enum element_kind kind = kind_of(element);
    double at_m[3] = {0};
    for (const struct line *property = element + 1; property <= element + properties; property++) {
        if (strcmp(property->words[1], "list") == 0) {
            next_list(stream, property, kind, vertices, source);
            continue;
        }
        const double number = next_number(stream, property->words[1]);
        const char *name = property->words[2];
        if (name[0] >= 'x' && name[0] <= 'z' && !name[1]) at_m[name[0] - 'x'] = number;
    }
    if (source) source_face(source);
    if (source || kind != VERTEX_ELEMENT) return;
    vertices->at_m = grow(vertices->at_m, vertices->count, &vertices->capacity, sizeof *vertices->at_m);
    memcpy(vertices->at_m[vertices->count++], at_m, sizeof at_m);
}

static void read_elements(struct stream *stream, const struct line *lines, size_t count, struct vertices *vertices,
                          struct source *source)
{
    for (size_t i = 0; i < count; i++) {
        size_t properties = 0;
        if (strcmp(lines[i].words[0], "element") != 0) continue;
        while (i + properties + 1 < count && strcmp(lines[i + properties + 1].words[0], "property") == 0)
            properties++;
        const unsigned long instances = strtoul(lines[i].words[2], NULL, 10);
        for (unsigned long k = 0; properties && k < instances && !stream->failed; k++)
            next_instance(stream, &lines[i], properties, vertices, source);
    }
}

/* Twice: faces may come before their vertices. */
static bool read_body(struct stream *stream, const struct line *lines, size_t count, struct source *source)
{
    struct vertices vertices = {0};
    struct stream again = *stream;
    read_elements(stream, lines, count, &vertices, NULL);
    if (!stream->failed) read_elements(&again, lines, count, &vertices, source);
    free(vertices.at_m);
    return !stream->failed && !again.failed;
}

/* Keeps the lines on elements and properties; the body begins at stream->at. false: this is not understood. */
static bool read_header(struct stream *stream, struct line *lines, size_t *count)
{
    bool has_kind = false;
    while (stream->at < stream->end) {
        struct line line = {.count = 0};
        const size_t length = strcspn(stream->at, "\r\n");
        char text[6 * NAME_B] = "";
        memcpy(text, stream->at, length < sizeof text ? length : sizeof text - 1);
        line.count = sscanf(text, "%31s %31s %31s %31s %31s", line.words[0], line.words[1], line.words[2],
                            line.words[3], line.words[4]);
        stream->at += length;
        if (stream->at < stream->end) stream->at += stream->at[0] == '\r' && stream->at[1] == '\n' ? 2 : 1;
        if (strcmp(line.words[0], "end_header") == 0) return has_kind;
        if (strcmp(line.words[0], "format") == 0) {
            has_kind = true;
            stream->kind = strcmp(line.words[1], "ascii") == 0               ? WORDS
                           : strcmp(line.words[1], "binary_big_endian") == 0 ? BIG_ENDIAN_BYTES
                                                                             : LITTLE_ENDIAN_BYTES;
        }
        if (strcmp(line.words[0], "element") != 0 && strcmp(line.words[0], "property") != 0) continue;
        if (*count == LEVELS) return false;
        lines[(*count)++] = line;
    }
    return false;
}

enum source_result source_ply_read(const char *path, struct source *source, struct error *err)
{
    struct line lines[LEVELS];
    struct whole_file file;
    size_t count = 0;
    if (!whole_file_read(path, &file, err)) return SOURCE_BAD;
    struct stream stream = {file.bytes, file.bytes + file.size_b, WORDS, false};
    enum source_result result = SOURCE_UNKNOWN;
    if (read_header(&stream, lines, &count)) {
        result = read_body(&stream, lines, count, source) ? SOURCE_READ : SOURCE_BAD;
        if (result == SOURCE_BAD) error_set(err, "%s: the reference's reader finds damage in it", path);
    }
    whole_file_free(&file);
    return result;
}
