/* SPDX-License-Identifier: MIT
 *
 * A glTF 2.0 file's JSON, and the buffer that a .glb has behind it: at a multiple of four bytes, as the format has it,
 * or straight behind the JSON, as some programs write it. */
#ifndef SIM_GLTF_FILE_H
#define SIM_GLTF_FILE_H

#include "files/whole_file.h"

#include <jansson.h>

struct gltf_file {
    json_t *root;
    const char *binary; /* of the .glb; NULL: there is none */
    size_t binary_b;
    struct whole_file file;
};

/* By its suffix. */
bool gltf_is_named(const char *path);

/* An error names the file, and the line of what is no JSON. */
bool gltf_file_read(const char *path, struct gltf_file *out, struct error *err);
void gltf_file_free(struct gltf_file *file);

/* Whether it is of version 2. */
bool gltf_file_is_2(const struct gltf_file *file);

/* Members that are not there, or of another kind, are NULL, and so are elements out of range. */
json_t *gltf_element(const struct gltf_file *file, const char *array, size_t index);

/* A whole number from 0; false: not there, or none. */
bool gltf_index(const json_t *object, const char *name, size_t *out);

/* Exactly so many numbers; false: not there, or others. */
bool gltf_numbers(const json_t *object, const char *name, size_t count, double *out);

/* The nodes of the scene that is shown, as an array of indices; NULL: there is none. */
json_t *gltf_scene_nodes(const struct gltf_file *file);

#endif
