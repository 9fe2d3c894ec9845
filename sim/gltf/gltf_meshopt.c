/* SPDX-License-Identifier: MIT
 *
 * The library asserts what it is called with, so all of that is checked before. */
#include "gltf/gltf_meshopt.h"

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

bool gltf_meshopt_is_packed(const json_t *view)
{
    return extension_of(view);
}

bool gltf_meshopt_buffer(const json_t *view, size_t *buffer)
{
    return gltf_index(extension_of(view), "buffer", buffer);
}

static struct packed packed_of(const json_t *extension)
{
    struct packed out = {.mode = word_of(extension, "mode", ""), .filter = word_of(extension, "filter", "NONE")};
    gltf_index(extension, "byteLength", &out.size_b);
    gltf_index(extension, "count", &out.count);
    gltf_index(extension, "byteStride", &out.stride_b);
    return out;
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

bool gltf_meshopt_unpack(const json_t *view, const char *bytes, size_t bytes_b, void **out, size_t *out_b,
                         struct error *err)
{
    const json_t *extension = extension_of(view);
    struct packed packed = packed_of(extension);
    size_t start_b = 0;
    gltf_index(extension, "byteOffset", &start_b);
    if (!bytes || start_b > bytes_b || packed.size_b > bytes_b - start_b)
        return error_set(err, "it is packed, and leads out of its buffer");
    packed.bytes = (const unsigned char *)bytes + start_b;
    if (!is_sound(&packed))
        return error_set(err, "it is packed in a way that is not read (%s, %s)", packed.mode, packed.filter);
    *out_b = packed.count * packed.stride_b;
    *out = grow_zeroed(*out_b, 1);
    if (unpack(&packed, *out)) return true;
    free(*out);
    return error_set(err, "it is packed, and damaged or of a newer kind");
}

void gltf_meshopt_mend(json_t *view, size_t buffer)
{
    const struct packed packed = packed_of(extension_of(view));
    json_object_set_new(view, "buffer", json_integer((json_int_t)buffer));
    json_object_set_new(view, "byteLength", json_integer((json_int_t)(packed.count * packed.stride_b)));
    json_object_del(view, "byteOffset");
    if (is(packed.mode, "ATTRIBUTES"))
        json_object_set_new(view, "byteStride", json_integer((json_int_t)packed.stride_b));
    else
        json_object_del(view, "byteStride");
    json_object_del(view, "extensions"); /* last: it holds the mode */
}
