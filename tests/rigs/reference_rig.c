/* SPDX-License-Identifier: MIT
 *
 * Each polygon has corners of its own: nothing is shared. */
#include "reference_rig.h"

#include "cmocka_ready.h"

#include <string.h>

const struct lens LENS = {.tan_x = 1.0, .tan_y = 0.75, .near_m = 0.1};
const struct viewpoint ALONG_MINUS_Z = {.target_m = {0.0, 0.0, -1.0}};

void scene_clear(struct scene *scene)
{
    memset(scene, 0, sizeof *scene);
    scene->mesh = (struct mesh){.points = scene->points,
                                .corners = scene->corners,
                                .polygons = scene->polygons,
                                .grid = {.units_per_m = 1000.0}};
}

void scene_add(struct scene *scene, uint32_t face, uint32_t count, double (*corners)[3])
{
    struct mesh *mesh = &scene->mesh;
    scene->polygons[mesh->polygon_count++] =
        (struct mesh_polygon){.first = (uint32_t)mesh->corner_count, .count = count, .face = face};
    for (uint32_t i = 0; i < count; i++) {
        memcpy(scene->points[mesh->point_count], corners[i], sizeof scene->points[0]);
        scene->corners[mesh->corner_count++] = (uint32_t)mesh->point_count++;
    }
}

void scene_add_square(struct scene *scene, uint32_t face, double half_m, double depth_m)
{
    double corners[4][3] = {{-half_m, -half_m, -depth_m},
                            {half_m, -half_m, -depth_m},
                            {half_m, half_m, -depth_m},
                            {-half_m, half_m, -depth_m}};
    scene_add(scene, face, 4, corners);
}

struct reference draw_sized(const struct scene *scene, const struct viewpoint *viewpoint, unsigned w_px, unsigned h_px)
{
    struct reference reference;
    struct error err;
    assert_true(reference_init(&reference, &scene->mesh, w_px, h_px, &err));
    reference_draw(&reference, viewpoint, &LENS);
    return reference;
}

struct reference draw(const struct scene *scene, const struct viewpoint *viewpoint)
{
    return draw_sized(scene, viewpoint, W_PX, H_PX);
}
