/* SPDX-License-Identifier: MIT */
#include "readers/import_pictures.h"

#include "base/grow.h"
#include "files/picture.h"

#include <assimp/material.h>
#include <string.h>

/* Pictures are named again and again, by each material that shows them. One that is seen in several ways beyond its
 * borders has a number for each. */
static uint32_t picture_number(struct import_pictures *pictures, const char *name, const uint8_t wrap[2])
{
    struct model *model = pictures->model;
    char label[PICTURE_NAME_B];
    picture_label(pictures->scene, name, label);
    for (size_t i = 0; i < model->picture_count; i++)
        if (strcmp(model->pictures[i].name, label) == 0 &&
            memcmp(model->pictures[i].wrap, wrap, sizeof model->pictures[i].wrap) == 0)
            return (uint32_t)i + 1;
    model->pictures = grow(model->pictures, model->picture_count, &pictures->capacity, sizeof *model->pictures);
    struct picture *picture = &model->pictures[model->picture_count++];
    picture_read(pictures->scene, name, picture);
    memcpy(picture->name, label, sizeof label);
    memcpy(picture->wrap, wrap, sizeof picture->wrap);
    return (uint32_t)model->picture_count;
}

/* The picture becomes one with holes, which has a number of its own: others may show it whole. */
static void take_mask(struct import_pictures *pictures)
{
    struct model *model = pictures->model;
    const struct mask_of of = {pictures->picture, pictures->mask, pictures->paint->least_alpha};
    if (!pictures->picture || !pictures->mask || !(of.least_alpha > 0)) return;
    uint32_t number = masked_picture_find(&pictures->masked, &of);
    if (!number) {
        model->pictures = grow(model->pictures, model->picture_count, &pictures->capacity, sizeof *model->pictures);
        number = masked_picture_make(&pictures->masked, &of, model->pictures, (uint32_t)model->picture_count);
        model->picture_count += number > model->picture_count;
    }
    if (number == pictures->picture) return;
    pictures->picture = number;
    pictures->mask = 0;
}

static bool is_sky(const struct import_pictures *pictures, const struct aiMaterial *material)
{
    struct aiString name;
    if (pictures->own) return pictures_sky() && strcmp(pictures->own->name, pictures_sky()) == 0;
    return pictures_sky() && aiGetMaterialString(material, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS &&
           strcmp(name.data, pictures_sky()) == 0;
}

/* The picture becomes a sky, which has a number of its own: others may show it as it is. */
static void take_sky(struct import_pictures *pictures)
{
    struct model *model = pictures->model;
    const char *name = model->pictures[pictures->picture - 1].name;
    pictures->has_sky = true;
    for (size_t i = 0; i < model->picture_count; i++)
        if (model->pictures[i].sky.times && strcmp(model->pictures[i].name, name) == 0) {
            pictures->picture = (uint32_t)i + 1;
            return;
        }
    model->pictures = grow(model->pictures, model->picture_count, &pictures->capacity, sizeof *model->pictures);
    if (picture_copy_as_sky(&model->pictures[pictures->picture - 1], &model->pictures[model->picture_count]))
        pictures->picture = (uint32_t)++model->picture_count;
}

/* The picture becomes one of colour and light together. Where the material has no colour but its light, no lamp dims
 * it.
 */
static void add_light_to_picture(struct import_pictures *pictures, const struct emission_of *of)
{
    struct model *model = pictures->model;
    pictures->picture = emissive_picture_find(&pictures->emissive, of);
    if (!pictures->picture) {
        model->pictures = grow(model->pictures, model->picture_count, &pictures->capacity, sizeof *model->pictures);
        pictures->picture =
            emissive_picture_make(&pictures->emissive, of, model->pictures, (uint32_t)model->picture_count++);
    }
    for (int i = 0; i < 3; i++)
        pictures->paint->rgb[i] = 1;
    pictures->light = of->colour ? LIGHT_DIMMED : LIGHT_ALONE;
}

static bool has_pixels(const struct import_pictures *pictures, uint32_t picture)
{
    return picture && pictures->model->pictures[picture - 1].pixels;
}

/* The picture of the light, and its coordinates, where there is one of the colour as well. false: nothing is to be done
 * with it. */
static bool take_light_picture(struct import_pictures *pictures, const struct picture_use *use, struct emission_of *of)
{
    const uint32_t number = picture_number(pictures, use->name.data, use->wrap);
    if (of->colour_picture &&
        (use->uv_set != pictures->uv_set ||
         memcmp(pictures->model->pictures[of->colour_picture - 1].wrap, use->wrap, sizeof use->wrap) != 0)) {
        pictures->light = LIGHT_LOST;
        return false;
    }
    if (!has_pixels(pictures, number)) {
        pictures->picture = number; /* which says what is wrong with it */
        return false;
    }
    pictures->uv_set = use->uv_set;
    of->light_picture = number;
    return true;
}

static double sum_of(const double light[3])
{
    return light[0] + light[1] + light[2];
}

/* Of a material that has no colour but its light, the picture of its colour is of use for its holes alone. */
static void begin_light(struct import_pictures *pictures, struct emission_of *of)
{
    const struct picture *picture = pictures->picture ? &pictures->model->pictures[pictures->picture - 1] : NULL;
    *of = (struct emission_of){.colour = model_paint_colour(pictures->paint)};
    memcpy(of->light, pictures->paint->light, sizeof of->light);
    if (!of->colour && picture && picture->pixels && !picture->has_alpha) pictures->picture = 0;
    if (has_pixels(pictures, pictures->picture)) of->colour_picture = pictures->picture;
}

/* What the material emits: a colour of its faces, unless there is a picture to add it to. MTL's map_Ke does without a
 * Ke. Where pictures are left out, what they would make of the light is not known. */
static void take_light(struct import_pictures *pictures, const struct aiMaterial *material)
{
    struct model_paint *paint = pictures->paint;
    struct picture_use use;
    struct emission_of of;
    const bool has_picture = !paint->unlit && picture_of_light(material, &use);
    if (has_picture && !paint->linear && !(sum_of(paint->light) > 0))
        for (int i = 0; i < 3; i++)
            paint->light[i] = 1;
    if (!(sum_of(paint->light) > 0)) return;
    for (int i = 0; i < 3 && !pictures->own; i++)
        pictures->is_bright |= paint->light[i] > 1;
    begin_light(pictures, &of);
    if (pictures->picture && !has_pixels(pictures, pictures->picture) && !pictures_are_left_out()) return;
    if (has_picture && pictures_are_left_out() && of.colour) return;
    if (has_picture && !pictures_are_left_out() && !take_light_picture(pictures, &use, &of)) return;
    if (of.colour_picture || of.light_picture)
        add_light_to_picture(pictures, &of);
    else
        pictures->emission = model_paint_emission(paint);
}

void import_pictures_find(struct import_pictures *pictures, const struct aiMesh *mesh, const struct obj *obj,
                          struct model_paint *paint)
{
    static const uint8_t repeats[2] = {PICTURE_REPEATS, PICTURE_REPEATS};
    struct picture_use use;
    struct aiString name;
    pictures->paint = paint;
    pictures->picture = pictures->mask = pictures->holes = 0;
    pictures->emission = 0;
    pictures->light = LIGHT_NONE;
    pictures->is_bright = false;
    pictures->own = NULL;
    if (mesh->mMaterialIndex >= pictures->scene->mNumMaterials) return;
    const struct aiMaterial *material = pictures->scene->mMaterials[mesh->mMaterialIndex];
    pictures->own = obj_material(obj, material);
    if (picture_of_colour(material, &use)) pictures->picture = picture_number(pictures, use.name.data, use.wrap);
    pictures->uv_set = use.uv_set;
    if (pictures->picture && is_sky(pictures, material)) {
        take_sky(pictures);
        return;
    }
    take_light(pictures, material);
    if (picture_mask_of(material, &name)) pictures->mask = picture_number(pictures, name.data, repeats);
    if (!pictures->mask && pictures->picture && pictures->paint->textures_blend &&
        pictures->model->pictures[pictures->picture - 1].has_alpha)
        pictures->mask = pictures->picture;
    take_mask(pictures);
    if (pictures->picture && pictures->model->pictures[pictures->picture - 1].is_masked)
        pictures->holes = picture_transparency(&pictures->model->pictures[pictures->picture - 1]);
}

void import_pictures_note(const struct import_pictures *pictures)
{
    if (pictures->bright_faces)
        model_note(
            pictures->model,
            "%zu faces emit more than 1 of red, green or blue: it is drawn as 1, which may change their hue; less "
            "strength helps",
            pictures->bright_faces);
    if (pictures->light_faces[LIGHT_DIMMED])
        model_note(pictures->model,
                   "%zu faces emit light and have a texture: baked light dims both; --unlit shows them undimmed",
                   pictures->light_faces[LIGHT_DIMMED]);
    if (pictures->light_faces[LIGHT_LOST])
        model_note(pictures->model,
                   "%zu faces are drawn without the light that they emit: its texture has other coordinates than that "
                   "of their colour",
                   pictures->light_faces[LIGHT_LOST]);
}

void import_pictures_free(struct import_pictures *pictures)
{
    masked_pictures_free(&pictures->masked);
    emissive_pictures_free(&pictures->emissive);
}
