/* SPDX-License-Identifier: MIT
 *
 * The library makes a node of each node of the file, children in their order. A scene's only node is its root; several
 * get one above them. */
#include "readers/node_transforms.h"

#include "base/grow.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

struct pairing {
    const char *path;
    const struct gltf_file *file;
    struct node_transforms *out;
    struct error *err;
};

static struct node_transform of_library(const struct aiMatrix4x4 *m)
{
    return (struct node_transform){
        {{m->a1, m->a2, m->a3, m->a4}, {m->b1, m->b2, m->b3, m->b4}, {m->c1, m->c2, m->c3, m->c4}}};
}

struct node_transform node_transform_times(const struct node_transform *a, const struct node_transform *b)
{
    struct node_transform out;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 4; column++) {
            double sum = column == 3 ? a->m[row][3] : 0;
            for (int k = 0; k < 3; k++)
                sum += a->m[row][k] * b->m[k][column];
            out.m[row][column] = sum;
        }
    return out;
}

void node_transform_rotate(const double turn[4], struct node_transform *out)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out->m[i][i] = 1 - 2 * (turn[j] * turn[j] + turn[k] * turn[k]);
        out->m[j][i] = 2 * (turn[i] * turn[j] + turn[k] * turn[3]);
        out->m[k][i] = 2 * (turn[i] * turn[k] - turn[j] * turn[3]);
    }
}

struct node_transform node_transform_of_file(const json_t *node)
{
    struct node_transform out = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    double matrix[16], quaternion[4], scale[3] = {1, 1, 1}, at[3] = {0, 0, 0};
    if (json_object_get(node, "matrix")) {
        for (int i = 0; i < 12 && gltf_numbers(node, "matrix", 16, matrix); i++)
            out.m[i % 3][i / 3] = matrix[i / 3 * 4 + i % 3];
        return out;
    }
    if (gltf_numbers(node, "rotation", 4, quaternion)) node_transform_rotate(quaternion, &out);
    gltf_numbers(node, "scale", 3, scale);
    gltf_numbers(node, "translation", 3, at);
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            out.m[row][column] *= scale[column];
        out.m[row][3] = at[row];
    }
    return out;
}

/* Written so that NaN is no agreement. */
static bool agrees(const struct node_transform *a, const struct node_transform *b)
{
    double most = 1;
    for (int i = 0; i < 12; i++)
        most = fmax(most, fabs(a->m[i / 4][i % 4]));
    for (int i = 0; i < 12; i++)
        if (!(fabs(a->m[i / 4][i % 4] - b->m[i / 4][i % 4]) <= 1e-5 * most)) return false;
    return true;
}

static bool pair_all(struct pairing *work, struct aiNode *const *nodes, unsigned count, const json_t *indices);

static bool pair(struct pairing *work, const struct aiNode *node, const json_t *own, size_t number)
{
    const struct node_transform library = of_library(&node->mTransformation), file = node_transform_of_file(own);
    if (!agrees(&file, &library))
        return error_set(work->err, "%s: node '%s': its transform is beyond float32, or not a transform", work->path,
                         node->mName.data);
    node_transform_set(work->out, node, &file);
    const uint32_t place = *map_find(&work->out->places, (uintptr_t)node);
    *map_at(&work->out->file_nodes, number, 0) = place;
    work->out->nodes[place - 1].number = (uint32_t)number + 1;
    return pair_all(work, node->mChildren, node->mNumChildren, json_object_get(own, "children"));
}

static bool pair_all(struct pairing *work, struct aiNode *const *nodes, unsigned count, const json_t *indices)
{
    if (json_array_size(indices) != count)
        return error_set(work->err, "%s: its nodes are no tree that the importer understands", work->path);
    for (unsigned i = 0; i < count; i++) {
        const json_t *index = json_array_get(indices, i);
        const json_t *own = json_is_integer(index) && json_integer_value(index) >= 0
                                ? gltf_element(work->file, "nodes", (size_t)json_integer_value(index))
                                : NULL;
        if (!own) return error_set(work->err, "%s: a node that it names is not in it", work->path);
        if (!pair(work, nodes[i], own, (size_t)json_integer_value(index))) return false;
    }
    return true;
}

static bool pair_tree(struct pairing *work, struct aiNode *root)
{
    const json_t *indices = gltf_scene_nodes(work->file);
    if (json_array_size(indices) == 1) return pair_all(work, &root, 1, indices);
    return pair_all(work, root->mChildren, root->mNumChildren, indices);
}

bool node_transforms_read(const char *path, const struct gltf_file *file, const struct aiScene *scene,
                          struct node_transforms *out, struct error *err)
{
    struct pairing work = {path, file, out, err};
    *out = (struct node_transforms){0};
    out->are_double = file != NULL;
    return !file || !scene->mRootNode || pair_tree(&work, scene->mRootNode);
}

struct node_transform node_transform_of(const struct node_transforms *transforms, const struct aiNode *node)
{
    const uint32_t *place = map_find(&transforms->places, (uintptr_t)node);
    return place ? transforms->nodes[*place - 1].own : of_library(&node->mTransformation);
}

const struct aiNode *node_transforms_node(const struct node_transforms *transforms, size_t number)
{
    const uint32_t *place = map_find(&transforms->file_nodes, number);
    return place ? transforms->nodes[*place - 1].node : NULL;
}

uint32_t node_transforms_number(const struct node_transforms *transforms, const struct aiNode *node)
{
    const uint32_t *place = map_find(&transforms->places, (uintptr_t)node);
    return place ? transforms->nodes[*place - 1].number : 0;
}

void node_transform_set(struct node_transforms *transforms, const struct aiNode *node, const struct node_transform *own)
{
    uint32_t *place = map_at(&transforms->places, (uintptr_t)node, 0);
    if (!*place) {
        transforms->nodes =
            grow(transforms->nodes, transforms->count, &transforms->capacity, sizeof *transforms->nodes);
        transforms->nodes[transforms->count] = (struct placed_node){.number = 0};
        *place = (uint32_t)++transforms->count;
    }
    transforms->nodes[*place - 1].node = node;
    transforms->nodes[*place - 1].own = *own;
}

void node_transforms_free(struct node_transforms *transforms)
{
    free(transforms->nodes);
    map_free(&transforms->places);
    map_free(&transforms->file_nodes);
    *transforms = (struct node_transforms){0};
}
