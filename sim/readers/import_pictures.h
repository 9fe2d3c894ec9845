/* SPDX-License-Identifier: MIT
 *
 * What of a material's pictures a mesh shows: that of its colour, with holes, as a sky, or with what it emits. */
#ifndef SIM_IMPORT_PICTURES_H
#define SIM_IMPORT_PICTURES_H

#include "files/masked_picture.h"
#include "model/model.h"
#include "model/model_colour.h"
#include "readers/emissive_picture.h"
#include "readers/obj.h"

#include <assimp/scene.h>

/* What became of the light that a material emits, if there is a picture in play. */
enum light_in_picture { LIGHT_NONE, LIGHT_ALONE, LIGHT_DIMMED, LIGHT_LOST, LIGHTS_IN_PICTURES };

struct import_pictures {
    const struct aiScene *scene;
    struct model *model; /* which has the pictures */
    struct masked_pictures masked;
    struct emissive_pictures emissive;
    size_t capacity, light_faces[LIGHTS_IN_PICTURES], bright_faces;
    bool has_sky; /* one of the materials is it */
    /* Of the mesh that was asked for last: */
    struct model_paint *paint;
    uint32_t picture, mask; /* 0: none */
    uint8_t holes;          /* picture_transparency() of its picture, if that is masked; else 0 */
    unsigned uv_set;
    uint32_t emission; /* model_face.emission */
    enum light_in_picture light;
    bool is_bright; /* it emits more than a colour can be; of an OBJ file that is told by its materials' names */
    const struct mtl_material *own; /* what an OBJ file's libraries say of it; NULL: nothing */
};

/* Sets what belongs to a mesh. Where a picture has the paint's colour in it, the paint is white then. */
void import_pictures_find(struct import_pictures *pictures, const struct aiMesh *mesh, const struct obj *obj,
                          struct model_paint *paint);

/* Notices of light that is dimmed, cut or left out, by the faces that were counted. */
void import_pictures_note(const struct import_pictures *pictures);
void import_pictures_free(struct import_pictures *pictures);

#endif
