/* SPDX-License-Identifier: MIT */
#include "gltf/gltf_output.h"

#include "base/grow.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { FLOAT = 5126, UNSIGNED_INT = 5125, ALIGNED_B = 4 };
static const uint32_t MAGIC = 0x46546C67, VERSION = 2, JSON_CHUNK = 0x4E4F534A, BINARY_CHUNK = 0x004E4942;

void gltf_output_begin(struct gltf_output *out)
{
    *out = (struct gltf_output){.accessors = json_array(), .views = json_array()};
}

/* Room for so many bytes more, at a multiple of four. */
static char *extend(struct gltf_output *out, size_t size_b)
{
    const size_t padded_b = (size_b + ALIGNED_B - 1) / ALIGNED_B * ALIGNED_B, at_b = out->size_b;
    while (out->capacity_b - out->size_b < padded_b)
        out->bytes = grow(out->bytes, out->capacity_b, &out->capacity_b, 1);
    memset(out->bytes + at_b, 0, padded_b);
    out->size_b += padded_b;
    return out->bytes + at_b;
}

size_t gltf_output_view(struct gltf_output *out, const void *bytes, size_t size_b)
{
    const size_t at_b = out->size_b;
    memcpy(extend(out, size_b), bytes, size_b);
    json_array_append_new(out->views, json_pack("{s:i, s:I, s:I}", "buffer", 0, "byteOffset", (json_int_t)at_b,
                                                "byteLength", (json_int_t)size_b));
    return json_array_size(out->views) - 1;
}

size_t gltf_output_accessor(struct gltf_output *out, json_t *taken)
{
    json_array_append_new(out->accessors, taken);
    return json_array_size(out->accessors) - 1;
}

static size_t add_accessor(struct gltf_output *out, size_t view, int component, size_t count, size_t components)
{
    static const char *const types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    return gltf_output_accessor(out, json_pack("{s:I, s:i, s:I, s:s}", "bufferView", (json_int_t)view, "componentType",
                                               component, "count", (json_int_t)count, "type", types[components]));
}

size_t gltf_output_floats(struct gltf_output *out, const float *values, size_t count, size_t components)
{
    const size_t view = gltf_output_view(out, values, count * components * sizeof *values);
    return add_accessor(out, view, FLOAT, count, components);
}

size_t gltf_output_indices(struct gltf_output *out, const double *values, size_t count)
{
    uint32_t *whole = grow_zeroed(count, sizeof *whole);
    for (size_t i = 0; i < count; i++)
        whole[i] = (uint32_t)values[i];
    const size_t view = gltf_output_view(out, whole, count * sizeof *whole);
    free(whole);
    return add_accessor(out, view, UNSIGNED_INT, count, 1);
}

/* Hosts have the file's order of bytes. */
static char *put_words(char *at, const uint32_t *words, size_t count)
{
    memcpy(at, words, count * sizeof *words);
    return at + count * sizeof *words;
}

static bool join(const char *text, const struct gltf_output *out, struct whole_file *glb)
{
    const size_t text_b = strlen(text), padded_b = (text_b + ALIGNED_B - 1) / ALIGNED_B * ALIGNED_B;
    const size_t size_b = 7 * sizeof(uint32_t) + padded_b + out->size_b;
    char *at = size_b <= UINT32_MAX ? malloc(size_b) : NULL;
    if (!at) return false;
    *glb = (struct whole_file){at, size_b};
    at = put_words(at, (const uint32_t[]){MAGIC, VERSION, (uint32_t)size_b, (uint32_t)padded_b, JSON_CHUNK}, 5);
    memset(at, ' ', padded_b);
    memcpy(at, text, text_b);
    at = put_words(at + padded_b, (const uint32_t[]){(uint32_t)out->size_b, BINARY_CHUNK}, 2);
    if (out->size_b) memcpy(at, out->bytes, out->size_b);
    return true;
}

bool gltf_output_write(struct gltf_output *out, json_t *root, struct whole_file *glb)
{
    json_object_set_new(root, "accessors", out->accessors);
    json_object_set_new(root, "bufferViews", out->views);
    out->accessors = out->views = NULL;
    json_object_set_new(root, "buffers", json_pack("[{s:I}]", "byteLength", (json_int_t)out->size_b));
    char *text = json_dumps(root, JSON_COMPACT);
    const bool ok = text && join(text, out, glb);
    free(text);
    return ok;
}

void gltf_output_free(struct gltf_output *out)
{
    free(out->bytes);
    json_decref(out->accessors);
    json_decref(out->views);
    *out = (struct gltf_output){0};
}
