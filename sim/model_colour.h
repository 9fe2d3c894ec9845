/* SPDX-License-Identifier: MIT
 *
 * What colour the importer's materials give to a face. */
#ifndef SIM_MODEL_COLOUR_H
#define SIM_MODEL_COLOUR_H

#include <assimp/scene.h>
#include <stdbool.h>
#include <stdint.h>

struct model_paint {
    double rgb[3];  /* 0..1 */
    bool linear;    /* rgb and vertex colours are linear light, not sRGB */
    bool two_sided; /* the material asks for both sides */
    bool unlit;     /* it is not to be lit: `illum 0` of MTL, KHR_materials_unlit of glTF */
};

/* The mesh's material; light grey where it has none, white where vertex colours say it all. */
struct model_paint model_paint_of(const struct aiScene *scene, const struct aiMesh *mesh);

/* 0xRRGGBB (sRGB): the paint times the mean of the face's vertex colours. */
uint32_t model_face_colour(const struct model_paint *paint, const struct aiMesh *mesh, const struct aiFace *face);

#endif
