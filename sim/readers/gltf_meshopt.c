/* SPDX-License-Identifier: MIT
 *
 * The library asserts what it is called with, so all of that is checked before. */
#include "readers/gltf_meshopt.h"

#include "base/grow.h"

#include <meshoptimizer.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* No byte stands for more than 64: what claims to be far larger is forged, and is not to get the memory. */
enum { UNPACKED_MOST_B = 1 << 28, STRIDE_MOST_B = 256, MOST_B_A_B = 256 };

struct packed {
    const unsigned char *bytes;
    size_t size_b, count, stride_b;
    const char *mode, *filter;
};

static const json_t *extension_of(const json_t *view)
{
    const json_t *all = json_object_get(view, "extensions"), *own = json_object_get(all, "EXT_meshopt_compression");
    return own ? own : json_object_get(all, "KHR_meshopt_compression");
}

static bool is(const char *word, const char *wanted)
{
    return strcmp(word, wanted) == 0;
}

static const char *word_of(const json_t *object, const char *name, const char *otherwise)
{
    const char *word = json_string_value(json_object_get(object, name));
    return word ? word : otherwise;
}

/* false: it leads out of its buffer. */
static bool packed_of(const struct gltf_buffers *buffers, const json_t *extension, struct packed *out)
{
    size_t buffer, start_b = 0;
    gltf_index(extension, "byteOffset", &start_b);
    if (!gltf_index(extension, "buffer", &buffer) || buffer >= buffers->count) return false;
    if (!gltf_index(extension, "byteLength", &out->size_b) || !gltf_index(extension, "count", &out->count) ||
        !gltf_index(extension, "byteStride", &out->stride_b))
        return false;
    const struct gltf_buffer *from = &buffers->items[buffer];
    if (!from->bytes || start_b > from->size_b || out->size_b > from->size_b - start_b) return false;
    out->bytes = (const unsigned char *)from->bytes + start_b;
    out->mode = word_of(extension, "mode", "");
    out->filter = word_of(extension, "filter", "NONE");
    return true;
}

/* What the library asserts. */
static bool is_sound(const struct packed *packed)
{
    const size_t stride_b = packed->stride_b;
    if (stride_b == 0 || stride_b > STRIDE_MOST_B || packed->count > UNPACKED_MOST_B / stride_b) return false;
    if (packed->count * stride_b / MOST_B_A_B > packed->size_b) return false;
    if (is(packed->mode, "ATTRIBUTES"))
        return stride_b % 4 == 0 && (is(packed->filter, "NONE") || is(packed->filter, "EXPONENTIAL") ||
                                     (is(packed->filter, "OCTAHEDRAL") && (stride_b == 4 || stride_b == 8)) ||
                                     (is(packed->filter, "QUATERNION") && stride_b == 8));
    if (!is(packed->filter, "NONE") || (stride_b != 2 && stride_b != 4)) return false;
    return is(packed->mode, "INDICES") || (is(packed->mode, "TRIANGLES") && packed->count % 3 == 0);
}

static bool unpack(const struct packed *packed, void *out)
{
    if (is(packed->mode, "TRIANGLES"))
        return meshopt_decodeIndexBuffer(out, packed->count, packed->stride_b, packed->bytes, packed->size_b) == 0;
    if (is(packed->mode, "INDICES"))
        return meshopt_decodeIndexSequence(out, packed->count, packed->stride_b, packed->bytes, packed->size_b) == 0;
    if (meshopt_decodeVertexBuffer(out, packed->count, packed->stride_b, packed->bytes, packed->size_b) != 0)
        return false;
    if (is(packed->filter, "OCTAHEDRAL")) meshopt_decodeFilterOct(out, packed->count, packed->stride_b);
    if (is(packed->filter, "QUATERNION")) meshopt_decodeFilterQuat(out, packed->count, packed->stride_b);
    if (is(packed->filter, "EXPONENTIAL")) meshopt_decodeFilterExp(out, packed->count, packed->stride_b);
    return true;
}

static void mend(json_t *view, size_t buffer, const struct packed *packed)
{
    json_object_set_new(view, "buffer", json_integer((json_int_t)buffer));
    json_object_set_new(view, "byteLength", json_integer((json_int_t)(packed->count * packed->stride_b)));
    json_object_del(view, "byteOffset");
    if (is(packed->mode, "ATTRIBUTES"))
        json_object_set_new(view, "byteStride", json_integer((json_int_t)packed->stride_b));
    else
        json_object_del(view, "byteStride");
    json_object_del(view, "extensions"); /* last: it holds the mode */
}

static bool decode_view(const char *path, size_t index, json_t *view, struct gltf_buffers *buffers, struct error *err)
{
    struct packed packed;
    if (!packed_of(buffers, extension_of(view), &packed))
        return error_set(err, "%s: view %zu of its buffers is packed, and leads out of its buffer", path, index);
    if (!is_sound(&packed))
        return error_set(err, "%s: view %zu of its buffers is packed in a way that is not read (%s, %s)", path, index,
                         packed.mode, packed.filter);
    struct gltf_buffer out = {.size_b = packed.count * packed.stride_b};
    out.bytes = out.owned = grow_zeroed(out.size_b, 1);
    if (!unpack(&packed, out.owned)) {
        free(out.owned);
        return error_set(err, "%s: view %zu of its buffers is packed, and damaged or of a newer kind", path, index);
    }
    mend(view, gltf_buffers_add(buffers, &out), &packed);
    return true;
}

bool gltf_meshopt_decode(const char *path, const struct gltf_file *file, struct gltf_buffers *buffers,
                         struct error *err)
{
    size_t index;
    json_t *view;
    json_array_foreach(json_object_get(file->root, "bufferViews"), index, view)
    {
        if (extension_of(view) && !decode_view(path, index, view, buffers, err)) return false;
    }
    return true;
}
