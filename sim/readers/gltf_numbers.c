/* SPDX-License-Identifier: MIT
 *
 * Numbers in buffers are little-endian. */
#include "readers/gltf_numbers.h"

#include "base/grow.h"
#include "files/companion.h"

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
    *out = (struct gltf_buffer){.bytes = file->binary, .size_b = file->binary_b};
    if (!uri) return true;
    *out = (struct gltf_buffer){0};
    if (base64) {
        decode_base64(base64 + strlen(";base64,"), out);
        return true;
    }
    if (!whole_file_read_companion(uri, &whole, err)) return false;
    *out = (struct gltf_buffer){whole.bytes, whole.size_b, whole.bytes};
    return true;
}

bool gltf_buffers_read(const char *path, const struct gltf_file *file, struct gltf_buffers *out, struct error *err)
{
    const size_t count = json_array_size(json_object_get(file->root, "buffers"));
    companions_begin(path);
    *out = (struct gltf_buffers){grow_zeroed(count, sizeof *out->items), 0};
    for (; out->count < count; out->count++)
        if (!read_buffer(file, out->count, &out->items[out->count], err)) return false;
    return true;
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

static bool copy_values(const struct window *window, size_t component, bool normalised, size_t components,
                        struct gltf_array *out)
{
    const size_t element_b = components * size_of(component);
    if (out->count &&
        (window->size_b < element_b || (out->count - 1) > (window->size_b - element_b) / window->stride_b))
        return false;
    for (size_t i = 0; i < out->count; i++)
        for (size_t k = 0; k < components; k++)
            out->values[i * components + k] =
                number_at(window->bytes + i * window->stride_b + k * size_of(component), component, normalised);
    return true;
}

/* Those of a sparse accessor, in place of what the values were. */
static bool put_sparse(const struct gltf_file *file, const struct gltf_buffers *buffers, const json_t *sparse,
                       size_t component, bool normalised, size_t components, struct gltf_array *out)
{
    const json_t *indices = json_object_get(sparse, "indices"), *values = json_object_get(sparse, "values");
    struct window index_window, value_window;
    struct gltf_array places = {0}, numbers = {0};
    size_t kind, count;
    if (!gltf_index(sparse, "count", &count) || count > out->count || !gltf_index(indices, "componentType", &kind) ||
        !size_of(kind))
        return false;
    places = (struct gltf_array){grow_zeroed(count, sizeof(double)), count};
    numbers = (struct gltf_array){grow_zeroed(count * components, sizeof(double)), count};
    bool ok = window_of(file, buffers, indices, size_of(kind), &index_window) &&
              window_of(file, buffers, values, components * size_of(component), &value_window) &&
              copy_values(&index_window, kind, false, 1, &places) &&
              copy_values(&value_window, component, normalised, components, &numbers);
    for (size_t i = 0; ok && i < count; i++) {
        ok = places.values[i] >= 0 && places.values[i] < (double)out->count;
        if (ok)
            memcpy(&out->values[(size_t)places.values[i] * components], &numbers.values[i * components],
                   components * sizeof(double));
    }
    free(places.values);
    free(numbers.values);
    return ok;
}

bool gltf_array_read(const struct gltf_file *file, const struct gltf_buffers *buffers, size_t accessor,
                     size_t components, struct gltf_array *out)
{
    enum { MOST = 1 << 26 };
    static const char *const types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    const json_t *own = gltf_element(file, "accessors", accessor), *sparse = json_object_get(own, "sparse");
    const char *type = json_string_value(json_object_get(own, "type"));
    const bool normalised = json_is_true(json_object_get(own, "normalized"));
    struct window window;
    size_t component;
    *out = (struct gltf_array){0};
    if (!type || components > 4 || strcmp(type, types[components]) != 0) return false;
    if (!gltf_index(own, "componentType", &component) || !size_of(component)) return false;
    if (!gltf_index(own, "count", &out->count) || out->count > MOST) return false;
    out->values = grow_zeroed(out->count * components, sizeof(double));
    bool ok = true;
    if (json_object_get(own, "bufferView"))
        ok = window_of(file, buffers, own, components * size_of(component), &window) &&
             copy_values(&window, component, normalised, components, out);
    if (ok && sparse) ok = put_sparse(file, buffers, sparse, component, normalised, components, out);
    return ok;
}
