/* SPDX-License-Identifier: MIT
 *
 * Model files by assimp. No post-processing: the library would triangulate, merge and reorder. The
 * node tree is walked twice, first to count (and to refuse what is too large or out of range), then
 * to fill three arrays of exactly that size. Vertices and node transforms are double where the file's format lets us
 * (vertex_numbers.h, node_transforms.h), and arithmetic is so everywhere. */
#include "readers/import.h"

#include "base/grow.h"
#include "base/inputs.h"
#include "files/companion.h"
#include "files/masked_picture.h"
#include "files/picture.h"
#include "formats/float_step.h"
#include "formats/model_limits.h"
#include "formats/own_formats.h"
#include "gltf/gltf_plain.h"
#include "levels/level_import.h"
#include "levels/level_path.h"
#include "model/model_colour.h"
#include "readers/emissive_picture.h"
#include "readers/import_motion.h"
#include "readers/model_io.h"
#include "readers/model_unit.h"
#include "readers/model_whole.h"
#include "readers/vertex_numbers.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What became of the light that a material emits, if there is a picture in play. */
enum light_in_picture { LIGHT_NONE, LIGHT_ALONE, LIGHT_DIMMED, LIGHT_LOST, LIGHTS_IN_PICTURES };

struct import {
    const char *path;
    const struct aiScene *scene;
    struct model *model;
    struct error *err;
    struct node_transform transform; /* of the node being read */
    struct model_paint paint;        /* of the mesh being read */
    uint32_t picture, mask;          /* the same; 0: none */
    uint8_t holes;                   /* picture_transparency() of its picture, if that is masked; else 0 */
    struct masked_pictures masked;
    struct emissive_pictures emissive;
    uint32_t emission;           /* of the mesh being read: model_face.emission */
    enum light_in_picture light; /* the same */
    size_t light_faces[LIGHTS_IN_PICTURES];
    bool has_sky;                   /* one of the materials is it */
    const struct mtl_material *own; /* what an OBJ file's libraries say of the mesh being read; NULL: nothing */
    unsigned uv_set;
    size_t picture_capacity, point_total;
    struct motions motions;
    uint16_t mover; /* of the node being read: model_face.mover */
    struct vertex_numbers numbers;
    struct gltf_plain plain;
    struct node_transforms transforms;
    double step_m; /* the largest of those between float32 numbers that vertices came as */
};

typedef bool mesh_reader(struct import *import, const struct aiMesh *mesh);

static struct node_transform affine_identity(void)
{
    return (struct node_transform){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
}

static bool affine_mirrors(const struct node_transform *a)
{
    const double(*m)[4] = a->m;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
           0;
}

/* Parents first; a node's meshes in their order, then its children, which move with it unless they move themselves. */
static bool walk(struct import *import, const struct aiNode *node, struct node_transform parent, uint16_t mover,
                 mesh_reader *read)
{
    const struct node_transform own = node_transform_of(&import->transforms, node);
    const struct node_transform here = node_transform_times(&parent, &own);
    const uint16_t own_mover = motions_mover_of(&import->motions, node);
    if (own_mover) mover = own_mover;
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        import->transform = here;
        import->mover = mover;
        if (!read(import, import->scene->mMeshes[node->mMeshes[i]])) return false;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++)
        if (!walk(import, node->mChildren[i], here, mover, read)) return false;
    return true;
}

static bool count_mesh(struct import *import, const struct aiMesh *mesh)
{
    struct model *model = import->model;
    model->point_count += mesh->mNumVertices;
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices < 3) continue;
        model->face_count++;
        model->corner_count += face->mNumIndices;
        if (face->mNumIndices > MOST_FACE_CORNERS)
            return error_set(import->err, "%s: face %zu has %u corners, %d are the most", import->path,
                             model->face_count, face->mNumIndices, MOST_FACE_CORNERS);
        for (unsigned k = 0; k < face->mNumIndices; k++)
            if (face->mIndices[k] >= mesh->mNumVertices)
                return error_set(import->err, "%s: face %zu: vertex index %u is out of range, there are %u",
                                 import->path, model->face_count, face->mIndices[k], mesh->mNumVertices);
    }
    if (model->face_count > MOST_FACES)
        return error_set(import->err, "%s: more than %d faces", import->path, MOST_FACES);
    if (model->corner_count > MOST_CORNERS || model->point_count > MOST_CORNERS)
        return error_set(import->err, "%s: more than %d corners or vertices", import->path, MOST_CORNERS);
    return true;
}

/* In its node's coordinates. What the library leaves unset is at the origin. */
static bool vertex_of(struct import *import, const struct aiVector3D *v, double out[3])
{
    const bool is_set = v->x != 0 || v->y != 0 || v->z != 0;
    out[0] = v->x;
    out[1] = v->y;
    out[2] = v->z;
    if (!import->numbers.table.count || !is_set) return true;
    const double *point = vertex_table_find(&import->numbers.table, out[0], out[1], out[2]);
    if (!point) return error_set(import->err, "%s: the importer changed a vertex on its way", import->path);
    memcpy(out, point, 3 * sizeof *out);
    return true;
}

static void note_step(struct import *import, const double v[3])
{
    const double(*m)[4] = (const double(*)[4])import->transform.m;
    const bool is_double = import->numbers.table.count > 0 && !import->plain.is_float32;
    for (int axis = 0; axis < 3; axis++) {
        double step_m = 0;
        for (int i = 0; i < 3 && !is_double; i++)
            step_m += fabs(m[axis][i]) * float_step_at(fabs(v[i]));
        if (!is_double && !import->transforms.are_double && m[axis][3] != 0) step_m += float_step_at(fabs(m[axis][3]));
        import->step_m = fmax(import->step_m, step_m);
    }
}

static bool add_points(struct import *import, const struct aiMesh *mesh)
{
    struct model *model = import->model;
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        double v[3], *point = model->points[model->point_count++];
        if (!vertex_of(import, &mesh->mVertices[i], v)) return false;
        note_step(import, v);
        for (int axis = 0; axis < 3; axis++) {
            const double *row = import->transform.m[axis];
            point[axis] = row[0] * v[0] + row[1] * v[1] + row[2] * v[2] + row[3];
        }
    }
    return true;
}

/* Of the last face. Opacities beyond 0..1 occur, and what they mean is plain. */
static bool set_transparency(struct import *import, double opacity)
{
    struct model *model = import->model;
    if (!isfinite(opacity))
        return error_set(import->err, "%s: face %zu: the opacity of its material is NaN or infinite", import->path,
                         model->face_count);
    const double clamped = fmin(fmax(opacity, 0), 1);
    model->alpha_clamped += clamped != opacity;
    struct model_face *face = &model->faces[model->face_count - 1];
    face->transparency = (uint8_t)(255 * (1 - clamped) + 0.5);
    if (!face->transparency) face->transparency = import->holes;
    return true;
}

/* Pictures are named again and again, by each material that shows them. One that is seen in several ways beyond its
 * borders has a number for each. */
static uint32_t picture_number(struct import *import, const char *name, const uint8_t wrap[2])
{
    struct model *model = import->model;
    for (size_t i = 0; i < model->picture_count; i++)
        if (strcmp(model->pictures[i].name, name) == 0 &&
            memcmp(model->pictures[i].wrap, wrap, sizeof model->pictures[i].wrap) == 0)
            return (uint32_t)i + 1;
    model->pictures = grow(model->pictures, model->picture_count, &import->picture_capacity, sizeof *model->pictures);
    struct picture *picture = &model->pictures[model->picture_count++];
    picture_read(import->scene, name, picture);
    memcpy(picture->wrap, wrap, sizeof picture->wrap);
    return (uint32_t)model->picture_count;
}

/* The picture becomes one with holes, which has a number of its own: others may show it whole. */
static void take_mask(struct import *import)
{
    struct model *model = import->model;
    const struct mask_of of = {import->picture, import->mask, import->paint.least_alpha};
    if (!import->picture || !import->mask || !(of.least_alpha > 0)) return;
    uint32_t number = masked_picture_find(&import->masked, &of);
    if (!number) {
        model->pictures =
            grow(model->pictures, model->picture_count, &import->picture_capacity, sizeof *model->pictures);
        number = masked_picture_make(&import->masked, &of, model->pictures, (uint32_t)model->picture_count);
        model->picture_count += number > model->picture_count;
    }
    if (number == import->picture) return;
    import->picture = number;
    import->mask = 0;
}

static bool is_sky(const struct import *import, const struct aiMaterial *material)
{
    struct aiString name;
    if (import->own) return pictures_sky() && strcmp(import->own->name, pictures_sky()) == 0;
    return pictures_sky() && aiGetMaterialString(material, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS &&
           strcmp(name.data, pictures_sky()) == 0;
}

/* The picture becomes a sky, which has a number of its own: others may show it as it is. */
static void take_sky(struct import *import)
{
    struct model *model = import->model;
    const char *name = model->pictures[import->picture - 1].name;
    import->has_sky = true;
    for (size_t i = 0; i < model->picture_count; i++)
        if (model->pictures[i].sky.times && strcmp(model->pictures[i].name, name) == 0) {
            import->picture = (uint32_t)i + 1;
            return;
        }
    model->pictures = grow(model->pictures, model->picture_count, &import->picture_capacity, sizeof *model->pictures);
    if (picture_copy_as_sky(&model->pictures[import->picture - 1], &model->pictures[model->picture_count]))
        import->picture = (uint32_t)++model->picture_count;
}

/* The picture becomes one of colour and light together. Where the material has no colour but its light, no lamp dims
 * it.
 */
static void add_light_to_picture(struct import *import, const struct emission_of *of)
{
    struct model *model = import->model;
    import->picture = emissive_picture_find(&import->emissive, of);
    if (!import->picture) {
        model->pictures =
            grow(model->pictures, model->picture_count, &import->picture_capacity, sizeof *model->pictures);
        import->picture =
            emissive_picture_make(&import->emissive, of, model->pictures, (uint32_t)model->picture_count++);
    }
    for (int i = 0; i < 3; i++)
        import->paint.rgb[i] = 1;
    import->light = of->colour ? LIGHT_DIMMED : LIGHT_ALONE;
}

static bool has_pixels(const struct import *import, uint32_t picture)
{
    return picture && import->model->pictures[picture - 1].pixels;
}

/* The picture of the light, and its coordinates, where there is one of the colour as well. false: nothing is to be done
 * with it. */
static bool take_light_picture(struct import *import, const struct picture_use *use, struct emission_of *of)
{
    const uint32_t number = picture_number(import, use->name.data, use->wrap);
    if (of->colour_picture &&
        (use->uv_set != import->uv_set ||
         memcmp(import->model->pictures[of->colour_picture - 1].wrap, use->wrap, sizeof use->wrap) != 0)) {
        import->light = LIGHT_LOST;
        return false;
    }
    if (!has_pixels(import, number)) {
        import->picture = number; /* which says what is wrong with it */
        return false;
    }
    import->uv_set = use->uv_set;
    of->light_picture = number;
    return true;
}

static double sum_of(const double light[3])
{
    return light[0] + light[1] + light[2];
}

/* Of a material that has no colour but its light, the picture of its colour is of use for its holes alone. */
static void begin_light(struct import *import, struct emission_of *of)
{
    const struct picture *picture = import->picture ? &import->model->pictures[import->picture - 1] : NULL;
    *of = (struct emission_of){.colour = model_paint_colour(&import->paint)};
    memcpy(of->light, import->paint.light, sizeof of->light);
    if (!of->colour && picture && picture->pixels && !picture->has_alpha) import->picture = 0;
    if (has_pixels(import, import->picture)) of->colour_picture = import->picture;
}

/* What the material emits: a colour of its faces, unless there is a picture to add it to. MTL's map_Ke does without a
 * Ke. Where pictures are left out, what they would make of the light is not known. */
static void take_light(struct import *import, const struct aiMaterial *material)
{
    struct model_paint *paint = &import->paint;
    struct picture_use use;
    struct emission_of of;
    const bool has_picture = !paint->unlit && picture_of_light(material, &use);
    if (has_picture && !paint->linear && !(sum_of(paint->light) > 0))
        for (int i = 0; i < 3; i++)
            paint->light[i] = 1;
    if (!(sum_of(paint->light) > 0)) return;
    begin_light(import, &of);
    if (import->picture && !has_pixels(import, import->picture) && !pictures_are_left_out()) return;
    if (has_picture && pictures_are_left_out() && of.colour) return;
    if (has_picture && !pictures_are_left_out() && !take_light_picture(import, &use, &of)) return;
    if (of.colour_picture || of.light_picture)
        add_light_to_picture(import, &of);
    else
        import->emission = model_paint_emission(paint);
}

static void find_pictures(struct import *import, const struct aiMesh *mesh)
{
    static const uint8_t repeats[2] = {PICTURE_REPEATS, PICTURE_REPEATS};
    struct picture_use use;
    struct aiString name;
    import->picture = import->mask = import->holes = 0;
    import->emission = 0;
    import->light = LIGHT_NONE;
    import->own = NULL;
    if (mesh->mMaterialIndex >= import->scene->mNumMaterials) return;
    const struct aiMaterial *material = import->scene->mMaterials[mesh->mMaterialIndex];
    import->own = obj_material(&import->numbers.obj, material);
    if (picture_of_colour(material, &use)) import->picture = picture_number(import, use.name.data, use.wrap);
    import->uv_set = use.uv_set;
    if (import->picture && is_sky(import, material)) {
        take_sky(import);
        return;
    }
    take_light(import, material);
    if (picture_mask_of(material, &name)) import->mask = picture_number(import, name.data, repeats);
    if (!import->mask && import->picture && import->paint.textures_blend &&
        import->model->pictures[import->picture - 1].has_alpha)
        import->mask = import->picture;
    take_mask(import);
    if (import->picture && import->model->pictures[import->picture - 1].is_masked)
        import->holes = picture_transparency(&import->model->pictures[import->picture - 1]);
}

/* What a file says is no number is not missing. */
static double said(double number)
{
    if (number > (PLACE_NONE + PLACE_NO_NUMBER) / 2) return NAN;
    return isnan(number) || number > PLACE_NO_NUMBER / 2 ? (double)INFINITY : number;
}

/* The part of its picture that a material shows. */
static void change_uv(const struct import *import, double uv[2])
{
    const struct mtl_map *map = import->own ? mtl_map_of(import->own) : NULL;
    for (int i = 0; map && i < 2; i++)
        uv[i] = uv[i] * map->scale[i] + map->offset[i];
}

/* The library counts v from the bottom. Without coordinates there is nothing to show: NaN says so. */
static bool add_uvs(struct import *import, const struct aiMesh *mesh, uint32_t first_point)
{
    struct model *model = import->model;
    if (!import->picture) return true;
    if (!model->uvs) model->uvs = calloc(import->point_total, sizeof *model->uvs);
    if (!model->uvs) return error_set(import->err, "%s: not enough memory", import->path);
    const struct aiVector3D *uvs =
        import->uv_set < AI_MAX_NUMBER_OF_TEXTURECOORDS ? mesh->mTextureCoords[import->uv_set] : NULL;
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        double *uv = model->uvs[first_point + i];
        uv[0] = uvs ? said((double)uvs[i].x) : NAN;
        uv[1] = uvs ? said((double)uvs[i].y) : NAN;
        change_uv(import, uv);
        uv[1] = 1.0 - uv[1];
    }
    return true;
}

static bool is_shown_as_sky(const struct import *import)
{
    return import->picture && import->model->pictures[import->picture - 1].sky.times;
}

static bool add_face(struct import *import, const struct aiFace *from, uint32_t first_point, uint32_t colour)
{
    struct model *model = import->model;
    bool mirrored = affine_mirrors(&import->transform);
    struct model_face *face = &model->faces[model->face_count++];
    *face = (struct model_face){.first = (uint32_t)model->corner_count,
                                .count = from->mNumIndices,
                                .colour = colour,
                                .picture = import->picture,
                                .two_sided = import->paint.two_sided,
                                .emission = import->emission,
                                .unlit = import->paint.unlit || import->light == LIGHT_ALONE || is_shown_as_sky(import),
                                .mover = import->mover};
    if (face->picture) model->pictures[face->picture - 1].faces++;
    if (import->mask) model->pictures[import->mask - 1].clear_faces++;
    import->light_faces[import->light]++;
    for (unsigned k = 0; k < from->mNumIndices; k++) {
        uint32_t corner = first_point + from->mIndices[mirrored ? from->mNumIndices - 1 - k : k];
        const double *p = model->points[corner];
        if (!isfinite(p[0]) || !isfinite(p[1]) || !isfinite(p[2]))
            return error_set(import->err, "%s: face %zu has a corner whose coordinates are NaN or infinite",
                             import->path, model->face_count);
        model->corners[model->corner_count++] = corner;
    }
    return true;
}

static bool add_mesh(struct import *import, const struct aiMesh *mesh)
{
    uint32_t first_point = (uint32_t)import->model->point_count;
    if (!add_points(import, mesh)) return false;
    import->paint = model_paint_of(import->scene, mesh);
    find_pictures(import, mesh);
    if (!add_uvs(import, mesh, first_point)) return false;
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices < 3) continue;
        bool varies;
        const uint32_t colour = model_face_colour(&import->paint, mesh, face, &varies);
        import->model->faces_of_many_colours += varies;
        if (!add_face(import, face, first_point, colour) ||
            !set_transparency(import, model_face_opacity(&import->paint, mesh, face)))
            return false;
    }
    return true;
}

static bool allocate(struct import *import)
{
    struct model *model = import->model;
    if (model->face_count == 0) return error_set(import->err, "%s: there are no faces in it", import->path);
    model->points = calloc(model->point_count, sizeof *model->points);
    model->corners = calloc(model->corner_count, sizeof *model->corners);
    model->faces = calloc(model->face_count, sizeof *model->faces);
    import->point_total = model->point_count;
    model->point_count = model->corner_count = model->face_count = 0;
    if (!model->points || !model->corners || !model->faces)
        return error_set(import->err, "%s: not enough memory", import->path);
    return true;
}

static bool read_scene(struct import *import)
{
    const struct aiNode *root = import->scene->mRootNode;
    if (!root) return error_set(import->err, "%s: there is no scene in it", import->path);
    return node_transforms_read(import->path, import->plain.path ? &import->plain.file : NULL, import->scene,
                                &import->transforms, import->err) &&
           motions_find(import->path, import->scene, &import->transforms, import->model, &import->motions,
                        import->err) &&
           walk(import, root, affine_identity(), 0, count_mesh) && allocate(import) &&
           walk(import, root, affine_identity(), 0, add_mesh) &&
           motions_set_keys(&import->motions, &import->step_m, import->err);
}

/* The library drops such faces with no more than a line in its log. */
static void watch_log(const char *message, char *dropped)
{
    if (strstr(message, "out-of-range")) *dropped = true;
}

static bool refuse(const char *path, struct error *err)
{
    const char *reason = aiGetErrorString();
    /* Whatever nobody else takes is tried as Blender's. */
    const bool is_unknown = strstr(reason, "BLENDER magic") && !path_has_suffix(path, ".blend");
    if (is_unknown || strstr(reason, "No suitable reader")) reason = "not in a format that the importer knows";
    if (strstr(reason, "bad_alloc")) reason = "it asks for more memory than the importer gets";
    size_t length = strlen(reason);
    while (length > 0 && strchr(" .\r\n", reason[length - 1]))
        length--;
    return error_set(err, "%s: %.*s", path, (int)length, reason);
}

/* library_path: NULL if the library is to take the file for what it is. */
static const struct aiScene *import_file(const char *path, const char *library_path,
                                         const struct vertex_numbers *numbers, struct error *err)
{
    char dropped = false;
    struct aiLogStream log = {.callback = watch_log, .user = &dropped};
    const char *taken_for = library_path ? library_path : path;
    const struct model_io_instead instead = {taken_for, numbers->file.bytes, numbers->file.size_b, library_path != NULL,
                                             &numbers->materials};
    struct aiFileIO io = model_io(&instead);
    struct aiPropertyStore *settings = aiCreatePropertyStore();
    /* Else a file without a mesh would get one made up from its skeleton. */
    aiSetImportPropertyInteger(settings, AI_CONFIG_IMPORT_NO_SKELETON_MESHES, 1);
    aiAttachLogStream(&log);
    const struct aiScene *scene = aiImportFileExWithProperties(taken_for, 0, &io, settings);
    aiDetachLogStream(&log);
    aiReleasePropertyStore(settings);
    if (scene && !dropped) return scene;
    aiReleaseImport(scene);
    if (companions_refused(err)) return NULL;
    if (dropped)
        error_set(err, "%s: vertex indices of some faces are out of range", path);
    else
        refuse(path, err);
    return NULL;
}

static bool import_level(const char *path, const struct level_path *level, struct model *model, struct error *err)
{
    char file[WAD_PATH_B];
    for (size_t i = 0; wad_path_at(level->files, i, file); i++)
        inputs_note(file);
    return level_import(path, !pictures_are_left_out(), model, err);
}

/* What the library is to read of a glTF 2.0 file, and what vertices stand for there. */
static bool take_plain(struct import *import)
{
    if (!gltf_plain_make(import->path, &import->plain, import->model, import->err)) return false;
    if (!import->plain.path) return true;
    import->numbers.file = import->plain.glb;
    import->numbers.table = import->plain.table;
    import->plain.glb = (struct whole_file){0};
    import->plain.table = (struct vertex_table){0};
    return true;
}

static void note_light(const struct import *import)
{
    if (import->light_faces[LIGHT_DIMMED])
        model_note(import->model,
                   "%zu faces emit light and have a texture: baked light dims both; --unlit shows them undimmed",
                   import->light_faces[LIGHT_DIMMED]);
    if (import->light_faces[LIGHT_LOST])
        model_note(import->model,
                   "%zu faces are drawn without the light that they emit: its texture has other coordinates than that "
                   "of their colour",
                   import->light_faces[LIGHT_LOST]);
}

static void note_sky(struct model *model, bool has_sky)
{
    if (pictures_sky() && !pictures_are_left_out() && !has_sky)
        model_note(model, "--sky: no material of that name has a picture");
}

static void take_unit(struct import *import)
{
    const double unit_m = model_unit_m(import->path, import->scene);
    if (unit_m != 1) model_to_metres(import->model, unit_m);
    float_step_note(import->model, import->step_m * unit_m);
}

static bool import_by_library(const char *path, struct model *model, struct error *err)
{
    if (!model_is_whole(path, err)) return false;
    struct import import = {.path = path, .model = model, .err = err};
    companions_begin(path);
    if (!vertex_numbers_make(path, &import.numbers, err) || !take_plain(&import)) {
        model_free(model);
        return false;
    }
    import.scene = import_file(path, import.plain.path, &import.numbers, err);
    if (import.scene) pictures_note(import.scene);
    bool ok = import.scene && read_scene(&import) && !companions_refused(err);
    if (ok) take_unit(&import);
    if (ok) note_light(&import);
    if (ok) note_sky(model, import.has_sky);
    motions_free(&import.motions);
    if (ok) obj_tell(&import.numbers.obj, model);
    masked_pictures_free(&import.masked);
    emissive_pictures_free(&import.emissive);
    node_transforms_free(&import.transforms);
    aiReleaseImport(import.scene);
    vertex_numbers_free(&import.numbers);
    gltf_plain_free(&import.plain);
    if (!ok) model_free(model);
    return ok;
}

static bool import_own(const char *path, model_builder *read, struct model *model, struct error *err)
{
    const bool ok = model_build_from(path, read, model, err);
    if (ok) note_sky(model, false);
    return ok;
}

bool import_model(const char *path, struct model *model, struct error *err)
{
    struct level_path level;
    *model = (struct model){0};
    if (level_path_parse(path, &level)) return import_level(path, &level, model, err);
    if (!model_io_check(path, err)) return false;
    model_builder *const own = own_format_of(path);
    if (!(own ? import_own(path, own, model, err) : import_by_library(path, model, err))) return false;
    if (model->faces_of_many_colours)
        model_note(model, "%zu faces have colours that change over them; each is drawn in their mean",
                   model->faces_of_many_colours);
    companions_tell(model);
    return true;
}
