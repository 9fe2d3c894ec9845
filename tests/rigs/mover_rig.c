/* SPDX-License-Identifier: MIT
 *
 * Every mover has one key, so it is where that says at any time. */
#include "mover_rig.h"

#include "accuracy/moving_reference.h"
#include "base/vec3.h"
#include "cmocka_ready.h"
#include "compiler/compile.h"
#include "compiler/moving_compile.h"
#include "scene/moving.h"

#include <stdlib.h>
#include <string.h>

static const double ROOM_LOW_M[3] = {-4, 0, -4}, ROOM_HIGH_M[3] = {4, 3, 4};
static const struct lens LENS = {.tan_x = 0.8, .tan_y = 0.6, .near_m = 0.02};

void mover_rig_moves(struct mover_rig *rig, const struct model_pose *pose)
{
    struct model *model = &rig->model;
    const size_t number = ++model->mover_count;
    model->movers = realloc(model->movers, number * sizeof *model->movers);
    model->keys = realloc(model->keys, number * sizeof *model->keys);
    model->movers[number - 1] =
        (struct model_mover){.rest = {.turn = {0, 0, 0, 1}}, .first_key = (uint32_t)(number - 1), .key_count = 1};
    snprintf(model->movers[number - 1].name, MODEL_NAME_B, "mover %zu", number);
    model->keys[model->key_count++] = (struct model_key){0, *pose};
    for (size_t i = model->face_count; i > 0 && !model->faces[i - 1].mover && i > rig->still; i--)
        model->faces[i - 1].mover = (uint16_t)number;
    rig->still = model->face_count;
}

void mover_rig_stands(struct mover_rig *rig)
{
    rig->still = rig->model.face_count;
}

void mover_rig_add_rooms(struct mover_rig *rig, bool doorway)
{
    struct model *model = &rig->model;

    boxes_add_room(model, ROOM_LOW_M, ROOM_HIGH_M);
    boxes_add_solid(model, (double[3]){-4, 0, -0.1}, (double[3]){doorway ? -0.5 : 4, 3, 0.1});
    if (doorway) boxes_add_solid(model, (double[3]){0.5, 0, -0.1}, (double[3]){4, 3, 0.1});
    if (doorway) boxes_add_solid(model, (double[3]){-0.5, 2, -0.1}, (double[3]){0.5, 3, 0.1});
    mover_rig_stands(rig);
}

void mover_rig_add_box(struct mover_rig *rig, double x_m, double y_m, double z_m, const struct model_pose *pose)
{
    boxes_add_solid(&rig->model, (double[3]){-x_m, -y_m, -z_m}, (double[3]){x_m, y_m, z_m});
    mover_rig_moves(rig, pose);
}

void mover_rig_compile(struct mover_rig *rig, enum lim_method method, const struct core *core)
{
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .tree = rig->tree,
                                            .mesh_leaves = rig->mesh_leaves,
                                            .coordinates = rig->coordinates,
                                            .splitter = "fewest",
                                            .keep_faces = true,
                                            .core = core,
                                            .w_px = MOVER_RIG_W_PX,
                                            .h_px = MOVER_RIG_H_PX,
                                            .unlit = true};
    const struct simulator_setup setup = {MOVER_RIG_W_PX, MOVER_RIG_H_PX, method, SIMULATOR_MEMORY, core};
    const struct moving_options movers = {.mode = MOVING_ON};
    struct error err;
    const bool ok = moving_compile_model(&rig->model, &options, &movers, &rig->scene, &rig->moving, &err) &&
                    ids_init(&rig->ids, &rig->scene, &setup, &err) && ids_set_movers(&rig->ids, &rig->moving, &err) &&
                    moving_reference(&rig->moving, &rig->reference, MOVER_RIG_W_PX, MOVER_RIG_H_PX, &err);
    if (!ok) fail_msg("%s", err.text);
    moving_pose(&rig->moving, 0);
    moving_pose_reference(&rig->moving, &rig->reference, 0);
}

void mover_rig_view(struct mover_rig *rig, const double eye_m[3], const double target_m[3])
{
    struct viewpoint viewpoint = {.line = 1};
    memcpy(viewpoint.eye_m, eye_m, sizeof viewpoint.eye_m);
    memcpy(viewpoint.target_m, target_m, sizeof viewpoint.target_m);
    const struct camera_path path = {"test", &viewpoint, 1};
    struct lim_camera camera;
    struct error err;
    if (!camera_path_to_camera(&path, 0, &LENS, &rig->scene.grid, &camera, &err) ||
        !ids_frame(&rig->ids, &camera, &err))
        fail_msg("%s", err.text);
    reference_draw(&rig->reference, &viewpoint, &LENS);
    const struct compare_counts counts =
        compare_picture(rig->ids.faces, &rig->reference, NULL, 1.0 / rig->scene.grid.units_per_m);
    rig->counts.pixels += counts.pixels;
    rig->counts.wrong += counts.wrong;
    rig->counts.beyond += counts.beyond;
    rig->counts.holes += counts.holes;
}

void mover_rig_limit(struct mover_rig *rig, const struct lim_movers_limits *limits)
{
    struct simulator *simulator = &rig->ids.simulator;
    struct error err;
    free(simulator->mover_mem);
    if (!simulator_set_movers(simulator, rig->ids.instances, rig->moving.count, limits, &err)) fail_msg("%s", err.text);
}

void mover_rig_bend(struct mover_rig *rig, size_t mover, void (*bend)(double at_m[3], double how), double how)
{
    struct error err;
    reference_free(&rig->reference);
    if (!moving_reference(&rig->moving, &rig->reference, MOVER_RIG_W_PX, MOVER_RIG_H_PX, &err))
        fail_msg("%s", err.text);
    reference_bend(&rig->reference, mover, bend, how);
    moving_pose_reference(&rig->moving, &rig->reference, 0);
}

size_t mover_rig_pixels(const struct mover_rig *rig, size_t mover)
{
    size_t count = 0;
    for (size_t i = 0; i < (size_t)MOVER_RIG_W_PX * MOVER_RIG_H_PX; i++) {
        const uint32_t face = rig->ids.faces[i];
        count += face && rig->moving.model.faces[face - 1].mover == mover;
    }
    return count;
}

void mover_rig_assert_right(const struct mover_rig *rig, double ppm)
{
    const struct compare_counts *counts = &rig->counts;

    if (1e6 * (double)counts->wrong > ppm * (double)counts->pixels || counts->holes)
        fail_msg("%zu of %zu pixels wrong, %zu holes", counts->wrong, counts->pixels, counts->holes);
    assert_int_equal(mover_rig_stats(rig)->movers.left_out, 0);
}

const struct lim_stats *mover_rig_stats(const struct mover_rig *rig)
{
    return simulator_stats(&rig->ids.simulator);
}

void mover_rig_free(struct mover_rig *rig)
{
    ids_free(&rig->ids);
    reference_free(&rig->reference);
    moving_free(&rig->moving);
    compiled_free(&rig->scene);
}

struct model_pose mover_rig_pose(double x_m, double y_m, double z_m, const double axis[3], double angle)
{
    const double length = sqrt(vec3_dot(axis, axis)), sine = sin(angle / 2) / length;
    return (struct model_pose){.at_m = {x_m, y_m, z_m},
                               .turn = {axis[0] * sine, axis[1] * sine, axis[2] * sine, cos(angle / 2)}};
}
