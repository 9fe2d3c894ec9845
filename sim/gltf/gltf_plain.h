/* SPDX-License-Identifier: MIT
 *
 * A glTF 2.0 file as the importer library is to read it: a plain .glb that says the same. Accessors are decoded here
 * and are float32 there, indices uint32; positions are stand-ins for doubles (vertex_table.h). Textures' coordinates
 * are transformed, and lie in sets 0 (of the colour) and 1 (of the emission); instances are nodes. What draws nothing
 * is left out. */
#ifndef SIM_GLTF_PLAIN_H
#define SIM_GLTF_PLAIN_H

#include "gltf/gltf_file.h"
#include "gltf/vertex_table.h"
#include "model/model.h"

struct gltf_plain {
    char *path;                /* what the library is to take it for; NULL: the file is none of glTF 2.0 */
    struct gltf_file file;     /* its JSON, of which each node is one of the library's */
    struct whole_file glb;     /* what the library is to read */
    struct vertex_table table; /* what its vertices stand for; empty: for themselves */
    bool is_float32;           /* they are so in the file, too */
};

/* Sets *plain, if the file is one of glTF 2.0. Notices of what is not drawn go to the model. Refuses, by
 * name and reason: extensions that it requires and that are not read, and accessors that are damaged. */
bool gltf_plain_make(const char *path, struct gltf_plain *plain, struct model *model, struct error *err);
void gltf_plain_free(struct gltf_plain *plain);

#endif
