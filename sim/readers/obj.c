/* SPDX-License-Identifier: MIT */
#include "readers/obj.h"

#include "model/note_words.h"

#include <stdlib.h>
#include <string.h>

size_t obj_number_of(const struct obj *obj, const struct mtl_material *material)
{
    return material ? (size_t)(material - obj->mtl.materials) + 1 : 0;
}

const struct mtl_material *obj_material(const struct obj *obj, const struct aiMaterial *material)
{
    struct aiString name;
    if (!obj->mtl.count || aiGetMaterialString(material, AI_MATKEY_NAME, &name) != aiReturn_SUCCESS) return NULL;
    const unsigned long number = strtoul(name.data, NULL, 10);
    return number >= 1 && number <= obj->mtl.count ? &obj->mtl.materials[number - 1] : NULL;
}

/* A comment may stand behind it, but a # may be the name's own. */
const struct mtl_material *obj_find(const struct obj *obj, struct word name)
{
    const struct mtl_material *found = mtl_find(&obj->mtl, name.text, name.length);
    size_t length = 1;
    while (length < name.length && !(name.text[length] == '#' && is_blank(name.text[length - 1])))
        length++;
    if (found || length >= name.length) return found;
    while (length && is_blank(name.text[length - 1]))
        length--;
    return mtl_find(&obj->mtl, name.text, length);
}

static void tell(struct model *model, const char *what, const struct names *names)
{
    char list[ERROR_B / 2];
    if (names->mentions) model_note(model, "%s: %s (%zu)", what, names_list(names, list, sizeof list), names->mentions);
}

static void tell_libraries(const struct obj *obj, struct model *model)
{
    char missing[ERROR_B / 2], instead[ERROR_B / 4];
    names_list(&obj->missing, missing, sizeof missing);
    names_list(&obj->instead, instead, sizeof instead);
    if (obj->instead.mentions)
        model_note(model, "there is no MTL file %s; %s is read in its place", missing, instead);
    else if (obj->missing.mentions)
        model_note(model, "there is no MTL file %s: put it beside the model to see its colours", missing);
    if (obj->names_libraries)
        tell(model, "faces are drawn in grey, as no MTL file defines their material", &obj->unknown);
}

static void tell_materials(const struct mtl *mtl, struct model *model)
{
    tell(model, "materials are defined twice, and the first definition is taken", &mtl->doubled);
    tell(model, "statements of MTL files before the first newmtl are left out", &mtl->early);
    tell(model, "statements of MTL files are left out, as they are not known", &mtl->left_out);
    tell(model, "options of pictures are left out", &mtl->options);
    tell(model, "colours that are no RGB are left out, of materials", &mtl->no_rgb);
    tell(model, "colours beyond 0..1 are drawn as the nearest ones within, of materials", &mtl->beyond);
    tell(model, "pictures are black by their material's colour, which Kd 1 1 1 would not do, of materials",
         &mtl->black);
    tell(model, "Tr and d contradict each other, and d is taken, of materials", &mtl->contradicts);
    tell(model, "Tr is taken for an opacity, as MeshLab writes it, for else nobody would see its faces, of materials",
         &mtl->meshlab);
}

void obj_tell(const struct obj *obj, struct model *model)
{
    tell_libraries(obj, model);
    tell_materials(&obj->mtl, model);
    tell(model, "statements are left out, as they are not known", &obj->left_out);
    if (obj->full_colour > 1)
        model_note(model, "its vertices' colours are whole numbers, which are taken as parts of 255");
    if (obj->curves) model_note(model, "%zu " WORDS_CURVES, obj->curves);
    if (obj->lines) model_note(model, "%zu " WORDS_LINES, obj->lines);
    if (obj->weights)
        model_note(model, "%zu vertices have a weight behind x, y and z that is not 1: it is of curves, and left out",
                   obj->weights);
}

void obj_free(struct obj *obj)
{
    mtl_free(&obj->mtl);
    names_free(&obj->libraries);
    names_free(&obj->missing);
    names_free(&obj->instead);
    names_free(&obj->unknown);
    names_free(&obj->left_out);
}
