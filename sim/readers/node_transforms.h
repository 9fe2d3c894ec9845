/* SPDX-License-Identifier: MIT
 *
 * Where nodes are, in double: the importer library has float32. A glTF 2.0 file's transforms are decimals, and far
 * from the origin a node's translation is what carries the scene there. Of other formats it is what the library says.
 */
#ifndef SIM_NODE_TRANSFORMS_H
#define SIM_NODE_TRANSFORMS_H

#include "base/error.h"
#include "base/map.h"
#include "readers/gltf_file.h"

#include <assimp/scene.h>

struct node_transform {
    double m[3][4]; /* point = m * (x, y, z, 1), into its parent's coordinates */
};

struct node_transforms {
    struct node_transform *own; /* in any order */
    size_t count, capacity;
    struct map places; /* from a node's address to its place among them, from 1 */
};

struct node_transform node_transform_times(const struct node_transform *a, const struct node_transform *b);

/* Of a node of a glTF 2.0 file. */
struct node_transform node_transform_of_file(const json_t *node);

/* Pairs the file's nodes (NULL: it is none of glTF 2.0) with the library's. Refuses, naming the node, a file of which
 * the library made another tree, or transforms that are not the file's as near as float32 can be. */
bool node_transforms_read(const char *path, const struct gltf_file *file, const struct aiScene *scene,
                          struct node_transforms *out, struct error *err);
/* Whether the file's own are known. */
static inline bool node_transforms_are_double(const struct node_transforms *transforms)
{
    return transforms->count > 0;
}

struct node_transform node_transform_of(const struct node_transforms *transforms, const struct aiNode *node);
void node_transforms_free(struct node_transforms *transforms);

#endif
