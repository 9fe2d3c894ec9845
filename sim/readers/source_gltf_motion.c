/* SPDX-License-Identifier: MIT */
#include "readers/source_gltf_motion.h"

#include "base/grow.h"
#include "readers/import_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const PARTS[SOURCE_PARTS] = {"translation", "rotation", "scale"};

/* Numbers ------------------------------------------------------------------------------------ */

/* So many bytes somewhere in a view; NULL: they are not there. */
static const unsigned char *bytes_of(const struct gltf_file *file, const struct gltf_buffers *buffers, const json_t *in,
                                     size_t index, size_t tight_b, size_t wanted_b, size_t inner_b)
{
    size_t number, buffer, stride_b = 0, view_at = 0, own_at = 0;
    if (!gltf_index(in, "bufferView", &number)) return NULL;
    const json_t *view = gltf_element(file, "bufferViews", number);
    if (!gltf_index(view, "buffer", &buffer) || buffer >= buffers->count) return NULL;
    if (!gltf_index(view, "byteStride", &stride_b)) stride_b = tight_b;
    gltf_index(view, "byteOffset", &view_at);
    gltf_index(in, "byteOffset", &own_at);
    const size_t size_b = buffers->items[buffer].size_b;
    if (view_at > size_b || own_at > size_b || (stride_b && index > size_b / stride_b)) return NULL;
    const size_t at = view_at + own_at + index * stride_b + inner_b;
    if (at > size_b || wanted_b > size_b - at) return NULL;
    return (const unsigned char *)buffers->items[buffer].bytes + at;
}

static size_t width_b(size_t kind)
{
    static const unsigned char widths_b[] = {1, 1, 2, 2, 0, 4, 4};
    return kind >= 5120 && kind <= 5126 ? widths_b[kind - 5120] : 0;
}

static double number_of(const unsigned char *at, size_t kind, bool is_share)
{
    float real;
    const unsigned low = at[0] | (width_b(kind) > 1 ? (unsigned)at[1] << 8 : 0);
    switch (kind) {
    case 5120:
        return is_share ? fmax(-1, (double)(signed char)at[0] / 127) : (double)(signed char)at[0];
    case 5121:
        return is_share ? low / 255.0 : low;
    case 5122:
        return is_share ? fmax(-1, (double)(short)low / 32767) : (double)(short)low;
    case 5123:
        return is_share ? low / 65535.0 : low;
    case 5125:
        return low + 65536.0 * (at[2] | (unsigned)at[3] << 8);
    default:
        memcpy(&real, at, sizeof real); /* hosts have the file's order of bytes */
        return (double)real;
    }
}

/* Which of a sparse accessor's places is the element's, from 1; they ascend. 0: none. */
static size_t sparse_place(const struct gltf_file *file, const struct gltf_buffers *buffers, const json_t *sparse,
                           size_t element)
{
    const json_t *indices = json_object_get(sparse, "indices");
    size_t low = 0, high = 0, kind = 0;
    gltf_index(indices, "componentType", &kind);
    gltf_index(sparse, "count", &high);
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        const unsigned char *at = bytes_of(file, buffers, indices, middle, width_b(kind), width_b(kind), 0);
        if (!at || !width_b(kind)) return 0;
        const double place = number_of(at, kind, false);
        if (place == (double)element) return middle + 1;
        if (place < (double)element)
            low = middle + 1;
        else
            high = middle;
    }
    return 0;
}

/* One number of an accessor; NaN: it is not there. */
static double read_number(const struct gltf_file *file, const struct gltf_buffers *buffers, const json_t *accessor,
                          size_t element, size_t width, size_t which)
{
    const json_t *sparse = json_object_get(accessor, "sparse"), *in = accessor;
    size_t kind = 0;
    gltf_index(accessor, "componentType", &kind);
    const size_t own_b = width_b(kind), place = sparse_place(file, buffers, sparse, element);
    if (place) {
        in = json_object_get(sparse, "values");
        element = place - 1;
    } else if (sparse && !json_object_get(accessor, "bufferView")) {
        return 0;
    }
    const unsigned char *at = bytes_of(file, buffers, in, element, width * own_b, own_b, which * own_b);
    return at && own_b ? number_of(at, kind, json_is_true(json_object_get(accessor, "normalized"))) : NAN;
}

/* Keys --------------------------------------------------------------------------------------- */

static double *read_all(const struct gltf_file *file, const struct gltf_buffers *buffers, const json_t *accessor,
                        size_t width, size_t count)
{
    double *numbers = grow_zeroed(count * width, sizeof *numbers);
    for (size_t i = 0; i < count * width; i++)
        numbers[i] = read_number(file, buffers, accessor, i / width, width, i % width);
    return numbers;
}

static enum source_joined joined_of(const json_t *sampler)
{
    const char *name = json_string_value(json_object_get(sampler, "interpolation"));
    if (name && strcmp(name, "STEP") == 0) return JOINED_BY_STEPS;
    return name && strcmp(name, "CUBICSPLINE") == 0 ? JOINED_BY_SPLINES : JOINED_EVENLY;
}

/* Buffers have no more than their bytes, whatever an accessor says. */
static struct source_keys read_keys(const struct gltf_file *file, const struct gltf_buffers *buffers,
                                    const json_t *sampler, size_t width)
{
    enum { MOST = 1 << 22 };
    struct source_keys keys = {.width = width, .joined = joined_of(sampler)};
    size_t input, output, values;
    if (!gltf_index(sampler, "input", &input) || !gltf_index(sampler, "output", &output)) return keys;
    const json_t *times = gltf_element(file, "accessors", input), *numbers = gltf_element(file, "accessors", output);
    if (!gltf_index(times, "count", &keys.count) || !gltf_index(numbers, "count", &values) || values > MOST ||
        values != keys.count * (keys.joined == JOINED_BY_SPLINES ? 3 : 1))
        keys.count = 0;
    if (!keys.count) return keys;
    keys.times_s = read_all(file, buffers, times, 1, keys.count);
    keys.numbers = read_all(file, buffers, numbers, width, values);
    return keys;
}

static void keep(struct source_node *node, enum source_part part)
{
    struct source_keys *keys = &node->keys[part];
    double value[4] = {0}, apart = 0, most = 0;
    source_keys_at(keys, 0, value);
    for (size_t i = 0; i < keys->width; i++) {
        apart = fmax(apart, fabs(value[i] - node->parts[part][i]));
        most = fmax(most, fabs(value[i]));
    }
    node->kept[part] = apart > 2e-7 * most; /* a decimal that became a float32 is still the decimal */
    if (node->kept[part]) memcpy(node->parts[part], value, sizeof value);
    free(keys->times_s);
    free(keys->numbers);
    *keys = (struct source_keys){0};
}

/* Of two for one part that which moves counts, then the first. */
static void take(struct source_node *node, enum source_part part, struct source_keys keys)
{
    struct source_keys *had = &node->keys[part], other = keys;
    if (!had->count || (!source_keys_vary(had) && keys.count && source_keys_vary(&keys))) {
        other = *had;
        *had = keys;
    }
    free(other.times_s);
    free(other.numbers);
}

static void read_channel(const struct gltf_file *file, const struct gltf_buffers *buffers, const json_t *animation,
                         const json_t *channel, struct source_motion *out)
{
    const json_t *target = json_object_get(channel, "target");
    const char *path = json_string_value(json_object_get(target, "path"));
    size_t node, sampler, part = 0;
    while (part < SOURCE_PARTS && !(path && strcmp(path, PARTS[part]) == 0))
        part++;
    if (part == SOURCE_PARTS || !gltf_index(target, "node", &node) || node >= out->count ||
        !gltf_index(channel, "sampler", &sampler))
        return;
    const json_t *from = json_array_get(json_object_get(animation, "samplers"), sampler);
    take(&out->nodes[node], (enum source_part)part, read_keys(file, buffers, from, part == SOURCE_TURN ? 4 : 3));
}

/* Nodes -------------------------------------------------------------------------------------- */

static void read_node(const json_t *from, struct source_node *to)
{
    to->parts[SOURCE_TURN][3] = 1;
    for (int i = 0; i < 3; i++)
        to->parts[SOURCE_SCALE][i] = 1;
    to->has_matrix = gltf_numbers(from, "matrix", 16, to->matrix);
    for (int part = 0; part < SOURCE_PARTS; part++)
        gltf_numbers(from, PARTS[part], part == SOURCE_TURN ? 4 : 3, to->parts[part]);
}

static void read_nodes(const json_t *nodes, struct source_motion *out)
{
    size_t i, k;
    const json_t *node, *child;
    json_array_foreach(nodes, i, node)
    {
        read_node(node, &out->nodes[i]);
        json_array_foreach(json_object_get(node, "children"), k, child)
        {
            const size_t below = (size_t)json_integer_value(child);
            if (json_is_integer(child) && below < out->count) out->nodes[below].above = i + 1;
        }
    }
}

/* Whether it hangs in the scene that is shown. */
static bool is_shown(const struct source_motion *motion, size_t node, const json_t *scene)
{
    size_t i;
    const json_t *root;
    for (size_t steps = 0; motion->nodes[node].above && steps < motion->count; steps++)
        node = motion->nodes[node].above - 1;
    json_array_foreach(scene, i, root)
    {
        if (json_integer_value(root) == (json_int_t)node) return true;
    }
    return false;
}

static void find_end(const struct gltf_file *file, struct source_motion *out)
{
    for (size_t n = 0; n < out->count; n++)
        for (int part = 0; part < SOURCE_PARTS; part++) {
            const struct source_keys *keys = &out->nodes[n].keys[part];
            if (keys->count && is_shown(out, n, gltf_scene_nodes(file)))
                out->end_s = fmax(out->end_s, keys->times_s[keys->count - 1]);
        }
}

/* The scale of what moves stays, or the importer refuses it. A matrix is not in parts. */
static bool settle(struct source_node *node)
{
    for (int part = 0; part < SOURCE_PARTS; part++) {
        if (!node->keys[part].count) continue;
        if (node->has_matrix) return false;
        if (part == SOURCE_SCALE || !source_keys_vary(&node->keys[part])) keep(node, (enum source_part)part);
    }
    return true;
}

void source_gltf_motion_read(const struct gltf_file *file, const struct gltf_buffers *buffers,
                             struct source_motion *out)
{
    size_t i, k;
    const json_t *animation, *channel, *nodes = json_object_get(file->root, "nodes");
    *out = (struct source_motion){.nodes = grow_zeroed(json_array_size(nodes), sizeof *out->nodes),
                                  .count = json_array_size(nodes)};
    read_nodes(nodes, out);
    json_array_foreach(json_object_get(file->root, "animations"), i, animation)
    {
        if (motions_are_left_out()) break;
        json_array_foreach(json_object_get(animation, "channels"), k, channel)
            read_channel(file, buffers, animation, channel, out);
    }
    find_end(file, out);
    bool ok = true;
    for (size_t n = 0; ok && n < out->count; n++)
        ok = settle(&out->nodes[n]);
    if (!ok) source_motion_free(out);
}
