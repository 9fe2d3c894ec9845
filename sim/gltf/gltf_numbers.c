/* SPDX-License-Identifier: MIT
 *
 * Numbers in buffers are little-endian. */
#include "gltf/gltf_numbers.h"

#include "base/grow.h"
#include "files/companion.h"
#include "gltf/gltf_meshopt.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum component { BYTE = 5120, UNSIGNED_BYTE, SHORT, UNSIGNED_SHORT, UNSIGNED_INT = 5125, FLOAT };

/* Buffers ------------------------------------------------------------------------------------ */

static int base64_digit(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = c ? strchr(digits, c) : NULL;
    return at ? (int)(at - digits) : -1;
}

static void decode_base64(const char *text, struct gltf_buffer *out)
{
    unsigned char *bytes = grow_zeroed(strlen(text) / 4 * 3 + 3, 1);
    uint32_t bits = 0;
    unsigned held = 0;
    for (; base64_digit(*text) >= 0; text++) {
        bits = bits << 6 | (uint32_t)base64_digit(*text);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes[out->size_b++] = (unsigned char)(bits >> held);
    }
    out->bytes = out->owned = bytes;
}

static bool read_buffer(const struct gltf_file *file, size_t index, struct gltf_buffer *out, struct error *err)
{
    struct whole_file whole;
    const char *uri = json_string_value(json_object_get(gltf_element(file, "buffers", index), "uri"));
    const char *base64 = uri && strncmp(uri, "data:", 5) == 0 ? strstr(uri, ";base64,") : NULL;
    *out = (struct gltf_buffer){0};
    if (!uri && index == 0) *out = (struct gltf_buffer){.bytes = file->binary, .size_b = file->binary_b};
    if (!uri) return true; /* another one without a name is there for readers that cannot decompress */
    if (base64) {
        decode_base64(base64 + strlen(";base64,"), out);
        return true;
    }
    if (!whole_file_read_companion(uri, &whole, err)) return false;
    *out = (struct gltf_buffer){whole.bytes, whole.size_b, whole.bytes};
    return true;
}

/* Why a buffer cannot be read may say no more than which it is; that it may not be read, when its name was looked at
 * once more, is the better reason. */
static bool name_model(const char *path, struct error *err)
{
    companions_refused(err);
    return strncmp(err->text, path, strlen(path)) != 0 && error_prefix(err, path);
}

size_t gltf_buffers_add(struct gltf_buffers *buffers, const struct gltf_buffer *buffer)
{
    buffers->items = grow(buffers->items, buffers->count, &buffers->capacity, sizeof *buffers->items);
    buffers->items[buffers->count] = *buffer;
    return buffers->count++;
}

/* A view that is packed, into a buffer of its own. */
static bool unpack_view(json_t *view, struct gltf_buffers *buffers, struct error *err)
{
    size_t buffer;
    struct gltf_buffer unpacked = {0};
    const struct gltf_buffer *from =
        gltf_meshopt_buffer(view, &buffer) && buffer < buffers->count ? &buffers->items[buffer] : &unpacked;
    if (!gltf_meshopt_unpack(view, from->bytes, from->size_b, &unpacked.owned, &unpacked.size_b, err)) return false;
    unpacked.bytes = unpacked.owned;
    gltf_meshopt_mend(view, gltf_buffers_add(buffers, &unpacked));
    return true;
}

static bool unpack_views(const char *path, const struct gltf_file *file, struct gltf_buffers *buffers,
                         struct error *err)
{
    size_t i;
    json_t *view;
    json_array_foreach(json_object_get(file->root, "bufferViews"), i, view)
    {
        char what[64];
        if (!gltf_meshopt_is_packed(view) || unpack_view(view, buffers, err)) continue;
        snprintf(what, sizeof what, "view %zu of its buffers", i);
        error_prefix(err, what);
        return error_prefix(err, path);
    }
    return true;
}

bool gltf_buffers_read(const char *path, const struct gltf_file *file, struct gltf_buffers *out, struct error *err)
{
    const size_t count = json_array_size(json_object_get(file->root, "buffers"));
    companions_begin(path);
    *out = (struct gltf_buffers){.count = 0};
    for (size_t i = 0; i < count; i++) {
        struct gltf_buffer buffer;
        if (!read_buffer(file, i, &buffer, err)) return name_model(path, err);
        gltf_buffers_add(out, &buffer);
    }
    return unpack_views(path, file, out, err);
}

void gltf_buffers_free(struct gltf_buffers *buffers)
{
    for (size_t i = 0; i < buffers->count; i++)
        free(buffers->items[i].owned);
    free(buffers->items);
    *buffers = (struct gltf_buffers){0};
}

/* Accessors ---------------------------------------------------------------------------------- */

static size_t size_of(size_t component)
{
    return component == FLOAT || component == UNSIGNED_INT     ? 4
           : component == SHORT || component == UNSIGNED_SHORT ? 2
           : component == BYTE || component == UNSIGNED_BYTE   ? 1
                                                               : 0;
}

static double number_at(const char *at, size_t component, bool normalised)
{
    uint32_t bits = 0;
    float number;
    for (size_t i = 0; i < size_of(component); i++)
        bits |= (uint32_t)(unsigned char)at[i] << 8 * i;
    switch (component) {
    case BYTE:
        return normalised ? fmax((int8_t)bits / 127.0, -1) : (int8_t)bits;
    case UNSIGNED_BYTE:
        return normalised ? bits / 255.0 : bits;
    case SHORT:
        return normalised ? fmax((int16_t)bits / 32767.0, -1) : (int16_t)bits;
    case UNSIGNED_SHORT:
        return normalised ? bits / 65535.0 : bits;
    case UNSIGNED_INT:
        return bits;
    default:
        memcpy(&number, &bits, sizeof number);
        return (double)number;
    }
}

/* What a view of a buffer holds, from byteOffset bytes behind its beginning. */
struct window {
    const char *bytes;
    size_t size_b, stride_b;
};

static bool window_of(const struct gltf_file *file, const struct gltf_buffers *buffers, const json_t *accessor,
                      size_t element_b, struct window *out)
{
    size_t view_index, buffer, start_b = 0, length_b, offset_b = 0;
    if (!gltf_index(accessor, "bufferView", &view_index)) return false;
    const json_t *view = gltf_element(file, "bufferViews", view_index);
    if (!gltf_index(view, "buffer", &buffer) || buffer >= buffers->count) return false;
    if (!gltf_index(view, "byteLength", &length_b)) return false;
    gltf_index(view, "byteOffset", &start_b);
    gltf_index(accessor, "byteOffset", &offset_b);
    const struct gltf_buffer *from = &buffers->items[buffer];
    if (!from->bytes || start_b > from->size_b || length_b > from->size_b - start_b || offset_b > length_b)
        return false;
    *out = (struct window){from->bytes + start_b + offset_b, length_b - offset_b, element_b};
    if (gltf_index(view, "byteStride", &out->stride_b) && out->stride_b < element_b) return false;
    return true;
}

static bool window_holds(const struct window *window, size_t element_b, size_t count)
{
    return count == 0 || (window->size_b >= element_b && count - 1 <= (window->size_b - element_b) / window->stride_b);
}

static void copy_values(const struct window *window, size_t component, bool normalised, size_t components,
                        struct gltf_array *out)
{
    for (size_t i = 0; i < out->count; i++)
        for (size_t k = 0; k < components; k++)
            out->values[i * components + k] =
                number_at(window->bytes + i * window->stride_b + k * size_of(component), component, normalised);
}

/* Which values a sparse accessor replaces, and by what. */
struct changes {
    struct window places, values;
    size_t place_kind, count;
};

static bool changes_of(const struct gltf_file *file, const struct gltf_buffers *buffers, const json_t *sparse,
                       size_t element_b, struct changes *out)
{
    const json_t *indices = json_object_get(sparse, "indices"), *values = json_object_get(sparse, "values");
    if (!gltf_index(sparse, "count", &out->count) || !gltf_index(indices, "componentType", &out->place_kind))
        return false;
    const size_t place_b = size_of(out->place_kind);
    return place_b && window_of(file, buffers, indices, place_b, &out->places) &&
           window_of(file, buffers, values, element_b, &out->values) &&
           window_holds(&out->places, place_b, out->count) && window_holds(&out->values, element_b, out->count);
}

/* false: one of the places is not among the values. */
static bool apply(const struct changes *changes, size_t component, bool normalised, size_t components,
                  struct gltf_array *out)
{
    for (size_t i = 0; i < changes->count; i++) {
        const double place =
            number_at(changes->places.bytes + i * changes->places.stride_b, changes->place_kind, false);
        const char *from = changes->values.bytes + i * changes->values.stride_b;
        if (!(place >= 0 && place < (double)out->count)) return false;
        for (size_t k = 0; k < components; k++)
            out->values[(size_t)place * components + k] =
                number_at(from + k * size_of(component), component, normalised);
    }
    return true;
}

bool gltf_array_read(const struct gltf_file *file, const struct gltf_buffers *buffers, size_t accessor,
                     size_t components, struct gltf_array *out)
{
    static const char *const types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    const json_t *own = gltf_element(file, "accessors", accessor), *sparse = json_object_get(own, "sparse");
    const char *type = json_string_value(json_object_get(own, "type"));
    const bool normalised = json_is_true(json_object_get(own, "normalized"));
    struct window window;
    size_t component;
    *out = (struct gltf_array){0};
    if (!type || components > 4 || strcmp(type, types[components]) != 0) return false;
    if (!gltf_index(own, "componentType", &component) || !size_of(component)) return false;
    if (!gltf_index(own, "count", &out->count) || out->count > GLTF_ARRAY_MOST) return false;
    const size_t element_b = components * size_of(component);
    const bool has_view = json_object_get(own, "bufferView");
    if (has_view &&
        (!window_of(file, buffers, own, element_b, &window) || !window_holds(&window, element_b, out->count)))
        return false;
    out->values = grow_zeroed(out->count * components, sizeof(double));
    if (has_view) copy_values(&window, component, normalised, components, out);
    struct changes changes;
    return !sparse || (changes_of(file, buffers, sparse, element_b, &changes) &&
                       apply(&changes, component, normalised, components, out));
}
