/* SPDX-License-Identifier: MIT */
#include "formats/ply_header.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_B = 512 };

struct lines {
    const char *at, *end;
    bool ends_with_both; /* a carriage return and a newline */
    char line[LINE_B];
};

size_t ply_type_b(enum ply_type type)
{
    static const size_t size_b[] = {1, 1, 2, 2, 4, 4, 4, 8, 0};
    return size_b[type];
}

static enum ply_type type_of(const char *name)
{
    static const struct {
        const char *name;
        enum ply_type type;
    } names[] = {{"char", PLY_CHAR},      {"int8", PLY_CHAR},     {"uchar", PLY_UCHAR},   {"uint8", PLY_UCHAR},
                 {"short", PLY_SHORT},    {"int16", PLY_SHORT},   {"ushort", PLY_USHORT}, {"uint16", PLY_USHORT},
                 {"int", PLY_INT},        {"int32", PLY_INT},     {"uint", PLY_UINT},     {"uint32", PLY_UINT},
                 {"float", PLY_FLOAT},    {"float32", PLY_FLOAT}, {"double", PLY_DOUBLE}, {"float64", PLY_DOUBLE},
                 {"double64", PLY_DOUBLE}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(name, names[i].name) == 0) return names[i].type;
    return PLY_NO_TYPE;
}

static enum ply_kind kind_of(const char *name)
{
    if (strcmp(name, "vertex") == 0) return PLY_VERTEX;
    if (strcmp(name, "face") == 0) return PLY_FACE;
    return strcmp(name, "tristrips") == 0 ? PLY_STRIPS : PLY_OTHER;
}

static enum ply_role role_of(enum ply_kind kind, bool is_list, const char *name)
{
    static const struct {
        const char *name;
        enum ply_role role;
        bool is_list;
        unsigned kinds;
    } names[] = {{"x", PLY_X, false, 1U << PLY_VERTEX},
                 {"y", PLY_Y, false, 1U << PLY_VERTEX},
                 {"z", PLY_Z, false, 1U << PLY_VERTEX},
                 {"red", PLY_RED, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"diffuse_red", PLY_RED, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"r", PLY_RED, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"green", PLY_GREEN, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"diffuse_green", PLY_GREEN, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"g", PLY_GREEN, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"blue", PLY_BLUE, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"diffuse_blue", PLY_BLUE, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"b", PLY_BLUE, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"alpha", PLY_ALPHA, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"diffuse_alpha", PLY_ALPHA, false, 1U << PLY_VERTEX | 1U << PLY_FACE},
                 {"s", PLY_ACROSS, false, 1U << PLY_VERTEX},
                 {"u", PLY_ACROSS, false, 1U << PLY_VERTEX},
                 {"texture_u", PLY_ACROSS, false, 1U << PLY_VERTEX},
                 {"t", PLY_UP, false, 1U << PLY_VERTEX},
                 {"v", PLY_UP, false, 1U << PLY_VERTEX},
                 {"texture_v", PLY_UP, false, 1U << PLY_VERTEX},
                 {"texnumber", PLY_PICTURE, false, 1U << PLY_FACE},
                 {"vertex_index", PLY_CORNERS, true, 1U << PLY_FACE | 1U << PLY_STRIPS},
                 {"vertex_indices", PLY_CORNERS, true, 1U << PLY_FACE | 1U << PLY_STRIPS},
                 {"texcoord", PLY_PLACES, true, 1U << PLY_FACE}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (names[i].is_list == is_list && names[i].kinds >> kind & 1 && strcmp(name, names[i].name) == 0)
            return names[i].role;
    return PLY_NO_ROLE;
}

/* Lines ------------------------------------------------------------------------------------------------------------ */

/* A line that is too long is cut. The body may begin with what looks like the rest of a line's end. */
static bool next_line(struct lines *lines)
{
    size_t length = 0;
    if (lines->at == lines->end) return false;
    for (; lines->at < lines->end && *lines->at != '\n' && *lines->at != '\r'; lines->at++)
        if (length + 1 < sizeof lines->line) lines->line[length++] = *lines->at;
    lines->line[length] = '\0';
    if (lines->at == lines->end) return true;
    lines->at += lines->ends_with_both && lines->end - lines->at > 1 ? 2 : 1;
    return true;
}

static bool has_both(const char *bytes, size_t size_b)
{
    for (size_t i = 0; i + 1 < size_b; i++)
        if (bytes[i] == '\n' || bytes[i] == '\r') return bytes[i] == '\r' && bytes[i + 1] == '\n';
    return false;
}

/* Statements ------------------------------------------------------------------------------------------------------- */

static bool add_element(struct ply_header *header, const char *line)
{
    if (header->element_count == PLY_ELEMENTS) return false;
    struct ply_element *element = &header->elements[header->element_count++];
    *element = (struct ply_element){.first = header->property_count};
    if (sscanf(line, " element %63s %lu", element->name, &element->count) != 2) return false;
    element->kind = kind_of(element->name);
    return true;
}

static bool add_property(struct ply_header *header, const char *line)
{
    char count[PLY_NAME_B] = "", type[PLY_NAME_B], name[PLY_NAME_B];
    if (header->property_count == PLY_PROPERTIES || header->element_count == 0) return false;
    const bool is_list = sscanf(line, " property list %63s %63s %63s", count, type, name) == 3;
    if (!is_list && sscanf(line, " property %63s %63s", type, name) != 2) return false;
    struct ply_element *element = &header->elements[header->element_count - 1];
    struct ply_property *property = &header->properties[header->property_count++];
    property->type = type_of(type);
    property->count = is_list ? type_of(count) : PLY_NO_TYPE;
    property->role = role_of(element->kind, is_list, name);
    element->properties++;
    element->roles |= 1U << property->role;
    return property->type != PLY_NO_TYPE && (!is_list || property->count != PLY_NO_TYPE);
}

static bool set_coding(struct ply_header *header, const char *line)
{
    char name[PLY_NAME_B] = "";
    sscanf(line, " format %63s", name);
    header->coding = strcmp(name, "ascii") == 0                  ? PLY_TEXT
                     : strcmp(name, "binary_little_endian") == 0 ? PLY_LITTLE
                     : strcmp(name, "binary_big_endian") == 0    ? PLY_BIG
                                                                 : PLY_NO_CODING;
    return header->coding != PLY_NO_CODING;
}

/* A name may have blanks within, but none behind it. */
static bool take_comment(struct ply_header *header, const char *line)
{
    int at = 0;
    size_t length;
    if (sscanf(line, " comment TextureFile %n", &at) == EOF || !at) return true;
    for (length = strlen(line + at); length && strchr(" \t", line[at + (int)length - 1]);)
        length--;
    if (!length) return true;
    if (length >= PLY_FILE_B || header->picture_count == PLY_PICTURES) return false;
    memcpy(header->pictures[header->picture_count++], line + at, length);
    return true;
}

static bool take_line(struct ply_header *header, const char *word, const char *line)
{
    if (strcmp(word, "property") == 0) return add_property(header, line);
    if (strcmp(word, "element") == 0) return add_element(header, line);
    if (strcmp(word, "format") == 0) return set_coding(header, line);
    return strcmp(word, "comment") != 0 || take_comment(header, line);
}

bool ply_header_read(const char *path, const char *bytes, size_t size_b, struct ply_header *out, struct error *err)
{
    struct lines lines = {bytes, bytes + size_b, has_both(bytes, size_b), ""};
    char word[PLY_NAME_B];
    *out = (struct ply_header){.coding = PLY_NO_CODING};
    for (; next_line(&lines); out->lines++) {
        word[0] = '\0';
        sscanf(lines.line, " %63s", word);
        if (out->lines == 0 && strcmp(word, "ply") != 0)
            return error_set(err, "%s: it does not begin with 'ply'", path);
        if (strcmp(word, "end_header") == 0) {
            out->lines++;
            out->body_at_b = (size_t)(lines.at - bytes);
            return out->coding != PLY_NO_CODING || error_set(err, "%s: its header names no format", path);
        }
        if (lines.at == lines.end) break;
        if (!take_line(out, word, lines.line))
            return error_set(err, "%s:%zu: '%.60s' is not understood", path, out->lines + 1, lines.line);
    }
    return error_set(err, "%s: truncated: it ends within its header", path);
}
