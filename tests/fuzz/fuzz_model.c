/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a model file of the format that its suffix says, with the files that it names beside it. What is refused
 * is refused in one line that begins with the file's name, and leaves nothing; what is read is within its bounds. If it
 * is small it is compiled too: refused in one line, or a scene that lim_check() takes and whose frames have no pixel
 * unpainted.
 *
 * The importer library is called in this process, as its child process calls it, for that is a thousand times quicker.
 * It is not instrumented, and crashes on some files: fuzz.sh tells those crashes from ours by their stack. */
#include "fuzz_model.h"
#include "cameras/camera_path.h"
#include "compiler/compile.h"
#include "compiler/moving_compile.h"
#include "core/core.h"
#include "fuzz.h"
#include "fuzz_show.h"
#include "readers/import.h"
#include "readers/source.h"
#include "scene/lim_check.h"
#include "scene/moving.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { FACES_MAX = 24, CORNERS_MAX = 96, PICTURE_PX = 16, SPLIT = 0xFF };

/* The model ------------------------------------------------------------------------------------ */

static const char *check_face(const struct model *model, const struct model_face *face)
{
    if (face->count < 3 || face->first > model->corner_count || face->count > model->corner_count - face->first)
        return "a face's corners are out of range";
    for (uint32_t k = 0; k < face->count; k++) {
        const uint32_t corner = model->corners[face->first + k];
        if (corner >= model->point_count) return "a corner is out of range";
        for (int i = 0; i < 3; i++)
            if (!isfinite(model->points[corner][i])) return "a corner is no number";
    }
    if (face->colour >> 24) return "a colour of more than 24 bits";
    return face->picture > model->picture_count || face->mover > model->mover_count
               ? "a face's picture or mover is out of range"
               : NULL;
}

static const char *check_mover(const struct model *model, const struct model_mover *mover)
{
    if (!memchr(mover->name, '\0', sizeof mover->name)) return "a mover's name has no end";
    if (mover->key_count < 1 || mover->first_key > model->key_count ||
        mover->key_count > model->key_count - mover->first_key)
        return "a mover's keys are out of range";
    for (uint32_t k = 0; k < mover->key_count; k++) {
        const struct model_key *key = &model->keys[mover->first_key + k];
        double length = 0;
        for (int i = 0; i < 4; i++)
            length = hypot(length, key->pose.turn[i]);
        if (!isfinite(key->time_s) || (k && key->time_s < key[-1].time_s)) return "keys out of order";
        if (!(fabs(length - 1) < 1e-3)) return "a key's orientation is none";
    }
    return NULL;
}

static const char *check_model(const struct model *model)
{
    const char *broken = model->face_count ? NULL : "a model without a face";

    for (size_t i = 0; !broken && i < model->face_count; i++)
        broken = check_face(model, &model->faces[i]);
    for (size_t i = 0; !broken && i < model->mover_count; i++)
        broken = check_mover(model, &model->movers[i]);
    for (size_t i = 0; !broken && i < model->picture_count; i++)
        if (!model->pictures[i].pixels == !model->pictures[i].reason[0]) broken = "a picture with a reason, or neither";
    return broken;
}

/* The scene ------------------------------------------------------------------------------------ */

/* How to compile: the checksum of the file throws the dice. */
static struct compile_options options_of(uint32_t dice)
{
    static const enum tree_kind trees[] = {TREE_BSP, TREE_AUTO};

    return (struct compile_options){.tolerance_units = dice & 1 ? 0.5 : 0,
                                    .splitter = "fewest",
                                    .tree = trees[dice >> 1 & 1],
                                    .keep_faces = dice & 4,
                                    .core = dice & 8 ? &core_exact : &core_fast,
                                    .w_px = PICTURE_PX,
                                    .h_px = PICTURE_PX,
                                    .unlit = dice & 16,
                                    .wireframe = dice & 32};
}

static bool camera_of(const struct compiled *scene, size_t frame, struct lim_camera *camera, struct error *err)
{
    struct camera_path path;
    struct lens lens;

    if (!lens_init(&lens, 60, lens_default_near_m(&scene->grid), PICTURE_PX, PICTURE_PX, err) ||
        !camera_path_orbit(scene, &lens, 5, &path, err))
        return false;
    const bool ok = camera_path_to_camera(&path, frame, &lens, &scene->grid, camera, err);
    camera_path_free(&path);
    return ok;
}

static const char *draw(const struct compiled *scene, struct moving *moving, uint32_t dice)
{
    static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_PAINTER};
    struct fuzz_subject subject = {.scene = &scene->scene,
                                   .instances = {moving->instances, moving->instances},
                                   .instance_count = (uint16_t)moving->count,
                                   .w_px = PICTURE_PX,
                                   .h_px = PICTURE_PX,
                                   .limits = moving->limits,
                                   .light = moving->light};
    const struct fuzz_look look = {.core = dice & 8 ? &core_exact : &core_fast, .method = orders[dice >> 6 & 1]};
    const struct fuzz_means means[2] = {{.memory = 255}, {.memory = 255, .quanta = 9, .page_px = 1, .runs = 99}};
    struct error err;

    for (size_t frame = 0; frame < FUZZ_FRAMES; frame++)
        if (!camera_of(scene, frame, &subject.cameras[frame], &err)) return fuzz_check_refusal(err.text, NULL);
    if (moving->count) moving_pose(moving, dice % 1000 / 500.0);
    return fuzz_show_both(&subject, &look, means);
}

static const char *check_scene(const struct compiled *scene, struct moving *moving, uint32_t dice)
{
    struct error err;

    if (!lim_check(&scene->scene, &err)) return "a scene was compiled that breaks the rules of scenes";
    for (size_t i = 0; i < moving->count; i++)
        if (!lim_check(&moving->objects[i].scene.scene, &err)) return "an object was compiled that breaks the rules";
    if (!scene->scene.limits.depth) return NULL;
    return draw(scene, moving, dice);
}

/* Takes the model. */
static const char *compile(struct model *model, uint32_t dice)
{
    const struct compile_options options = options_of(dice);
    const struct moving_options movers = {.mode = MOVING_ON, .light = dice & 256};
    struct compiled scene = {0};
    struct moving moving;
    struct error err;

    const bool ok = moving_compile_model(model, &options, &movers, &scene, &moving, &err);
    const char *broken = ok ? check_scene(&scene, &moving, dice) : fuzz_check_refusal(err.text, NULL);
    moving_free(&moving);
    compiled_free(&scene);
    return broken;
}

/* The reference's own reader: refused in one line, or corners where the importer has them. */
static const char *check_source(const char *path, struct model *model)
{
    struct error err;

    if (!source_take(path, model, &err)) return fuzz_check_refusal(err.text, path);
    for (size_t i = 0; model->source_points && i < model->corner_count; i++)
        for (int axis = 0; axis < 3; axis++)
            if (!isfinite(model->source_points[model->corners[i]][axis])) return "the reference has no number";
    return NULL;
}

const char *fuzz_model_read(const char *path, uint32_t dice)
{
    struct model model;
    struct error err;

    if (!import_model(path, &model, &err)) {
        if (model.points || model.faces) return "a refused model left something behind";
        char beside[256]; /* materials, too, are named model.something */
        snprintf(beside, sizeof beside, "%.*s", (int)(strrchr(path, '.') - path), path);
        const char *const name = strrchr(beside, '/') ? strrchr(beside, '/') + 1 : beside; /* as a model says it */
        return fuzz_check_refusal(err.text, strncmp(err.text, name, strlen(name)) == 0 ? name : beside);
    }
    const char *broken = check_model(&model);
    if (!broken) broken = check_source(path, &model);
    if (!broken && model.face_count <= FACES_MAX && model.corner_count <= CORNERS_MAX) return compile(&model, dice);
    model_free(&model);
    return broken;
}

/* The files ------------------------------------------------------------------------------------ */

static const char *run_file(const char *name, const struct fuzz_bytes *file, uint32_t dice)
{
    char path[512];

    snprintf(path, sizeof path, "%s", fuzz_as_named_file(name, file->at, file->left_b));
    return fuzz_model_read(path, dice);
}

static uint32_t dice_of(const uint8_t *bytes, size_t size_b)
{
    return (uint32_t)crc32(0, bytes, (uInt)size_b);
}

/* Up to two bytes 0xFF, which no text has: before the material library model.mtl, and before model.png. */
static const char *run_obj(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};
    const struct fuzz_bytes model = fuzz_part(&bytes, SPLIT), materials = fuzz_part(&bytes, SPLIT);

    fuzz_as_named_file("model.mtl", materials.at, materials.left_b);
    fuzz_as_named_file("model.png", bytes.at, bytes.left_b);
    return run_file("model.obj", &model, dice_of(input, size_b));
}

static const char *run_gltf(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};

    if (size_b >= 4 && memcmp(input, "glTF", 4) == 0) return run_file("model.glb", &bytes, dice_of(input, size_b));
    const struct fuzz_bytes model = fuzz_part(&bytes, SPLIT);
    fuzz_as_named_file("model.bin", bytes.at, bytes.left_b);
    return run_file("model.gltf", &model, dice_of(input, size_b));
}

static const char *run_ply(const uint8_t *input, size_t size_b)
{
    const struct fuzz_bytes bytes = {input, size_b};

    return run_file("model.ply", &bytes, dice_of(input, size_b));
}

static const char *run_off(const uint8_t *input, size_t size_b)
{
    const struct fuzz_bytes bytes = {input, size_b};

    return run_file("model.off", &bytes, dice_of(input, size_b));
}

static const char *run_stl(const uint8_t *input, size_t size_b)
{
    const struct fuzz_bytes bytes = {input, size_b};

    return run_file("model.stl", &bytes, dice_of(input, size_b));
}

/* What a mutation leaves wrong ----------------------------------------------------------------- */

enum { GLB_HEAD_B = 12, GLB_CHUNK_B = 8, STL_HEAD_B = 84, STL_FACE_B = 50 };

static void put_u32(uint8_t *at, size_t value)
{
    for (int i = 0; i < 4; i++)
        at[i] = (uint8_t)(value >> 8 * i);
}

static size_t get_u32(const uint8_t *at)
{
    return at[0] | (size_t)at[1] << 8 | (size_t)at[2] << 16 | (size_t)at[3] << 24;
}

/* GLB: version, length, and two chunks, JSON as long as it says and the rest. */
static size_t mend_gltf(uint8_t *bytes, size_t size_b, size_t max_b)
{
    (void)max_b;
    if (size_b < GLB_HEAD_B + 2 * GLB_CHUNK_B || memcmp(bytes, "glTF", 4) != 0) return size_b;
    const size_t room_b = size_b - GLB_HEAD_B - 2 * GLB_CHUNK_B, said_b = get_u32(bytes + GLB_HEAD_B);
    const size_t json_b = said_b <= room_b ? said_b : room_b;
    uint8_t *const second = bytes + GLB_HEAD_B + GLB_CHUNK_B + json_b;
    put_u32(bytes + 4, 2);
    put_u32(bytes + 8, size_b);
    put_u32(bytes + GLB_HEAD_B, json_b);
    memcpy(bytes + GLB_HEAD_B + 4, "JSON", 4);
    put_u32(second, room_b - json_b);
    memcpy(second + 4, "BIN\0", 4);
    return size_b;
}

/* Binary STL: as many faces as there are bytes for. */
static size_t mend_stl(uint8_t *bytes, size_t size_b, size_t max_b)
{
    (void)max_b;
    if (size_b < STL_HEAD_B || memcmp(bytes, "solid", 5) == 0) return size_b;
    const size_t faces = (size_b - STL_HEAD_B) / STL_FACE_B;
    put_u32(bytes + STL_HEAD_B - 4, faces);
    return STL_HEAD_B + faces * STL_FACE_B;
}

const struct fuzz_target fuzz_obj = {"obj", run_obj, NULL};
const struct fuzz_target fuzz_gltf = {"gltf", run_gltf, mend_gltf};
const struct fuzz_target fuzz_ply = {"ply", run_ply, NULL};
const struct fuzz_target fuzz_stl = {"stl", run_stl, mend_stl};
const struct fuzz_target fuzz_off = {"off", run_off, NULL};
