/* SPDX-License-Identifier: MIT
 *
 * Face colours from the importer's materials and vertex colours. Linear light (physically based
 * materials) is encoded as sRGB after all arithmetic. */
#include "model/model_colour.h"

#include "base/srgb.h"
#include "model/mean_colour.h"
#include "model/model.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

static const double HALF = 0.5;

/* The importer makes up a material where the file has none: its default, or one without a name. */
static bool is_made_up(const struct aiMaterial *material)
{
    struct aiString name;
    return aiGetMaterialString(material, AI_MATKEY_NAME, &name) != aiReturn_SUCCESS || name.length == 0 ||
           strcmp(name.data, AI_DEFAULT_MATERIAL_NAME) == 0;
}

/* Of an AMF file without colours the library makes vertices of which all four numbers are 0. */
static bool vertices_have_colours(const struct aiMesh *mesh)
{
    const struct aiColor4D *colours = mesh->mColors[0];
    for (unsigned i = 0; colours && i < mesh->mNumVertices; i++)
        if (colours[i].r != 0 || colours[i].g != 0 || colours[i].b != 0 || colours[i].a != 0) return true;
    return false;
}

/* Of old files of Blender the library takes a colour's bytes for numbers with a sign, and leaves them so. */
static bool are_signed_bytes(const struct aiMesh *mesh)
{
    bool any_below_0 = false;
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        const struct aiColor4D *c = &mesh->mColors[0][i];
        const float parts[4] = {c->r, c->g, c->b, c->a};
        for (int k = 0; k < 4; k++) {
            if (!(parts[k] >= INT8_MIN && parts[k] <= INT8_MAX) || parts[k] != rintf(parts[k])) return false;
            any_below_0 |= parts[k] < 0;
        }
    }
    return any_below_0;
}

static double from_signed_byte(float part)
{
    return (part < 0 ? part + 256.0 : part) / 255.0;
}

static struct model_paint default_paint(const struct aiMesh *mesh)
{
    const bool by_vertex = vertices_have_colours(mesh);
    const double grey = by_vertex ? 1.0 : (MODEL_DEFAULT_COLOUR & 0xFF) / 255.0;
    return (struct model_paint){.rgb = {grey, grey, grey},
                                .opacity = 1.0,
                                .by_vertex = by_vertex,
                                .signed_bytes = by_vertex && are_signed_bytes(mesh)};
}

static float number_of(const struct aiMaterial *material, const char *key, unsigned type, unsigned index,
                       float otherwise)
{
    float number = otherwise;
    unsigned count = 1;
    return aiGetMaterialFloatArray(material, key, type, index, &number, &count) == aiReturn_SUCCESS ? number
                                                                                                    : otherwise;
}

/* glTF says in `alphaMode` what its alpha means; other formats have an opacity and no more. */
static void set_opacity(struct model_paint *paint, const struct aiMaterial *material)
{
    struct aiString mode;
    const double opacity = number_of(material, AI_MATKEY_OPACITY, 1.0F);
    const bool has_mode = aiGetMaterialString(material, AI_MATKEY_GLTF_ALPHAMODE, &mode) == aiReturn_SUCCESS;
    paint->opacity = opacity;
    paint->blends = has_mode && strcmp(mode.data, "BLEND") == 0;
    const bool masked = has_mode && strcmp(mode.data, "MASK") == 0;
    const double cutoff = masked ? number_of(material, AI_MATKEY_GLTF_ALPHACUTOFF, 0.5F) : HALF;
    paint->textures_blend = !has_mode || paint->blends || masked;
    if (!has_mode && opacity >= 1) paint->least_alpha = cutoff;
    if (!has_mode || paint->blends) return;
    paint->opacity = masked && opacity < cutoff ? 0.0 : 1.0;
    if (masked && paint->opacity > 0 && opacity > 0) paint->least_alpha = cutoff / opacity;
}

/* What is unlit shows its colour and no more. */
static void set_light(struct model_paint *paint, const struct aiMaterial *material)
{
    struct aiColor4D colour;
    if (paint->unlit || aiGetMaterialColor(material, AI_MATKEY_COLOR_EMISSIVE, &colour) != aiReturn_SUCCESS) return;
    const double channels[3] = {colour.r, colour.g, colour.b};
    for (int i = 0; i < 3; i++)
        paint->light[i] = channels[i] > 0 ? paint->linear ? channels[i] : srgb_to_linear(channels[i]) : 0;
}

struct model_paint model_paint_of(const struct aiScene *scene, const struct aiMesh *mesh)
{
    struct model_paint paint = default_paint(mesh);
    if (mesh->mMaterialIndex >= scene->mNumMaterials) return paint;
    const struct aiMaterial *material = scene->mMaterials[mesh->mMaterialIndex];
    struct aiColor4D colour;
    bool base = aiGetMaterialColor(material, AI_MATKEY_BASE_COLOR, &colour) == aiReturn_SUCCESS;
    bool found = base || (!is_made_up(material) &&
                          aiGetMaterialColor(material, AI_MATKEY_COLOR_DIFFUSE, &colour) == aiReturn_SUCCESS);
    if (found)
        paint = (struct model_paint){.rgb = {colour.r, colour.g, colour.b},
                                     .linear = base,
                                     .by_vertex = paint.by_vertex,
                                     .signed_bytes = paint.signed_bytes};
    int shading = 0;
    aiGetMaterialIntegerArray(material, AI_MATKEY_SHADING_MODEL, &shading, NULL);
    paint.unlit = shading == aiShadingMode_NoShading;
    set_light(&paint, material);
    int two_sided = 0;
    aiGetMaterialIntegerArray(material, AI_MATKEY_TWOSIDED, &two_sided, NULL);
    paint.two_sided = two_sided != 0;
    set_opacity(&paint, material);
    return paint;
}

/* Empty where vertices have no colours. */
static struct mean_colour corners_of(const struct model_paint *paint, const struct aiMesh *mesh,
                                     const struct aiFace *face)
{
    struct mean_colour mean = {.count = 0};
    for (unsigned i = 0; paint->by_vertex && i < face->mNumIndices; i++) {
        const struct aiColor4D *c = &mesh->mColors[0][face->mIndices[i]];
        mean_colour_add(&mean, paint->signed_bytes ? (const double[4]){from_signed_byte(c->r), from_signed_byte(c->g),
                                                                       from_signed_byte(c->b), from_signed_byte(c->a)}
                                                   : (const double[4]){c->r, c->g, c->b, c->a});
    }
    return mean;
}

static uint32_t colour_of(const double rgb[3], bool is_linear)
{
    uint32_t colour = 0;
    for (int i = 0; i < 3; i++)
        colour = colour << 8 | srgb_byte(is_linear ? srgb_from_linear(rgb[i]) : rgb[i]);
    return colour;
}

uint32_t model_paint_colour(const struct model_paint *paint)
{
    return colour_of(paint->rgb, paint->linear);
}

uint32_t model_paint_emission(const struct model_paint *paint)
{
    return colour_of(paint->light, true);
}

double model_face_opacity(const struct model_paint *paint, const struct aiMesh *mesh, const struct aiFace *face)
{
    const struct mean_colour corners = corners_of(paint, mesh, face);
    return paint->opacity * (paint->blends ? mean_colour_of(&corners, 3) : 1);
}

uint32_t model_face_colour(const struct model_paint *paint, const struct aiMesh *mesh, const struct aiFace *face,
                           bool *varies)
{
    const struct mean_colour corners = corners_of(paint, mesh, face);
    double rgb[3];
    for (int channel = 0; channel < 3; channel++)
        rgb[channel] = paint->rgb[channel] * mean_colour_of(&corners, channel);
    *varies = mean_colour_varies(mean_colour_spread(&corners));
    return colour_of(rgb, paint->linear);
}
