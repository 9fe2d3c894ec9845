/* SPDX-License-Identifier: MIT
 *
 * A PLY header names elements, their numbers and their properties, numbers or lists of such; what follows is gone
 * through element by element. A binary STL file has 84 bytes, the last four of which count triangles, 50 bytes each.
 * Sources: Turk, The PLY Polygon File Format, 1994; 3D Systems, StereoLithography Interface Specification, 1988. */
#include "readers/model_whole.h"

#include "base/binary.h"
#include "base/input_file.h"
#include "readers/whole_file.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { ELEMENTS_MAX = 32, PROPERTIES_MAX = 256, WORD_B = 64, LONGEST_LINE_B = 1 << 20 };

enum coding { CODING_TEXT, CODING_LITTLE, CODING_BIG };

struct property {
    size_t value_b, count_b; /* count_b > 0: a list */
    bool count_is_signed;
};

struct element {
    char name[WORD_B];
    unsigned long count;
    size_t first, properties; /* in struct ply */
};

struct ply {
    const char *path;
    const uint8_t *at, *end;
    enum coding coding;
    struct element elements[ELEMENTS_MAX];
    struct property properties[PROPERTIES_MAX];
    size_t element_count, property_count;
};

/* The header --------------------------------------------------------------------------------- */

/* The next line without its end; false: there is none. A line that is too long is cut. */
static bool next_line(struct ply *ply, char *line, size_t size_b)
{
    size_t length = 0;
    if (ply->at == ply->end) return false;
    for (; ply->at < ply->end && *ply->at != '\n' && *ply->at != '\r'; ply->at++)
        if (length + 1 < size_b) line[length++] = (char)*ply->at;
    line[length] = '\0';
    if (ply->at < ply->end && *ply->at++ == '\r' && ply->at < ply->end && *ply->at == '\n') ply->at++;
    return true;
}

/* 0: there is no such type. */
static size_t type_b(const char *name)
{
    static const struct {
        const char *name;
        size_t size_b;
    } types[] = {{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
                 {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
                 {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (strcmp(types[i].name, name) == 0) return types[i].size_b;
    return 0;
}

static bool add_property(struct ply *ply, const char *line)
{
    char count[WORD_B], value[WORD_B];
    struct property *property = &ply->properties[ply->property_count];
    if (ply->element_count == 0 || ply->property_count == PROPERTIES_MAX) return false;
    *property = (struct property){0};
    if (sscanf(line, " property list %63s %63s", count, value) == 2) {
        property->count_b = type_b(count);
        property->count_is_signed = count[0] != 'u';
        if (property->count_b == 0 || count[0] == 'f' || count[0] == 'd') return false;
    } else if (sscanf(line, " property %63s", value) != 1) {
        return false;
    }
    property->value_b = type_b(value);
    ply->property_count++;
    ply->elements[ply->element_count - 1].properties++;
    return property->value_b > 0;
}

static bool add_element(struct ply *ply, const char *line)
{
    if (ply->element_count == ELEMENTS_MAX) return false;
    struct element *element = &ply->elements[ply->element_count++];
    *element = (struct element){.first = ply->property_count};
    return sscanf(line, " element %63s %lu", element->name, &element->count) == 2;
}

static bool set_coding(struct ply *ply, const char *line)
{
    char name[WORD_B];
    if (sscanf(line, " format %63s", name) != 1) return false;
    ply->coding = strcmp(name, "ascii") == 0                  ? CODING_TEXT
                  : strcmp(name, "binary_little_endian") == 0 ? CODING_LITTLE
                                                              : CODING_BIG;
    return true;
}

enum header { HEADER_READ, HEADER_UNKNOWN, HEADER_ENDS_EARLY };

/* HEADER_UNKNOWN: what this is, the library may know. */
static enum header read_header(struct ply *ply)
{
    char line[256], word[WORD_B];
    if (!next_line(ply, line, sizeof line) || strcmp(line, "ply") != 0) return HEADER_UNKNOWN;
    while (next_line(ply, line, sizeof line)) {
        if (sscanf(line, " %63s", word) != 1) continue;
        if (strcmp(word, "end_header") == 0) return HEADER_READ;
        if (ply->at == ply->end) break;
        if (strcmp(word, "property") == 0 && !add_property(ply, line)) return HEADER_UNKNOWN;
        if (strcmp(word, "element") == 0 && !add_element(ply, line)) return HEADER_UNKNOWN;
        if (strcmp(word, "format") == 0 && !set_coding(ply, line)) return HEADER_UNKNOWN;
    }
    return HEADER_ENDS_EARLY;
}

/* What follows it ---------------------------------------------------------------------------- */

static bool skip_words(struct ply *ply, unsigned long count)
{
    for (; count; count--) {
        while (ply->at < ply->end && isspace(*ply->at))
            ply->at++;
        if (ply->at == ply->end) return false;
        while (ply->at < ply->end && !isspace(*ply->at))
            ply->at++;
    }
    return true;
}

static bool skip_bytes(struct ply *ply, size_t count, size_t each_b)
{
    if (count > (size_t)(ply->end - ply->at) / each_b) return false;
    ply->at += count * each_b;
    return true;
}

/* A word's number as it stands before it is skipped. */
static unsigned long text_count(const struct ply *ply)
{
    char word[WORD_B] = "";
    const uint8_t *at = ply->at;
    while (at < ply->end && isspace(*at))
        at++;
    for (size_t i = 0; i + 1 < sizeof word && at < ply->end && !isspace(*at); i++)
        word[i] = (char)*at++;
    const double number = strtod(word, NULL);
    return number > 0 && number < 1e9 ? (unsigned long)number : 0;
}

static unsigned long binary_count(const struct ply *ply, const struct property *property)
{
    unsigned long count = 0;
    for (size_t i = 0; i < property->count_b; i++)
        count = count << 8 | ply->at[ply->coding == CODING_BIG ? i : property->count_b - 1 - i];
    const bool is_negative = property->count_is_signed && count >> (8 * property->count_b - 1);
    return is_negative ? 0 : count;
}

static bool skip_property(struct ply *ply, const struct property *property)
{
    unsigned long count = 1;
    if (ply->coding == CODING_TEXT) {
        if (property->count_b) count += text_count(ply);
        return skip_words(ply, count);
    }
    if (property->count_b) {
        if ((size_t)(ply->end - ply->at) < property->count_b) return false;
        count = binary_count(ply, property);
        ply->at += property->count_b;
    }
    return skip_bytes(ply, count, property->value_b);
}

static bool elements_are_whole(struct ply *ply, struct error *err)
{
    for (size_t i = 0; i < ply->element_count; i++) {
        const struct element *element = &ply->elements[i];
        for (unsigned long number = 0; element->properties && number < element->count; number++)
            for (size_t p = 0; p < element->properties; p++)
                if (!skip_property(ply, &ply->properties[element->first + p]))
                    return error_set(err, "%s: truncated: it ends within %s %lu of %lu", ply->path, element->name,
                                     number + 1, element->count);
    }
    return true;
}

static bool ply_is_whole(const char *path, const struct binary *file, struct error *err)
{
    struct ply ply = {.path = path, .at = file->bytes, .end = file->bytes + file->size_b};
    const enum header header = read_header(&ply);
    if (header == HEADER_ENDS_EARLY) return error_set(err, "%s: truncated: it ends within its header", path);
    return header == HEADER_UNKNOWN || elements_are_whole(&ply, err);
}

/* Other formats ------------------------------------------------------------------------------ */

static bool word_is(const uint8_t *at, const uint8_t *end, const char *word)
{
    const size_t length = strlen(word);
    return (size_t)(end - at) >= length && strncasecmp((const char *)at, word, length) == 0;
}

/* Text ends with `endsolid` and a name; behind the last one is no facet. */
static bool stl_text_is_whole(const char *path, const struct binary *file, struct error *err)
{
    const uint8_t *end = file->bytes + file->size_b;
    bool is_open = false;
    for (const uint8_t *at = file->bytes; at < end; at++) {
        if (at > file->bytes && !isspace(at[-1])) continue;
        is_open |= word_is(at, end, "facet") || word_is(at, end, "vertex");
        if (!word_is(at, end, "endsolid")) continue;
        is_open = false;
        while (at + 1 < end && *at != '\n' && *at != '\r')
            at++;
    }
    return !is_open || error_set(err, "%s: truncated: it ends before endsolid", path);
}

static bool stl_is_whole(const char *path, const struct binary *file, struct error *err)
{
    const bool is_text = word_is(file->bytes, file->bytes + file->size_b, "solid");
    const uint8_t *at = file->bytes + 80;
    uint32_t count = 0;
    if (file->size_b >= 84) count = (uint32_t)at[3] << 24 | (uint32_t)at[2] << 16 | (uint32_t)at[1] << 8 | at[0];
    const size_t there = file->size_b >= 84 ? (file->size_b - 84) / 50 : 0;
    if (is_text && (file->size_b < 84 || there != count)) return stl_text_is_whole(path, file, err);
    return there >= count ||
           error_set(err, "%s: truncated: it ends within triangle %zu of %lu", path, there + 1, (unsigned long)count);
}

bool model_text_fits(const char *path, const char *text, size_t size_b, struct error *err)
{
    size_t line_b = 0, longest_b = 0;
    for (size_t i = 0; i < size_b; i++) {
        line_b = text[i] == '\n' || text[i] == '\r' ? 0 : line_b + 1;
        if (line_b > longest_b) longest_b = line_b;
    }
    if (whole_file_mark_b(text, size_b) != WHOLE_FILE_UTF16 && memchr(text, 0, size_b))
        return error_set(err, "%s: a NUL byte in a text", path);
    return longest_b <= LONGEST_LINE_B || error_set(err, "%s: a line is longer than %d bytes", path, LONGEST_LINE_B);
}

/* Words of a line after its first; 0 if the last of them cannot be whole. */
static size_t words_after(const char *line)
{
    size_t count = 0;
    for (const char *at = line + strcspn(line, " \t"); at[strspn(at, " \t")]; count++) {
        at += strspn(at, " \t");
        at += strcspn(at, " \t");
    }
    return strchr("/+-.eE", line[strlen(line) - 1]) ? 0 : count;
}

/* The last line alone can show it: if it has no end, and fewer numbers than a vertex or a face needs. */
static bool obj_is_whole(const char *path, const struct binary *file, struct error *err)
{
    char line[256];
    size_t length = 0;
    if (!model_text_fits(path, (const char *)file->bytes, file->size_b, err)) return false;
    while (length < file->size_b && file->bytes[file->size_b - 1 - length] != '\n' &&
           file->bytes[file->size_b - 1 - length] != '\r')
        length++;
    if (length < 2 || length >= sizeof line) return true;
    memcpy(line, file->bytes + file->size_b - length, length);
    line[length] = '\0';
    const bool is_vertex = strncmp(line, "v ", 2) == 0, is_face = strncmp(line, "f ", 2) == 0;
    if ((!is_vertex && !is_face) || words_after(line) >= 3) return true;
    return error_set(err, "%s: truncated: its last line is '%.40s'", path, line);
}

/* The library looks into files of any name. */
static bool begins_as_ply(const char *path)
{
    char bytes[4] = "";
    struct error ignored;
    FILE *file = input_open(path, MODEL_FILE_MOST_B, NULL, &ignored);
    const bool is_ply = file && fread(bytes, 1, sizeof bytes, file) == sizeof bytes && memcmp(bytes, "ply", 3) == 0 &&
                        isspace((unsigned char)bytes[3]);
    if (file) fclose(file);
    return is_ply;
}

bool model_is_whole(const char *path, struct error *err)
{
    static const struct {
        const char *suffix;
        bool (*is_whole)(const char *path, const struct binary *file, struct error *err);
    } formats[] = {{".ply", ply_is_whole}, {".stl", stl_is_whole}, {".obj", obj_is_whole}};
    struct binary file;
    const char *suffix = begins_as_ply(path) ? ".ply" : strrchr(path, '.');
    for (size_t i = 0; suffix && i < sizeof formats / sizeof *formats; i++) {
        if (strcasecmp(suffix, formats[i].suffix) != 0) continue;
        if (!binary_read(path, MODEL_FILE_MOST_B, &file, err)) return false;
        const bool ok = formats[i].is_whole(path, &file, err);
        free(file.bytes);
        return ok;
    }
    return true;
}
