/* SPDX-License-Identifier: MIT
 *
 * EXT_mesh_gpu_instancing: a mesh that is drawn once for each entry of lists of translations, rotations and scales. */
#include "gltf/gltf_plain_work.h"

#include <math.h>
#include <stdlib.h>

enum { NODES_MOST = 1 << 20 }; /* as many as faces */

static const struct {
    const char *list, *member;
    size_t components;
} PARTS[] = {{"TRANSLATION", "translation", 3}, {"ROTATION", "rotation", 4}, {"SCALE", "scale", 3}};
enum { PART_COUNT = sizeof PARTS / sizeof *PARTS, ROTATION = 1 };

struct instances {
    struct gltf_array parts[PART_COUNT];
    size_t count;
};

static const json_t *attributes_of(const json_t *node)
{
    return json_object_get(json_object_get(json_object_get(node, "extensions"), "EXT_mesh_gpu_instancing"),
                           "attributes");
}

static bool are_numbers(const struct gltf_array *array, size_t components)
{
    for (size_t i = 0; i < array->count * components; i++)
        if (!isfinite(array->values[i])) return false;
    return true;
}

/* Lists that are there must be of one length. */
static bool read_lists(struct gltf_work *work, size_t index, const json_t *attributes, struct instances *out)
{
    bool any = false;
    *out = (struct instances){.count = 1};
    for (size_t i = 0; i < PART_COUNT; i++) {
        size_t accessor;
        if (!gltf_index(attributes, PARTS[i].list, &accessor)) continue;
        struct gltf_array *part = &out->parts[i];
        if (!gltf_plain_read(work, accessor, "nodes", index, PARTS[i].list, PARTS[i].components, part)) return false;
        if (any && part->count != out->count)
            return error_set(work->err, "%s: nodes[%zu]: the lists of its instances differ in length", work->path,
                             index);
        if (!are_numbers(part, PARTS[i].components))
            return error_set(work->err, "%s: nodes[%zu]: the %s of an instance is NaN or infinite", work->path, index,
                             PARTS[i].member);
        out->count = part->count;
        any = true;
    }
    return true;
}

/* Quantised rotations are not of unit length. */
static void make_unit(double *turn)
{
    const double length = sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
    for (int i = 0; i < 4 && length > 0; i++)
        turn[i] /= length;
}

static json_t *instance(const struct instances *instances, size_t number, json_t *mesh)
{
    json_t *node = json_object();
    json_object_set(node, "mesh", mesh);
    for (size_t i = 0; i < PART_COUNT; i++) {
        if (!instances->parts[i].values) continue;
        double *values = &instances->parts[i].values[number * PARTS[i].components];
        json_t *list = json_array();
        if (i == ROTATION) make_unit(values);
        for (size_t k = 0; k < PARTS[i].components; k++)
            json_array_append_new(list, json_real(values[k]));
        json_object_set_new(node, PARTS[i].member, list);
    }
    return node;
}

static bool add_children(struct gltf_work *work, json_t *node, const struct instances *instances)
{
    json_t *nodes = json_object_get(work->file->root, "nodes"), *mesh = json_object_get(node, "mesh");
    if (json_array_size(nodes) + instances->count > NODES_MOST)
        return error_set(work->err, "%s: more than %d nodes and instances", work->path, NODES_MOST);
    json_t *children = json_array();
    for (size_t i = 0; i < instances->count; i++) {
        json_array_append_new(children, json_integer((json_int_t)json_array_size(nodes)));
        json_array_append_new(nodes, instance(instances, i, mesh));
    }
    json_array_extend(children, json_object_get(node, "children"));
    json_object_set_new(node, "children", children);
    json_object_del(node, "mesh");
    return true;
}

static bool place_instances(struct gltf_work *work, size_t index, json_t *node)
{
    struct instances instances;
    const json_t *attributes = attributes_of(node);
    if (!attributes || !json_object_get(node, "mesh")) return true;
    const bool ok = read_lists(work, index, attributes, &instances) && add_children(work, node, &instances);
    for (size_t i = 0; i < PART_COUNT; i++)
        free(instances.parts[i].values);
    return ok;
}

bool gltf_plain_instances(struct gltf_work *work)
{
    const size_t count = json_array_size(json_object_get(work->file->root, "nodes"));
    for (size_t i = 0; i < count; i++)
        if (!place_instances(work, i, gltf_element(work->file, "nodes", i))) return false;
    return true;
}
