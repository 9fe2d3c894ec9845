/* SPDX-License-Identifier: MIT
 *
 * A number is known before it is written wherever it can be: as a fraction of a power of two with all of its digits, or
 * by 17 digits, which lead back to one double only. Where digits come first, strtod() says what they are. */
#include "fuzz_writer.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const blanks[] = {" ", "  ", "\t", " \t"};
static const char *const line_ends[] = {"\n", "\r\n", "\n\n", " \n"};

enum { BLANKS = sizeof blanks / sizeof *blanks, LINE_ENDS = sizeof line_ends / sizeof *line_ends };

const char *written_name(enum written_format format)
{
    static const char *const names[WRITTEN_FORMATS] = {
        [WRITTEN_OBJ] = "model.obj", [WRITTEN_PLY] = "model.ply",   [WRITTEN_STL] = "model.stl",
        [WRITTEN_OFF] = "model.off", [WRITTEN_GLTF] = "model.gltf", [WRITTEN_GLB] = "model.glb"};
    return names[format];
}

void written_put_bytes(struct written *written, const void *bytes, size_t size_b)
{
    if (size_b > WRITTEN_MAX_B - written->size_b) abort(); /* the bounds above are too small */
    if (size_b) memcpy(written->file + written->size_b, bytes, size_b);
    written->size_b += size_b;
}

void written_put(struct written *written, const char *format, ...)
{
    char text[512];
    va_list values;

    va_start(values, format);
    const int length = vsnprintf(text, sizeof text, format, values);
    va_end(values);
    if (length < 0 || (size_t)length >= sizeof text) abort();
    written_put_bytes(written, text, (size_t)length);
}

void written_put_whole(struct written *written, uint64_t whole, size_t size_b, bool big_endian)
{
    uint8_t bytes[8];

    for (size_t i = 0; i < size_b; i++)
        bytes[big_endian ? size_b - 1 - i : i] = (uint8_t)(whole >> 8 * i);
    written_put_bytes(written, bytes, size_b);
}

/* Numbers ------------------------------------------------------------------------------------ */

static double put_digits(struct written *written, struct fuzz_bytes *bytes)
{
    static const char *const signs[] = {"", "-", "+", ""};
    const unsigned before = fuzz_below(bytes, 12), behind = fuzz_below(bytes, 18) + (before ? 0u : 1u);
    char text[64];
    size_t length = (size_t)snprintf(text, sizeof text, "%s", signs[fuzz_below(bytes, 4)]);

    for (unsigned i = 0; i < before + behind; i++) {
        if (i == before) text[length++] = '.';
        text[length++] = (char)('0' + fuzz_below(bytes, 10));
    }
    text[length] = '\0';
    const uint8_t power = fuzz_below(bytes, 26);
    if (power)
        snprintf(text + length, sizeof text - length, "%c%s%d", power & 1 ? 'e' : 'E', power & 2 ? "+" : "-", power);
    written_put(written, "%s", text);
    return strtod(text, NULL);
}

double written_put_json(struct written *written, double value)
{
    written_put(written, "%.17g", value);
    return value;
}

static double any_double(struct fuzz_bytes *bytes)
{
    const double head = (int32_t)fuzz_u32(bytes), tail = fuzz_u32(bytes) / 4294967296.0;

    return ldexp(head + tail, fuzz_below(bytes, 81) - 60);
}

double written_put_decimal(struct written *written, struct fuzz_bytes *bytes)
{
    switch (fuzz_below(bytes, 4)) {
    case 0: {
        const int whole = (int8_t)fuzz_u8(bytes);
        written_put(written, "%d", whole);
        return whole;
    }
    case 1: {
        const double fraction = (int32_t)fuzz_u32(bytes) / 1024.0;
        written_put(written, "%.10f", fraction);
        return fraction;
    }
    case 2:
        return written_put_json(written, any_double(bytes));
    default:
        return put_digits(written, bytes);
    }
}

/* OBJ ---------------------------------------------------------------------------------------- */

enum { OBJ_PLAIN, OBJ_WEIGHTED, OBJ_COLOURED, OBJ_KINDS };

static void obj_blank(struct written *written, struct fuzz_bytes *bytes)
{
    const uint8_t choice = fuzz_below(bytes, 32);

    written_put(written, "%s", blanks[choice % BLANKS]);
    if (choice == 31) written_put(written, "\\\n");
    if (choice == 30) written_put(written, "\\\r\n");
}

static void obj_vertex(struct written *written, size_t index, unsigned kind, struct fuzz_bytes *bytes)
{
    double *vertex = written->vertices[index];

    written_put(written, "%sv", fuzz_below(bytes, 8) ? "" : " ");
    for (int axis = 0; axis < 3; axis++) {
        obj_blank(written, bytes);
        vertex[axis] = written_put_decimal(written, bytes);
    }
    if (kind == OBJ_WEIGHTED) written_put(written, " %d", 1 + fuzz_below(bytes, 9)); /* polygons have none */
    if (kind == OBJ_COLOURED) written_put(written, " 0.25 .5 1");
    if (!fuzz_below(bytes, 8)) written_put(written, " # 7 8 9");
    written_put(written, "%s", line_ends[fuzz_below(bytes, LINE_ENDS)]);
}

static void write_obj(struct written *written, struct fuzz_bytes *bytes)
{
    static const char *const behind[] = {"", "/1", "//1", "/1/1"};
    const unsigned kind = fuzz_below(bytes, OBJ_KINDS), form = fuzz_below(bytes, 4), flags = fuzz_u8(bytes);

    if (flags & 1) written_put(written, "# a comment\no thing\n");
    for (size_t i = 0; i < written->vertex_count; i++)
        obj_vertex(written, i, kind, bytes);
    if (form) written_put(written, "vt .5 0.25\nvn 0 1 0\n");
    for (size_t i = 0; i < written->face_count; i++) {
        if (flags & 2) written_put(written, "g part%zu\n", i % 2);
        written_put(written, "f");
        for (size_t k = 0; k < written->faces[i].count; k++) {
            const long index = (long)written->faces[i].vertices[k];
            written_put(written, "%s", blanks[fuzz_below(bytes, BLANKS)]);
            written_put(written, "%ld%s", flags & 4 ? index - (long)written->vertex_count : index + 1, behind[form]);
        }
        written_put(written, "%s", line_ends[fuzz_below(bytes, LINE_ENDS)]);
    }
}

/* PLY ---------------------------------------------------------------------------------------- */

enum { PLY_TEXT, PLY_LITTLE, PLY_BIG, PLY_CODINGS };

struct ply_type {
    const char *name, *other_name;
    size_t size_b;
};

static const struct ply_type ply_types[] = {{"float", "float32", 4}, {"double", "float64", 8}, {"int", "int32", 4},
                                            {"uint", "uint32", 4},   {"short", "int16", 2},    {"ushort", "uint16", 2},
                                            {"char", "int8", 1},     {"uchar", "uint8", 1}};

enum { PLY_FLOAT, PLY_DOUBLE, PLY_INT, PLY_UINT, PLY_SHORT, PLY_USHORT, PLY_CHAR, PLY_UCHAR, PLY_TYPES };

struct ply_ways {
    unsigned coding, vertex, length, index; /* types of what they are called after */
    bool coloured, colour_first, edges, other_names;
};

static double ply_number(struct written *written, const struct ply_ways *ways, struct fuzz_bytes *bytes)
{
    const size_t size_b = ply_types[ways->vertex].size_b;
    const bool big = ways->coding == PLY_BIG;
    uint64_t bits = fuzz_u32(bytes);

    if (ways->vertex == PLY_FLOAT) {
        const float number = (float)any_double(bytes);
        uint32_t word;
        memcpy(&word, &number, sizeof word);
        written_put_whole(written, word, size_b, big);
        return (double)number;
    }
    if (ways->vertex == PLY_DOUBLE) {
        const double number = any_double(bytes);
        memcpy(&bits, &number, sizeof bits);
        written_put_whole(written, bits, size_b, big);
        return number;
    }
    bits &= (UINT64_C(1) << 8 * size_b) - 1;
    written_put_whole(written, bits, size_b, big);
    const double whole = (double)bits, most = ldexp(1, (int)(8 * size_b));
    const bool has_sign = ways->vertex == PLY_INT || ways->vertex == PLY_SHORT || ways->vertex == PLY_CHAR;
    return has_sign && whole >= most / 2 ? whole - most : whole;
}

static void ply_colour(struct written *written, const struct ply_ways *ways)
{
    if (ways->coding == PLY_TEXT)
        written_put(written, " 10 200 30 ");
    else
        written_put_bytes(written, "\x0A\xC8\x1E", 3);
}

static void ply_vertex(struct written *written, double vertex[3], const struct ply_ways *ways, struct fuzz_bytes *bytes)
{
    if (ways->coloured && ways->colour_first) ply_colour(written, ways);
    for (int axis = 0; axis < 3; axis++) {
        if (ways->coding == PLY_TEXT) {
            if (axis) written_put(written, "%s", blanks[fuzz_below(bytes, BLANKS)]);
            vertex[axis] = written_put_decimal(written, bytes);
        } else {
            vertex[axis] = ply_number(written, ways, bytes);
        }
    }
    if (ways->coloured && !ways->colour_first) ply_colour(written, ways);
    if (ways->coding == PLY_TEXT) written_put(written, "\n");
}

static void ply_header(struct written *written, const struct ply_ways *ways)
{
    static const char *const codings[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    static const char colours[] = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    const struct ply_type *type = &ply_types[ways->vertex];
    const char *name = ways->other_names ? type->other_name : type->name;

    written_put(written, "ply\nformat %s 1.0\ncomment none\nelement vertex %zu\n", codings[ways->coding],
                written->vertex_count);
    if (ways->coloured && ways->colour_first) written_put(written, colours);
    written_put(written, "property %s x\nproperty %s y\nproperty %s z\n", name, name, name);
    if (ways->coloured && !ways->colour_first) written_put(written, colours);
    written_put(written, "element face %zu\nproperty list %s %s vertex_ind%s\n", written->face_count,
                ply_types[ways->length].name, ply_types[ways->index].name, ways->other_names ? "ices" : "ex");
    if (ways->edges) written_put(written, "element edge 1\nproperty int vertex1\nproperty int vertex2\n");
    written_put(written, "end_header\n");
}

static void ply_whole(struct written *written, const struct ply_ways *ways, unsigned type, size_t value)
{
    if (ways->coding == PLY_TEXT)
        written_put(written, "%zu ", value);
    else
        written_put_whole(written, value, ply_types[type].size_b, ways->coding == PLY_BIG);
}

static void write_ply(struct written *written, struct fuzz_bytes *bytes)
{
    struct ply_ways ways = {.coding = fuzz_below(bytes, PLY_CODINGS), .vertex = fuzz_below(bytes, PLY_TYPES)};
    const uint8_t flags = fuzz_u8(bytes);

    if (ways.coding == PLY_TEXT) ways.vertex %= 2;
    ways.length = PLY_INT + fuzz_below(bytes, PLY_TYPES - PLY_INT);
    ways.index = PLY_INT + fuzz_below(bytes, PLY_TYPES - PLY_INT);
    ways.coloured = flags & 1, ways.colour_first = flags & 2, ways.edges = flags & 4, ways.other_names = flags & 8;
    ply_header(written, &ways);
    for (size_t i = 0; i < written->vertex_count; i++)
        ply_vertex(written, written->vertices[i], &ways, bytes);
    for (size_t i = 0; i < written->face_count; i++) {
        ply_whole(written, &ways, ways.length, written->faces[i].count);
        for (size_t k = 0; k < written->faces[i].count; k++)
            ply_whole(written, &ways, ways.index, written->faces[i].vertices[k]);
        if (ways.coding == PLY_TEXT) written_put(written, "\n");
    }
    for (int i = 0; i < 2 && ways.edges; i++)
        ply_whole(written, &ways, PLY_INT, 0);
    if (ways.coding == PLY_TEXT) written_put(written, "\n");
}

/* STL: every corner is a vertex of its own ---------------------------------------------------- */

static void stl_text(struct written *written, struct fuzz_bytes *bytes)
{
    written_put(written, "solid a vertex of no facet\n");
    for (size_t i = 0; i < written->vertex_count; i++) {
        if (i % 3 == 0) written_put(written, "facet normal 0 0 1\n  outer loop\n");
        written_put(written, "    vertex");
        for (int axis = 0; axis < 3; axis++) {
            written_put(written, "%s", blanks[fuzz_below(bytes, BLANKS)]);
            written->vertices[i][axis] = written_put_decimal(written, bytes);
        }
        written_put(written, "\n%s", i % 3 == 2 ? "  endloop\nendfacet\n" : "");
    }
    written_put(written, "endsolid a\n");
}

static void stl_binary(struct written *written, struct fuzz_bytes *bytes)
{
    static const char head[80] = "some tool's", normal[12];
    const struct ply_ways floats = {.coding = PLY_LITTLE, .vertex = PLY_FLOAT};

    written_put_bytes(written, head, sizeof head);
    written_put_whole(written, written->face_count, 4, false);
    for (size_t i = 0; i < written->vertex_count; i++) {
        if (i % 3 == 0) written_put_bytes(written, normal, sizeof normal);
        for (int axis = 0; axis < 3; axis++)
            written->vertices[i][axis] = ply_number(written, &floats, bytes);
        if (i % 3 == 2) written_put_whole(written, 0, 2, false);
    }
}

static void write_stl(struct written *written, struct fuzz_bytes *bytes)
{
    written->face_count = 1 + fuzz_below(bytes, 3);
    written->vertex_count = 3 * written->face_count;
    for (size_t i = 0; i < written->vertex_count; i++) {
        written->faces[i / 3].count = 3;
        written->faces[i / 3].vertices[i % 3] = i;
    }
    if (fuzz_below(bytes, 2))
        stl_text(written, bytes);
    else
        stl_binary(written, bytes);
}

/* OFF ---------------------------------------------------------------------------------------- */

static void write_off(struct written *written, struct fuzz_bytes *bytes)
{
    const bool has_divisors = fuzz_below(bytes, 2);

    written_put(written, "%sOFF\n%zu %zu 0\n", has_divisors ? "4" : "", written->vertex_count, written->face_count);
    for (size_t i = 0; i < written->vertex_count; i++) {
        const int divisor = has_divisors ? 1 + fuzz_below(bytes, 9) : 1;
        for (int axis = 0; axis < 3; axis++) {
            written->vertices[i][axis] = written_put_decimal(written, bytes) / divisor;
            written_put(written, "%s", blanks[fuzz_below(bytes, BLANKS)]);
        }
        if (has_divisors) written_put(written, "%d", divisor);
        written_put(written, "\n");
    }
    for (size_t i = 0; i < written->face_count; i++) {
        written_put(written, "%zu", written->faces[i].count);
        for (size_t k = 0; k < written->faces[i].count; k++)
            written_put(written, " %zu", written->faces[i].vertices[k]);
        written_put(written, "\n");
    }
}

/* All ---------------------------------------------------------------------------------------- */

static void make_faces(struct written *written, size_t corners_most, struct fuzz_bytes *bytes)
{
    written->vertex_count = 3u + fuzz_below(bytes, WRITTEN_VERTICES_MAX - 2);
    written->face_count = 1u + fuzz_below(bytes, WRITTEN_FACES_MAX);
    for (size_t i = 0; i < written->face_count; i++) {
        written->faces[i].count = 3u + fuzz_below(bytes, (unsigned)corners_most - 2);
        for (size_t k = 0; k < written->faces[i].count; k++)
            written->faces[i].vertices[k] = fuzz_below(bytes, (unsigned)written->vertex_count);
    }
}

void written_make(struct written *written, enum written_format format, struct fuzz_bytes *bytes)
{
    const bool is_gltf = format == WRITTEN_GLTF || format == WRITTEN_GLB;

    *written = (struct written){.format = format};
    make_faces(written, is_gltf ? 3 : WRITTEN_CORNERS_MAX, bytes);
    if (is_gltf) {
        written_gltf(written, bytes);
        return;
    }
    if (format == WRITTEN_OBJ) write_obj(written, bytes);
    if (format == WRITTEN_PLY) write_ply(written, bytes);
    if (format == WRITTEN_STL) write_stl(written, bytes);
    if (format == WRITTEN_OFF) write_off(written, bytes);
    memcpy(written->places, written->vertices, sizeof written->places);
}
