/* SPDX-License-Identifier: MIT
 *
 * What the triangles of a 3MF file look like: base materials, groups of colours, and groups of places in pictures,
 * which are in the file. What a triangle does not say, its object does. */
#ifndef SIM_LOOKS_3MF_H
#define SIM_LOOKS_3MF_H

#include "formats/lib3mf.h"
#include "formats/model_build.h"

struct looks_3mf {
    struct model_build *build;
    lib3mf_handle model;
    struct picture_3mf {
        uint32_t id, number; /* of the file, and of the model; number 0: it has no bytes */
        bool repeats;        /* both ways */
    } * pictures;
    size_t picture_count, picture_capacity;
    size_t held; /* triangles with places beyond a picture that does not repeat */
};

/* A mesh's properties; released by looks_3mf_end(). */
struct mesh_looks_3mf {
    lib3mf_handle triangles, object;
};

struct mesh_looks_3mf looks_3mf_begin(lib3mf_handle mesh);
void looks_3mf_end(struct mesh_looks_3mf *looks);

/* Of a triangle. uv: of its corners, if it has a picture. */
struct build_look looks_3mf_of(struct looks_3mf *looks, const struct mesh_looks_3mf *mesh, uint32_t triangle,
                               double uv[3][2]);

void looks_3mf_note(const struct looks_3mf *looks);
void looks_3mf_free(struct looks_3mf *looks);

#endif
