/* SPDX-License-Identifier: MIT
 *
 * What an OBJ file says beside the corners of its faces: how much there is of what, its materials, and what of it is
 * not drawn. */
#ifndef SIM_OBJ_H
#define SIM_OBJ_H

#include "formats/mtl.h"
#include "model/model.h"

#include <assimp/material.h>

struct obj {
    const char *path;
    size_t vertex_count, place_count; /* `v` and `vt` */
    bool has_colours;                 /* of vertices */
    double full_colour;               /* 1, or 255 */
    struct mtl mtl;
    bool names_libraries;          /* there is an mtllib */
    struct names libraries;        /* each of them */
    struct names missing;          /* those that are not there */
    struct names instead;          /* what was read in their place */
    struct names unknown;          /* materials that no library defines, once a face */
    struct names left_out;         /* statements that nothing is made of */
    size_t curves, lines, weights; /* curves and surfaces; lines and points; vertices whose weight is not 1 */
};

/* How the importer library gets its materials: a file of this name has those of all libraries, named by their numbers
 * from 1. What has no material of these has OBJ_NO_MATERIAL. */
#define OBJ_MATERIALS "\x1fmaterials"
#define OBJ_NO_MATERIAL AI_DEFAULT_MATERIAL_NAME

/* 0: none. */
size_t obj_number_of(const struct obj *obj, const struct mtl_material *material);

/* Of a material that the library made; NULL: of none. */
const struct mtl_material *obj_material(const struct obj *obj, const struct aiMaterial *material);

/* The material that a usemtl names; NULL: there is none. */
const struct mtl_material *obj_find(const struct obj *obj, struct word name);

void obj_tell(const struct obj *obj, struct model *model);
void obj_free(struct obj *obj);

#endif
