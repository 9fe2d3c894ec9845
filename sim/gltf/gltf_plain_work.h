/* SPDX-License-Identifier: MIT
 *
 * What the makers of a plain glTF file (gltf_plain.h) share: the file, whose JSON they rewrite in place, and its fresh
 * buffer. */
#ifndef SIM_GLTF_PLAIN_WORK_H
#define SIM_GLTF_PLAIN_WORK_H

#include "gltf/gltf_numbers.h"
#include "gltf/gltf_output.h"
#include "gltf/gltf_plain.h"
#include "model/model.h"

/* Which coordinates a texture is seen by: KHR_texture_transform's turn, scale and offset of one of the sets. */
struct gltf_uvs {
    bool is_used;
    size_t set;
    double rows[2][3]; /* u, v = rows * (u, v, 1) */
};

/* The same for a material: of its colour's texture, and of what it emits. */
enum { GLTF_COLOUR, GLTF_EMISSION, GLTF_LOOKS };

struct gltf_look {
    struct gltf_uvs uvs[GLTF_LOOKS];
    unsigned sets[GLTF_LOOKS]; /* of the plain file's */
};

struct gltf_work {
    const char *path;
    struct gltf_file *file;
    struct gltf_buffers buffers;
    struct gltf_output out;
    struct gltf_look *looks; /* of each material */
    size_t look_count;
    struct gltf_plain *plain;
    struct model *model;
    struct error *err;
};

/* Materials have a colour, an emission, what textures these have, and no more: looks are set. What pictures textures
 * show is what libgd reads. */
void gltf_plain_materials(struct gltf_work *work);

/* Instances become children of their nodes, in front of the others. */
bool gltf_plain_instances(struct gltf_work *work);

/* Nodes have a place, a mesh and children, and no more. */
void gltf_plain_nodes(struct gltf_work *work);

/* Primitives have positions, coordinates of textures and colours; keys of animations are float32. */
bool gltf_plain_meshes(struct gltf_work *work);
bool gltf_plain_animations(struct gltf_work *work);

/* The list that an accessor has, of elements of 1 to 4 numbers; an error names it as `what` of element `index` of the
 * root's array `array`. */
bool gltf_plain_read(struct gltf_work *work, size_t accessor, const char *array, size_t index, const char *what,
                     size_t components, struct gltf_array *out);

/* How many numbers an element of an accessor has; 0: it is not there, or a matrix. */
size_t gltf_plain_components(const struct gltf_work *work, size_t accessor);

#endif
