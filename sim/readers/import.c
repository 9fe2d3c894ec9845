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
#include "files/picture.h"
#include "formats/float_step.h"
#include "formats/left_out.h"
#include "formats/model_limits.h"
#include "formats/own_formats.h"
#include "formats/refusal.h"
#include "gltf/gltf_plain.h"
#include "levels/level_import.h"
#include "levels/level_path.h"
#include "model/model_colour.h"
#include "model/note_words.h"
#include "readers/import_motion.h"
#include "readers/import_pictures.h"
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

struct import {
    const char *path;
    const struct aiScene *scene;
    struct model *model;
    struct error *err;
    struct node_transform transform; /* of the node being read */
    struct model_paint paint;        /* of the mesh being read */
    struct import_pictures pictures;
    size_t point_total;
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
    if (!face->transparency) face->transparency = import->pictures.holes;
    return true;
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
    const struct mtl_map *map = import->pictures.own ? mtl_map_of(import->pictures.own) : NULL;
    for (int i = 0; map && i < 2; i++)
        uv[i] = uv[i] * map->scale[i] + map->offset[i];
}

/* The library counts v from the bottom. Without coordinates there is nothing to show: NaN says so. */
static bool add_uvs(struct import *import, const struct aiMesh *mesh, uint32_t first_point)
{
    struct model *model = import->model;
    if (!import->pictures.picture) return true;
    if (!model->uvs) model->uvs = calloc(import->point_total, sizeof *model->uvs);
    if (!model->uvs) return error_set(import->err, "%s: not enough memory", import->path);
    const struct aiVector3D *uvs =
        import->pictures.uv_set < AI_MAX_NUMBER_OF_TEXTURECOORDS ? mesh->mTextureCoords[import->pictures.uv_set] : NULL;
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
    return import->pictures.picture && import->model->pictures[import->pictures.picture - 1].sky.times;
}

static bool add_face(struct import *import, const struct aiFace *from, uint32_t first_point, uint32_t colour)
{
    struct model *model = import->model;
    bool mirrored = affine_mirrors(&import->transform);
    struct model_face *face = &model->faces[model->face_count++];
    *face = (struct model_face){.first = (uint32_t)model->corner_count,
                                .count = from->mNumIndices,
                                .colour = colour,
                                .picture = import->pictures.picture,
                                .two_sided = import->paint.two_sided,
                                .emission = import->pictures.emission,
                                .unlit = import->paint.unlit || import->pictures.light == LIGHT_ALONE ||
                                         is_shown_as_sky(import),
                                .mover = import->mover};
    if (face->picture) model->pictures[face->picture - 1].faces++;
    if (import->pictures.mask) model->pictures[import->pictures.mask - 1].clear_faces++;
    import->pictures.light_faces[import->pictures.light]++;
    import->pictures.bright_faces += import->pictures.is_bright;
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
    import_pictures_find(&import->pictures, mesh, &import->numbers.obj, &import->paint);
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
    if (model->face_count == 0) return refusal_set(import->path, WORDS_NO_FACES, import->err);
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
        refusal_set(path, aiGetErrorString(), err);
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

static void note_sky(struct model *model, bool has_sky)
{
    if (pictures_sky() && !pictures_are_left_out() && !has_sky)
        model_note(model, "--sky: no material of that name has a picture");
}

static void take_unit(struct import *import)
{
    const double unit_m = model_unit_m(import->path, import->scene);
    if (unit_m != 1) model_to_metres(import->model, unit_m);
    import->model->says_z_up = model_says_z_up(import->path, import->scene);
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
    import.pictures.scene = import.scene;
    import.pictures.model = model;
    if (import.scene) pictures_note(import.scene);
    bool ok = import.scene && read_scene(&import) && !companions_refused(err);
    if (ok) take_unit(&import);
    if (ok) import_pictures_note(&import.pictures);
    if (ok) note_sky(model, import.pictures.has_sky);
    motions_free(&import.motions);
    if (ok) obj_tell(&import.numbers.obj, model);
    if (ok && !import.plain.path && !path_has_suffix(path, ".obj")) {
        left_out_tell(import.scene, model);
        if (!path_has_suffix(path, ".fbx") && !path_has_suffix(path, ".dae"))
            model_note(model, "its colours, pictures and copies of things may be missing without a word, as its reader "
                              "does not tell what it leaves out");
    }
    import_pictures_free(&import.pictures);
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
    if (model->faces_of_many_colours) model_note(model, "%zu " WORDS_MEAN_COLOURS, model->faces_of_many_colours);
    companions_tell(model);
    return true;
}
