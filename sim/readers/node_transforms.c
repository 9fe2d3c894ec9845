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

/* The columns of a quaternion's rotation, x, y, z, w. */
static void rotate(const double q[4], double m[3][4])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        m[i][i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]);
        m[j][i] = 2 * (q[i] * q[j] + q[k] * q[3]);
        m[k][i] = 2 * (q[i] * q[k] - q[j] * q[3]);
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
    if (gltf_numbers(node, "rotation", 4, quaternion)) rotate(quaternion, out.m);
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

static bool pair(struct pairing *work, const struct aiNode *node, const json_t *own)
{
    struct node_transforms *out = work->out;
    const struct node_transform library = of_library(&node->mTransformation), file = node_transform_of_file(own);
    if (!agrees(&file, &library))
        return error_set(work->err, "%s: node '%s': its transform is beyond float32, or not a transform", work->path,
                         node->mName.data);
    out->own = grow(out->own, out->count, &out->capacity, sizeof *out->own);
    out->own[out->count++] = file;
    *map_at(&out->places, (uintptr_t)node, 0) = (uint32_t)out->count;
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
        if (!pair(work, nodes[i], own)) return false;
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
    return !file || !scene->mRootNode || pair_tree(&work, scene->mRootNode);
}

struct node_transform node_transform_of(const struct node_transforms *transforms, const struct aiNode *node)
{
    const uint32_t *place = map_find(&transforms->places, (uintptr_t)node);
    return place ? transforms->own[*place - 1] : of_library(&node->mTransformation);
}

void node_transforms_free(struct node_transforms *transforms)
{
    free(transforms->own);
    map_free(&transforms->places);
    *transforms = (struct node_transforms){0};
}
