/* SPDX-License-Identifier: MIT
 *
 * All memory is model_free()'s. */
#include "texture_rig.h"

#include "cmocka_ready.h"
#include "compiler/compile_mesh.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

uint32_t texture_rig_picture(struct model *model, uint32_t w_px, uint32_t h_px, struct random *random)
{
    model->pictures = realloc(model->pictures, (model->picture_count + 1) * sizeof *model->pictures);
    struct picture *picture = &model->pictures[model->picture_count];
    *picture = (struct picture){.found_w_px = w_px, .found_h_px = h_px, .w_px = w_px, .h_px = h_px};
    snprintf(picture->name, sizeof picture->name, "picture %zu", model->picture_count + 1);
    picture->pixels = calloc((size_t)w_px * h_px, sizeof *picture->pixels);
    for (size_t i = 0; i < (size_t)w_px * h_px; i++)
        picture->pixels[i] = (uint32_t)(random_u64(random) & 0xFFFFFF);
    return (uint32_t)++model->picture_count;
}

void texture_rig_face(struct model *model, uint32_t picture, size_t count, const double (*places)[3],
                      const double (*uvs)[2])
{
    model->points = realloc(model->points, (model->point_count + count) * sizeof *model->points);
    model->uvs = realloc(model->uvs, (model->point_count + count) * sizeof *model->uvs);
    model->corners = realloc(model->corners, (model->corner_count + count) * sizeof *model->corners);
    model->faces = realloc(model->faces, (model->face_count + 1) * sizeof *model->faces);
    model->faces[model->face_count++] = (struct model_face){
        .first = (uint32_t)model->corner_count, .count = (uint32_t)count, .colour = 0xFFFFFF, .picture = picture};
    for (size_t i = 0; i < count; i++) {
        memcpy(model->points[model->point_count], places[i], sizeof *places);
        memcpy(model->uvs[model->point_count], uvs[i], sizeof *uvs);
        model->corners[model->corner_count++] = (uint32_t)model->point_count++;
    }
    if (picture) model->pictures[picture - 1].faces++;
}

void texture_rig_room(struct model *model, uint32_t picture, double repeat)
{
    for (int side = 0; side < 6; side++) {
        const int x = side / 2, y = (x + 1) % 3, z = (x + 2) % 3;
        double places[4][3], uvs[4][2];
        for (int k = 0; k < 4; k++) {
            const int corner = side % 2 ? 3 - k : k; /* round the other way on the opposite side */
            const double right = corner == 0 || corner == 3, up = corner >= 2;
            places[k][x] = side % 2 ? -1 : 1;
            places[k][y] = 2 * right - 1;
            places[k][z] = 2 * up - 1;
            uvs[k][0] = repeat * right;
            uvs[k][1] = repeat * up;
        }
        texture_rig_face(model, picture, 4, places, uvs);
    }
}

struct compiled texture_rig_compile(const struct model *model, struct mesh *mesh, const struct core *core)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .core = core};
    struct compiled scene = {0};
    struct error err;
    if (!mesh_clean(model, mesh, &err) || !mesh_insert_t_vertices(mesh, &err) ||
        !compile_mesh(mesh, &options, &scene, &err))
        fail_msg("%s", err.text);
    return scene;
}

struct lim_camera texture_rig_camera(struct random *random, const struct grid *grid, double reach_m,
                                     const double tans[2], unsigned w_px, unsigned h_px)
{
    struct lim_camera camera = {.near_q8 = 256};
    for (int i = 0; i < 3; i++)
        camera.eye_q8[i] = (int32_t)((2 * random_unit(random) - 1) * reach_m * grid->units_per_m * 256);
    camera.yaw = (uint32_t)random_u64(random);
    camera.pitch = (uint32_t)random_in(random, -(INT64_C(1) << 30), INT64_C(1) << 30);
    camera.roll = (uint32_t)random_u64(random);
    camera.tan_x_q28 = (uint32_t)((tans[0] + random_unit(random) * (tans[1] - tans[0])) * (1 << 28));
    camera.tan_y_q28 = camera.tan_x_q28 / w_px * h_px;
    return camera;
}

void texture_rig_draw(struct simulator *simulator, const struct lim_camera *camera)
{
    struct error err;
    if (!simulator_frame(simulator, camera, &err)) fail_msg("%s", err.text);
}

static double radians(uint32_t angle)
{
    return ldexp(2 * 3.14159265358979323846 * angle, -32);
}

void texture_rig_axes(const struct lim_camera *camera, double right[3], double down[3], double ahead[3])
{
    const double y = radians(camera->yaw), p = radians(camera->pitch), r = radians(camera->roll);
    const double flat[3] = {cos(y), 0, -sin(y)}, forward[3] = {-sin(y) * cos(p), sin(p), -cos(y) * cos(p)};
    const double up[3] = {sin(y) * sin(p), cos(p), cos(y) * sin(p)};
    for (int i = 0; i < 3; i++) {
        ahead[i] = forward[i];
        right[i] = flat[i] * cos(r) - up[i] * sin(r);
        down[i] = -up[i] * cos(r) - flat[i] * sin(r);
    }
}
