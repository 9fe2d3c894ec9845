/* SPDX-License-Identifier: MIT
 *
 * Everything is small: points are found again by looking at all of them. */
#include "mesh_rig.h"

#include "cmocka_ready.h"
#include "compiler/compile_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 20000, CORNERS_MAX = 80000, POLYGONS_MAX = 20000 };
static const double PI = 3.14159265358979323846;

struct mesh mesh_rig(double units_per_m)
{
    struct mesh mesh = {.grid = {.units_per_m = units_per_m}};
    mesh.points = malloc(POINTS_MAX * sizeof *mesh.points);
    mesh.corners = malloc(CORNERS_MAX * sizeof *mesh.corners);
    mesh.polygons = malloc(POLYGONS_MAX * sizeof *mesh.polygons);
    assert_true(mesh.points && mesh.corners && mesh.polygons);
    return mesh;
}

void mesh_rig_free(struct mesh *mesh)
{
    free(mesh->points);
    free(mesh->corners);
    free(mesh->polygons);
}

static uint32_t point_index(struct mesh *mesh, const double point_m[3])
{
    for (size_t i = mesh->point_count; i-- > 0;)
        if (memcmp(mesh->points[i], point_m, sizeof mesh->points[i]) == 0) return (uint32_t)i;
    assert_true(mesh->point_count < POINTS_MAX);
    memcpy(mesh->points[mesh->point_count], point_m, sizeof *mesh->points);
    return (uint32_t)mesh->point_count++;
}

struct mesh_polygon *mesh_rig_add(struct mesh *mesh, const double (*corners_m)[3], size_t count)
{
    assert_true(mesh->polygon_count < POLYGONS_MAX && mesh->corner_count + count <= CORNERS_MAX);
    struct mesh_polygon *polygon = &mesh->polygons[mesh->polygon_count++];
    *polygon = (struct mesh_polygon){.first = (uint32_t)mesh->corner_count,
                                     .count = (uint32_t)count,
                                     .face = (uint32_t)mesh->polygon_count,
                                     .colour = RIG_COLOUR};
    for (size_t i = 0; i < count; i++)
        mesh->corners[mesh->corner_count++] = point_index(mesh, corners_m[i]);
    mesh->counts.faces = mesh->polygon_count;
    return polygon;
}

void mesh_rig_triangle(struct mesh *mesh, const double (*corners_m)[3], int second, int third)
{
    const int corners[3] = {0, second, third};
    double at_m[3][3];
    for (int i = 0; i < 3; i++)
        memcpy(at_m[i], corners_m[corners[i]], sizeof at_m[i]);
    mesh_rig_add(mesh, (const double(*)[3])at_m, 3);
}

void mesh_rig_wall(struct mesh *mesh, uint32_t face, double x0, double y0, double x1, double y1)
{
    const double corners_m[4][3] = {{y0, -1.0, x0}, {y0, 1.0, x0}, {y1, 1.0, x1}, {y1, -1.0, x1}};
    mesh_rig_add(mesh, corners_m, 4)->face = face;
}

static void turned(const double at[3], double yaw, double pitch, double out[3])
{
    double y = at[1] * cos(pitch) - at[2] * sin(pitch), z = at[1] * sin(pitch) + at[2] * cos(pitch);
    out[0] = at[0] * cos(yaw) + z * sin(yaw);
    out[1] = y;
    out[2] = -at[0] * sin(yaw) + z * cos(yaw);
}

void mesh_rig_box(struct mesh *mesh, const double centre_m[3], const double half_m[3], double yaw, double pitch)
{
    static const int faces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    double corners_m[8][3], quad_m[4][3];
    for (int i = 0; i < 8; i++) {
        const double at[3] = {i & 4 ? half_m[0] : -half_m[0], i & 2 ? half_m[1] : -half_m[1],
                              i & 1 ? half_m[2] : -half_m[2]};
        turned(at, yaw, pitch, corners_m[i]);
        for (int k = 0; k < 3; k++)
            corners_m[i][k] += centre_m[k];
    }
    for (int face = 0; face < 6; face++) {
        for (int i = 0; i < 4; i++)
            memcpy(quad_m[i], corners_m[faces[face][i]], sizeof quad_m[i]);
        mesh_rig_add(mesh, (const double(*)[3])quad_m, 4);
    }
}

static void ball_point(const double centre_m[3], double radius_m, unsigned rings, unsigned ring, unsigned step,
                       double out[3])
{
    double tilt = PI * ring / rings, turn = PI * (step % (2 * rings)) / rings;
    double across_m = ring == 0 || ring == rings ? 0.0 : radius_m * sin(tilt); /* one point at each pole */
    out[0] = centre_m[0] + across_m * cos(turn);
    out[1] = centre_m[1] + radius_m * cos(tilt);
    out[2] = centre_m[2] - across_m * sin(turn);
}

void mesh_rig_ball(struct mesh *mesh, const double centre_m[3], double radius_m, unsigned rings)
{
    for (unsigned ring = 0; ring < rings; ring++)
        for (unsigned step = 0; step < 2 * rings; step++) {
            double quad_m[4][3];
            ball_point(centre_m, radius_m, rings, ring, step, quad_m[0]);
            ball_point(centre_m, radius_m, rings, ring + 1, step, quad_m[1]);
            ball_point(centre_m, radius_m, rings, ring + 1, step + 1, quad_m[2]);
            ball_point(centre_m, radius_m, rings, ring, step + 1, quad_m[3]);
            bool top = ring == 0, bottom = ring == rings - 1;
            if (bottom) memcpy(quad_m[2], quad_m[3], sizeof quad_m[2]);
            mesh_rig_add(mesh, (const double(*)[3])quad_m, top || bottom ? 3 : 4);
        }
}

void mesh_rig_solids(struct mesh *mesh, struct random *random, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        double centre_m[3], half_m[3];
        for (int k = 0; k < 3; k++) {
            centre_m[k] = random_unit(random) * 8.0 - 4.0;
            half_m[k] = i % 3 == 0 && k != (int)(i % 2) ? 0.0005 + random_unit(random) * 0.002 /* needle */
                                                        : 0.1 + random_unit(random) * 3.0;
        }
        if (i % 5 == 4)
            mesh_rig_ball(mesh, centre_m, half_m[0], 5);
        else
            mesh_rig_box(mesh, centre_m, half_m, random_unit(random) * 6.0, random_unit(random) * 6.0);
    }
}

struct compiled mesh_rig_compile(const struct mesh *mesh, const char *splitter, double tolerance_units)
{
    const struct compile_options options = {.tolerance_units = tolerance_units, .splitter = splitter};
    struct compiled scene;
    struct error err;
    if (!compile_mesh(mesh, &options, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}
