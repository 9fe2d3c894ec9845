/* SPDX-License-Identifier: MIT */
#include "formats/looks_3mf.h"

#include "base/grow.h"
#include "model/note_words.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_PICTURE_B = 64 << 20 };

struct mesh_looks_3mf looks_3mf_begin(lib3mf_handle mesh)
{
    struct mesh_looks_3mf looks = {NULL, NULL};
    if (lib3mf_meshobject_createpropertyhandler(mesh, &looks.triangles)) looks.triangles = NULL;
    if (lib3mf_object_createdefaultpropertyhandler(mesh, &looks.object)) looks.object = NULL;
    return looks;
}

void looks_3mf_end(struct mesh_looks_3mf *looks)
{
    if (looks->triangles) lib3mf_release(looks->triangles);
    if (looks->object) lib3mf_release(looks->object);
}

/* Colours ---------------------------------------------------------------------------------------------------------- */

static void add_bytes(const uint8_t rgba[4], struct mean_colour *colour)
{
    mean_colour_add(colour, (const double[4]){rgba[0] / 255.0, rgba[1] / 255.0, rgba[2] / 255.0, rgba[3] / 255.0});
}

static void add_material(const struct looks_3mf *looks, uint32_t group, uint32_t index, struct mean_colour *colour)
{
    lib3mf_handle materials;
    uint8_t rgba[4];
    if (lib3mf_model_getbasematerialbyid(looks->model, group, &materials)) return;
    if (!lib3mf_basematerial_getdisplaycolor(materials, index, &rgba[0], &rgba[1], &rgba[2], &rgba[3]))
        add_bytes(rgba, colour);
    lib3mf_release(materials);
}

/* Pictures --------------------------------------------------------------------------------------------------------- */

static uint32_t read_bytes(const struct looks_3mf *looks, lib3mf_handle picture, const char *name)
{
    unsigned long long size_b = 0;
    lib3mf_handle file;
    uint8_t *bytes = NULL;
    uint32_t number = 0;
    if (lib3mf_texture2d_getattachment(picture, &file)) file = NULL;
    if (file && !lib3mf_attachment_getstreamsize(file, &size_b) && size_b <= MOST_PICTURE_B)
        bytes = grow_zeroed(size_b + 1, 1);
    if (bytes && !lib3mf_attachment_writetobuffer(file, bytes, size_b))
        number = build_picture_bytes(looks->build, name, bytes, (size_t)size_b);
    free(bytes);
    if (file) lib3mf_release(file);
    return number;
}

static struct picture_3mf read_picture(const struct looks_3mf *looks, uint32_t id)
{
    struct picture_3mf read = {.id = id, .repeats = true};
    char path[512] = "";
    uint32_t needed_b;
    int across = LIB3MF_WRAP, up = LIB3MF_WRAP;
    lib3mf_handle picture;
    if (lib3mf_model_gettexture2dbyid(looks->model, id, &picture)) return read;
    lib3mf_texture2d_getpathutf8(picture, path, sizeof path, &needed_b);
    lib3mf_texture2d_gettilestyleuv(picture, &across, &up);
    read.repeats = across == LIB3MF_WRAP && up == LIB3MF_WRAP;
    read.number = read_bytes(looks, picture, path + (path[0] == '/'));
    if (!read.number) model_note(looks->build->model, "the picture %s " WORDS_NOT_IN_IT, path);
    lib3mf_release(picture);
    return read;
}

static const struct picture_3mf *picture_of(struct looks_3mf *looks, uint32_t id)
{
    for (size_t i = 0; i < looks->picture_count; i++)
        if (looks->pictures[i].id == id) return &looks->pictures[i];
    looks->pictures = grow(looks->pictures, looks->picture_count, &looks->picture_capacity, sizeof *looks->pictures);
    looks->pictures[looks->picture_count] = read_picture(looks, id);
    return &looks->pictures[looks->picture_count++];
}

/* The file counts from the bottom. */
static uint32_t take_places(struct looks_3mf *looks, const struct lib3mf_places *places, double uv[3][2])
{
    const struct picture_3mf *picture = picture_of(looks, places->picture);
    bool is_beyond = false;
    for (int k = 0; k < 3; k++) {
        uv[k][0] = (double)places->u[k];
        uv[k][1] = 1 - (double)places->v[k];
        for (int i = 0; i < 2; i++)
            is_beyond |= uv[k][i] < 0 || uv[k][i] > 1;
    }
    looks->held += is_beyond && !picture->repeats;
    return picture->number;
}

/* A triangle ------------------------------------------------------------------------------------------------------- */

static void take_own(struct looks_3mf *looks, lib3mf_handle properties, uint32_t triangle, uint32_t type,
                     struct build_look *look, double uv[3][2])
{
    struct lib3mf_places places;
    uint8_t rgba[3][4];
    uint32_t group = 0, index = 0;
    if (type == LIB3MF_BASE_MATERIAL && !lib3mf_propertyhandler_getbasematerial(properties, triangle, &group, &index))
        add_material(looks, group, index, &look->colour);
    if (type == LIB3MF_COLOUR && !lib3mf_propertyhandler_getcolor(properties, triangle, rgba))
        for (int k = 0; k < 3; k++)
            add_bytes(rgba[k], &look->colour);
    if (type == LIB3MF_PLACE && !lib3mf_propertyhandler_gettexture(properties, triangle, &places))
        look->picture = take_places(looks, &places, uv);
}

static void take_objects(struct looks_3mf *looks, lib3mf_handle properties, struct build_look *look, double uv[3][2])
{
    uint32_t type = LIB3MF_NOTHING, group = 0, index = 0; /* lib3mf leaves some unset */
    uint8_t rgba[4];
    float u, v;
    if (!properties || lib3mf_defaultpropertyhandler_getpropertytype(properties, &type)) return;
    if (type == LIB3MF_BASE_MATERIAL && !lib3mf_defaultpropertyhandler_getbasematerial(properties, &group, &index))
        add_material(looks, group, index, &look->colour);
    if (type == LIB3MF_COLOUR && !lib3mf_defaultpropertyhandler_getcolor(properties, 0, rgba))
        add_bytes(rgba, &look->colour);
    if (type == LIB3MF_PLACE && !lib3mf_defaultpropertyhandler_gettexture(properties, &index, &u, &v))
        look->picture = take_places(looks, &(struct lib3mf_places){index, {u, u, u}, {v, v, v}}, uv);
}

struct build_look looks_3mf_of(struct looks_3mf *looks, const struct mesh_looks_3mf *mesh, uint32_t triangle,
                               double uv[3][2])
{
    struct build_look look = {.picture = 0};
    uint32_t type = LIB3MF_NOTHING;
    if (mesh->triangles && lib3mf_propertyhandler_getpropertytype(mesh->triangles, triangle, &type))
        type = LIB3MF_NOTHING;
    if (type == LIB3MF_NOTHING)
        take_objects(looks, mesh->object, &look, uv);
    else
        take_own(looks, mesh->triangles, triangle, type, &look, uv);
    return look;
}

void looks_3mf_note(const struct looks_3mf *looks)
{
    if (looks->held) model_note(looks->build->model, "%zu " WORDS_REPEATS, looks->held);
}

void looks_3mf_free(struct looks_3mf *looks)
{
    free(looks->pictures);
}
