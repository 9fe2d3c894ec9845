/* SPDX-License-Identifier: MIT
 *
 * PLY, as text and binary: x, y and z of each vertex, whatever their type is, if that is wide enough for stand-ins.
 * In text an element instance is a line. A file whose header is not understood is left to the library.
 *
 * The library loses a newline that is the first byte behind a binary file's header. The first
 * element of such a file gets a property in front that nobody asks for. */
#include "readers/numbering.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ELEMENTS = 32, MOST_PROPERTIES = 128, HEADER_WORDS = 6 };
enum type { CHAR, UCHAR, SHORT, USHORT, INT, UINT, FLOAT, DOUBLE, NO_TYPE };
enum encoding { TEXT, LITTLE, BIG, UNKNOWN };

struct property {
    enum type type, list; /* list: of the count in front; NO_TYPE: it is none */
    int axis;             /* 0..2, or -1 */
};

struct element {
    bool vertices;
    size_t count, first, property_count; /* of ply.properties */
};

struct ply {
    enum encoding encoding;
    struct element elements[MOST_ELEMENTS];
    struct property properties[MOST_PROPERTIES];
    size_t element_count, property_count;
    unsigned axes;          /* a bit for each of x, y, z that is found */
    size_t properties_at_b; /* of the output: behind the first element's line */
    bool is_padded;         /* a byte goes before each of its instances */
};

static const size_t TYPE_B[] = {1, 1, 2, 2, 4, 4, 4, 8, 0};

static bool is(const struct word *word, const char *text)
{
    return word->length == strlen(text) && memcmp(word->text, text, word->length) == 0;
}

static enum type type_of(const struct word *word)
{
    static const struct {
        const char *name;
        enum type type;
    } names[] = {{"char", CHAR},      {"int8", CHAR},      {"uchar", UCHAR},   {"uint8", UCHAR},   {"short", SHORT},
                 {"int16", SHORT},    {"ushort", USHORT},  {"uint16", USHORT}, {"int", INT},       {"int32", INT},
                 {"uint", UINT},      {"uint32", UINT},    {"float", FLOAT},   {"float32", FLOAT}, {"double", DOUBLE},
                 {"float64", DOUBLE}, {"double64", DOUBLE}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (is(word, names[i].name)) return names[i].type;
    return NO_TYPE;
}

/* Header ------------------------------------------------------------------------------------- */

static bool add_element(struct ply *ply, const struct word *words, size_t count)
{
    if (ply->element_count == MOST_ELEMENTS || count < 3) return false;
    ply->elements[ply->element_count++] = (struct element){
        .vertices = is(&words[1], "vertex"), .count = strtoul(words[2].text, NULL, 10), .first = ply->property_count};
    return true;
}

static bool add_property(struct ply *ply, const struct word *words, size_t count)
{
    const bool list = count > 1 && is(&words[1], "list");
    if (ply->property_count == MOST_PROPERTIES || !ply->element_count || count < (list ? 5U : 3U)) return false;
    struct element *element = &ply->elements[ply->element_count - 1];
    struct property *property = &ply->properties[ply->property_count++];
    *property = (struct property){type_of(&words[list ? 3 : 1]), list ? type_of(&words[2]) : NO_TYPE, -1};
    element->property_count++;
    if (property->type == NO_TYPE || (list && property->list == NO_TYPE)) return false;
    for (int axis = 0; axis < 3 && !list && element->vertices; axis++)
        if (is(&words[2], (const char *const[]){"x", "y", "z"}[axis])) {
            property->axis = axis;
            ply->axes |= 1U << axis;
        }
    return true;
}

static void set_encoding(struct ply *ply, const struct word *words, size_t count)
{
    if (count < 2) return;
    if (is(&words[1], "ascii")) ply->encoding = TEXT;
    if (is(&words[1], "binary_little_endian")) ply->encoding = LITTLE;
    if (is(&words[1], "binary_big_endian")) ply->encoding = BIG;
}

static size_t line_length(const struct numbering *work)
{
    size_t length = 0;
    while (work->at + length < work->end && !is_line_end(work->at[length]))
        length++;
    return length;
}

static void copy_line_end(struct numbering *work)
{
    const bool both = work->end - work->at > 1 && work->at[0] == '\r' && work->at[1] == '\n';
    if (work->at < work->end) numbering_copy(work, both ? 2 : 1);
}

/* Up to and with the line `end_header`. false: not understood. */
static bool copy_header(struct numbering *work, struct ply *ply)
{
    while (work->at < work->end) {
        struct word words[HEADER_WORDS] = {{"", 0}};
        const size_t length = line_length(work);
        const size_t count = words_of(work->at, work->at + length, words, HEADER_WORDS);
        numbering_copy(work, length);
        copy_line_end(work);
        if (is(&words[0], "element") && !ply->element_count) ply->properties_at_b = work->out_b;
        if (is(&words[0], "format")) set_encoding(ply, words, count);
        if (is(&words[0], "element") && !add_element(ply, words, count)) return false;
        if (is(&words[0], "property") && !add_property(ply, words, count)) return false;
        if (is(&words[0], "end_header")) return ply->encoding != UNKNOWN && ply->axes == 7;
    }
    return false;
}

/* Text --------------------------------------------------------------------------------------- */

static bool has_lists(const struct ply *ply, const struct element *element)
{
    for (size_t i = 0; i < element->property_count; i++)
        if (ply->properties[element->first + i].list != NO_TYPE) return true;
    return false;
}

/* Writes the line's words, stand-ins for three of them. */
static bool text_vertex(struct numbering *work, const struct ply *ply, const struct element *element, size_t length)
{
    struct word words[MOST_PROPERTIES];
    double point[3] = {0};
    unsigned stand_in[3];
    const size_t count = words_of(work->at, work->at + length, words, MOST_PROPERTIES);
    const struct property *properties = &ply->properties[element->first];
    if (count < element->property_count)
        return error_set(work->err, "%s:%zu: a vertex of %zu numbers; the header says %zu", work->path, work->line,
                         count, element->property_count);
    for (size_t i = 0; i < element->property_count; i++)
        if (properties[i].axis >= 0 && !numbering_parse(work, &words[i], &point[properties[i].axis])) return false;
    if (work->table.count == VERTEX_TABLE_MOST)
        return error_set(work->err, "%s: more than %d vertices", work->path, VERTEX_TABLE_MOST);
    vertex_table_add(&work->table, point, stand_in);
    for (size_t i = 0; i < element->property_count; i++) {
        char text[16];
        const int axis = properties[i].axis;
        if (axis >= 0)
            numbering_write(work, text, (size_t)snprintf(text, sizeof text, " %u", stand_in[axis]));
        else
            numbering_word(work, &words[i]);
    }
    return true;
}

static bool number_text(struct numbering *work, const struct ply *ply)
{
    for (size_t e = 0; e < ply->element_count; e++) {
        const struct element *element = &ply->elements[e];
        for (size_t i = 0; i < element->count && work->at < work->end; i++) {
            while (work->at < work->end && (is_blank(*work->at) || is_line_end(*work->at)))
                numbering_skip(work, 1);
            const size_t length = line_length(work);
            if (element->vertices && length) {
                if (!text_vertex(work, ply, element, length)) return false;
                numbering_skip(work, length);
            } else {
                numbering_copy(work, length);
            }
            numbering_write(work, "\n", 1);
        }
    }
    numbering_copy(work, (size_t)(work->end - work->at));
    return true;
}

/* Binary ------------------------------------------------------------------------------------- */

static bool is_host_order(enum encoding encoding)
{
    const uint16_t one = 1;
    unsigned char first;
    memcpy(&first, &one, 1);
    return (encoding == LITTLE) == (first == 1);
}

static void copy_number(void *to, const void *from, size_t size_b, bool host_order)
{
    for (size_t i = 0; i < size_b; i++)
        ((char *)to)[i] = ((const char *)from)[host_order ? i : size_b - 1 - i];
}

static double number_at(const char *at, enum type type, bool host_order)
{
    union {
        int8_t i8;
        uint8_t u8;
        int16_t i16;
        uint16_t u16;
        int32_t i32;
        uint32_t u32;
        float f32;
        double f64;
    } number;
    copy_number(&number, at, TYPE_B[type], host_order);
    switch (type) {
    case CHAR:
        return number.i8;
    case UCHAR:
        return number.u8;
    case SHORT:
        return number.i16;
    case USHORT:
        return number.u16;
    case INT:
        return number.i32;
    case UINT:
        return number.u32;
    case FLOAT:
        return (double)number.f32;
    default:
        return number.f64;
    }
}

static void set_number(char *at, enum type type, bool host_order, unsigned value)
{
    const uint32_t whole = value;
    const float f32 = (float)value;
    const double f64 = value;
    const void *from = type == FLOAT ? (const void *)&f32 : type == DOUBLE ? (const void *)&f64 : (const void *)&whole;
    copy_number(at, from, TYPE_B[type], host_order);
}

/* How long a property is in the file; 0: the file ends before. */
static size_t property_b(const struct property *property, const char *at, size_t left_b, bool host_order)
{
    size_t size_b = TYPE_B[property->type];
    if (property->list != NO_TYPE) {
        const size_t count_b = TYPE_B[property->list];
        if (left_b < count_b) return 0;
        const double count = number_at(at, property->list, host_order);
        if (!(count >= 0 && count * (double)size_b <= (double)left_b)) return 0;
        size_b = count_b + (size_t)count * size_b;
    }
    return size_b <= left_b ? size_b : 0;
}

/* The coordinates of one vertex, which begins `from` bytes into the output. */
static bool binary_vertex(struct numbering *work, size_t number, const struct ply *ply, const size_t at_b[3],
                          const enum type types[3])
{
    const bool host_order = is_host_order(ply->encoding);
    double point[3];
    unsigned stand_in[3];
    for (int axis = 0; axis < 3; axis++) {
        point[axis] = number_at(work->out + at_b[axis], types[axis], host_order);
        if (!(point[axis] >= -3.4028234663852886e38 && point[axis] <= 3.4028234663852886e38))
            return error_set(work->err, "%s: vertex %zu: its coordinates are not finite or beyond 3.4e38", work->path,
                             number);
    }
    if (work->table.count == VERTEX_TABLE_MOST)
        return error_set(work->err, "%s: more than %d vertices", work->path, VERTEX_TABLE_MOST);
    vertex_table_add(&work->table, point, stand_in);
    for (int axis = 0; axis < 3; axis++)
        set_number(work->out + at_b[axis], types[axis], host_order, stand_in[axis]);
    return true;
}

/* Small integers are exact in float32, and have no room for stand-ins. */
static bool has_room(const struct ply *ply)
{
    for (size_t i = 0; i < ply->property_count; i++)
        if (ply->properties[i].axis >= 0 && TYPE_B[ply->properties[i].type] < 4) return false;
    return true;
}

static bool binary_instance(struct numbering *work, const struct ply *ply, const struct element *element, size_t number)
{
    size_t at_b[3] = {0};
    enum type types[3] = {FLOAT, FLOAT, FLOAT};
    if (ply->is_padded && element == ply->elements) numbering_write(work, "-", 1);
    for (size_t i = 0; i < element->property_count; i++) {
        const struct property *property = &ply->properties[element->first + i];
        const size_t size_b =
            property_b(property, work->at, (size_t)(work->end - work->at), is_host_order(ply->encoding));
        if (!size_b) return error_set(work->err, "%s: the file ends before its elements", work->path);
        if (property->axis >= 0) {
            at_b[property->axis] = work->out_b;
            types[property->axis] = property->type;
            work->is_float32 |= property->type == FLOAT;
        }
        numbering_write(work, work->at, size_b);
        work->at += size_b;
    }
    return !element->vertices || !has_room(ply) || binary_vertex(work, number, ply, at_b, types);
}

/* The header, which has been written, gets a property in front of the first element's. */
static void pad_header(struct numbering *work, struct ply *ply)
{
    static const char property[] = "property uchar nothing\n";
    const size_t property_b = sizeof property - 1, behind_b = work->out_b - ply->properties_at_b;
    numbering_write(work, property, property_b);
    char *at = work->out + ply->properties_at_b;
    memmove(at + property_b, at, behind_b);
    memcpy(at, property, property_b);
    ply->is_padded = work->is_mended = true;
}

static bool number_binary(struct numbering *work, struct ply *ply)
{
    if (work->at < work->end && *work->at == '\n') pad_header(work, ply);
    if (!has_room(ply) && !ply->is_padded) return true;
    for (size_t e = 0; e < ply->element_count; e++)
        for (size_t i = 0; i < ply->elements[e].count; i++)
            if (!binary_instance(work, ply, &ply->elements[e], i + 1)) return false;
    numbering_write(work, work->at, (size_t)(work->end - work->at));
    return true;
}

bool number_ply(struct numbering *work)
{
    struct ply ply = {.encoding = UNKNOWN};
    if (!copy_header(work, &ply)) return true;
    if (ply.encoding != TEXT) return number_binary(work, &ply);
    for (size_t e = 0; e < ply.element_count; e++)
        if (ply.elements[e].vertices && has_lists(&ply, &ply.elements[e])) return true;
    return number_text(work, &ply);
}
