/* SPDX-License-Identifier: MIT
 *
 * Where nodes are, in double: the importer library has float32. A glTF 2.0 file's transforms are decimals, and far
 * from the origin a node's translation is what carries the scene there. Of other formats it is what the library says.
 */
#ifndef SIM_NODE_TRANSFORMS_H
#define SIM_NODE_TRANSFORMS_H

#include "base/error.h"
#include "base/map.h"
#include "gltf/gltf_file.h"

#include <assimp/scene.h>

struct node_transform {
    double m[3][4]; /* point = m * (x, y, z, 1), into its parent's coordinates */
};

struct placed_node {
    const struct aiNode *node;
    struct node_transform own;
    uint32_t number; /* in a glTF file, from 1; 0: it has none */
};

struct node_transforms {
    struct placed_node *nodes; /* in any order */
    size_t count, capacity;
    struct map places;     /* from a node's address to its place among them, from 1 */
    struct map file_nodes; /* from a glTF file's number of a node to its place, from 1 */
    bool are_double;       /* the file's own are known */
};

struct node_transform node_transform_times(const struct node_transform *a, const struct node_transform *b);

/* Of a node of a glTF 2.0 file. */
struct node_transform node_transform_of_file(const json_t *node);

/* Pairs the file's nodes (NULL: it is none of glTF 2.0) with the library's. Refuses, naming the node, a file of which
 * the library made another tree, or transforms that are not the file's as near as float32 can be. */
bool node_transforms_read(const char *path, const struct gltf_file *file, const struct aiScene *scene,
                          struct node_transforms *out, struct error *err);

struct node_transform node_transform_of(const struct node_transforms *transforms, const struct aiNode *node);

/* The library's node for a glTF file's number of one; NULL: the scene that is shown has none. */
const struct aiNode *node_transforms_node(const struct node_transforms *transforms, size_t number);

/* The other way, from 1; 0: it is in no such file. */
uint32_t node_transforms_number(const struct node_transforms *transforms, const struct aiNode *node);

/* From here on the node is there. */
void node_transform_set(struct node_transforms *transforms, const struct aiNode *node,
                        const struct node_transform *own);

/* The columns of a rotation by a unit quaternion x, y, z, w. */
void node_transform_rotate(const double turn[4], struct node_transform *out);

void node_transforms_free(struct node_transforms *transforms);

#endif
