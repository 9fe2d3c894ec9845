/* SPDX-License-Identifier: MIT
 *
 * What colour and opacity the importer's materials give to a face. */
#ifndef SIM_MODEL_COLOUR_H
#define SIM_MODEL_COLOUR_H

#include <assimp/scene.h>
#include <stdbool.h>
#include <stdint.h>

struct model_paint {
    double rgb[3];       /* 0..1 */
    bool linear;         /* rgb and vertex colours are linear light, not sRGB */
    double opacity;      /* as the file has it, which may be beyond 0..1, or no number */
    bool blends;         /* the vertex colours' alpha counts too: alphaMode BLEND of glTF */
    bool textures_blend; /* so does the alpha of its texture: unless alphaMode of glTF says OPAQUE */
    double least_alpha;  /* 0..1: what of its texture, or of its mask, has less is clear; 0: nothing is */
    bool two_sided;      /* the material asks for both sides */
    double light[3];     /* linear light that it emits, which is added once it is lit; no longer between 0 and 1 */
    bool by_vertex;      /* vertices have colours */
    bool signed_bytes;   /* these are bytes that were read as -128 to 127 */
    bool unlit;          /* it is not to be lit: `illum 0` of MTL, KHR_materials_unlit of glTF */
};

/* The mesh's material; light grey where it has none, white where vertex colours say it all. */
struct model_paint model_paint_of(const struct aiScene *scene, const struct aiMesh *mesh);

/* The opacity of a face of this paint: its own times the mean of the vertex colours' alphas, if those count. */
double model_face_opacity(const struct model_paint *paint, const struct aiMesh *mesh, const struct aiFace *face);

/* 0xRRGGBB (sRGB): of paint alone, and what it emits. */
uint32_t model_paint_colour(const struct model_paint *paint);
uint32_t model_paint_emission(const struct model_paint *paint);

/* 0xRRGGBB (sRGB): the paint times the mean of the face's vertex colours, and whether these differ. */
uint32_t model_face_colour(const struct model_paint *paint, const struct aiMesh *mesh, const struct aiFace *face,
                           bool *varies);

#endif
