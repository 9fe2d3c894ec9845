/* SPDX-License-Identifier: MIT
 *
 * Hosts have the file's order of bytes. */
#include "readers/source_gltf_numbers.h"

#include "base/grow.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Types of numbers, by what the file calls them less 5120. Divisors are those of normalised ones. */
static const struct type {
    unsigned char size_b;
    bool is_signed;
    double divisor;
} TYPES[] = {{1, true, 127}, {1, false, 255}, {2, true, 32767}, {2, false, 65535},
             {0, false, 0},  {4, false, 1},   {4, true, 1}};
enum { FIRST_TYPE = 5120, TYPE_COUNT = sizeof TYPES / sizeof *TYPES, REAL = TYPE_COUNT - 1 };

/* Elements of a list of bytes. */
struct run {
    const unsigned char *first;
    size_t apart_b, count; /* as many as there is room for */
};

static bool type_of(const json_t *object, size_t *type)
{
    if (!gltf_index(object, "componentType", type) || *type < FIRST_TYPE) return false;
    *type -= FIRST_TYPE;
    return *type < TYPE_COUNT && TYPES[*type].size_b;
}

/* Where what `object` names begins, and how many elements of so many bytes are behind it in its view. */
static bool run_of(const struct gltf_file *file, const struct gltf_buffers *buffers, const json_t *object,
                   size_t element_b, struct run *out)
{
    size_t number = 0, skipped_b = 0;
    const json_t *view = gltf_index(object, "bufferView", &number) ? gltf_element(file, "bufferViews", number) : NULL;
    size_t buffer = SIZE_MAX, begin_b = 0, length_b = 0;
    gltf_index(view, "buffer", &buffer);
    gltf_index(view, "byteOffset", &begin_b);
    gltf_index(view, "byteLength", &length_b);
    gltf_index(object, "byteOffset", &skipped_b);
    *out = (struct run){.apart_b = element_b};
    gltf_index(view, "byteStride", &out->apart_b);
    if (buffer >= buffers->count || out->apart_b < element_b) return false;
    const struct gltf_buffer *bytes = &buffers->items[buffer];
    const size_t end_b = bytes->size_b > begin_b && bytes->size_b - begin_b >= length_b ? length_b : 0;
    if (end_b < skipped_b || end_b - skipped_b < element_b) return true;
    out->first = (const unsigned char *)bytes->bytes + begin_b + skipped_b;
    out->count = 1 + (end_b - skipped_b - element_b) / out->apart_b;
    return true;
}

static double number_of(const unsigned char *at, size_t type, bool is_share)
{
    int8_t i8;
    int16_t i16;
    uint16_t u16;
    uint32_t u32;
    float f32;
    double value = at[0];
    if (type == REAL) {
        memcpy(&f32, at, sizeof f32);
        return (double)f32;
    }
    if (TYPES[type].size_b == sizeof u32)
        memcpy(&u32, at, sizeof u32), value = u32;
    else if (TYPES[type].size_b == sizeof u16 && TYPES[type].is_signed)
        memcpy(&i16, at, sizeof i16), value = i16;
    else if (TYPES[type].size_b == sizeof u16)
        memcpy(&u16, at, sizeof u16), value = u16;
    else if (TYPES[type].is_signed)
        memcpy(&i8, at, sizeof i8), value = i8;
    return is_share ? fmax(value / TYPES[type].divisor, -1) : value;
}

static void copy_element(const struct run *run, size_t element, size_t type, bool is_share,
                         const struct source_numbers *out, size_t to)
{
    const unsigned char *at = run->first + element * run->apart_b;
    for (size_t k = 0; k < out->width; k++)
        out->values[to * out->width + k] = number_of(at + k * TYPES[type].size_b, type, is_share);
}

static bool put_changes(const struct gltf_file *file, const struct gltf_buffers *buffers, const json_t *sparse,
                        size_t type, bool is_share, const struct source_numbers *out)
{
    const json_t *indices = json_object_get(sparse, "indices"), *values = json_object_get(sparse, "values");
    struct run places, changes;
    size_t place_type, count = 0;
    gltf_index(sparse, "count", &count);
    if (!type_of(indices, &place_type) || place_type == REAL ||
        !run_of(file, buffers, indices, TYPES[place_type].size_b, &places) ||
        !run_of(file, buffers, values, out->width * TYPES[type].size_b, &changes) || places.count < count ||
        changes.count < count)
        return false;
    for (size_t i = 0; i < count; i++) {
        const double place = number_of(places.first + i * places.apart_b, place_type, false);
        if (place < 0 || place >= (double)out->count) return false;
        copy_element(&changes, i, type, is_share, out, (size_t)place);
    }
    return true;
}

bool source_numbers_read(const struct gltf_file *file, const struct gltf_buffers *buffers, size_t accessor,
                         size_t width, struct source_numbers *out)
{
    static const char *const names[] = {NULL, "SCALAR", "VEC2", "VEC3", "VEC4"};
    const json_t *object = gltf_element(file, "accessors", accessor), *sparse = json_object_get(object, "sparse");
    const char *name = json_string_value(json_object_get(object, "type"));
    const bool is_share = json_is_true(json_object_get(object, "normalized"));
    const bool is_zero = !json_object_get(object, "bufferView");
    struct run run = {0};
    size_t type;
    *out = (struct source_numbers){.width = width};
    if (!name || strcmp(name, names[width]) != 0 || !type_of(object, &type)) return false;
    if (!gltf_index(object, "count", &out->count) || out->count > GLTF_ARRAY_MOST) return false;
    if (!is_zero && (!run_of(file, buffers, object, width * TYPES[type].size_b, &run) || run.count < out->count))
        return false;
    out->values = grow_zeroed(out->count * width, sizeof *out->values);
    for (size_t i = 0; i < out->count && !is_zero; i++)
        copy_element(&run, i, type, is_share, out, i);
    return !sparse || put_changes(file, buffers, sparse, type, is_share, out);
}

void source_numbers_free(struct source_numbers *numbers)
{
    free(numbers->values);
    *numbers = (struct source_numbers){0};
}
