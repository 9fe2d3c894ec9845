/* SPDX-License-Identifier: MIT
 *
 * The generator behind room_scene.h. */
#include "room_scene.h"

#include "compiler/compile_mesh.h"
#include "model/grid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FACES_MAX = 2000, SIDE_MAX = 4 };
static const double ROOM_M = 4.0, PITCH_M = 4.2, DOOR_M = 0.9, HEIGHT_M = 2.5, DOOR_HEIGHT_M = 2.0;

void room_scene_begin(struct room_scene *scene)
{
    memset(scene, 0, sizeof *scene);
    scene->model.points = calloc(FACES_MAX * 4, sizeof *scene->model.points);
    scene->model.corners = calloc(FACES_MAX * 4, sizeof *scene->model.corners);
    scene->model.faces = calloc(FACES_MAX, sizeof *scene->model.faces);
    for (int i = 0; i < 3; i++)
        scene->turn[i][i] = 1;
}

void room_scene_free(struct room_scene *scene)
{
    free(scene->model.points);
    free(scene->model.corners);
    free(scene->model.faces);
}

static void turned(const struct room_scene *scene, const double p[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = scene->turn[i][0] * p[0] + scene->turn[i][1] * p[1] + scene->turn[i][2] * p[2];
}

void room_scene_quad(struct room_scene *scene, int axis, double at, int sign, const double a[2], const double b[2],
                     uint32_t colour)
{
    struct model *model = &scene->model;
    struct model_face *face = &model->faces[model->face_count++];

    *face = (struct model_face){.first = (uint32_t)model->corner_count, .count = 4, .colour = colour};
    for (int i = 0; i < 4; i++) {
        const int k = sign > 0 ? i : 3 - i;
        double p[3];
        p[axis] = at;
        p[(axis + 1) % 3] = a[k == 1 || k == 2];
        p[(axis + 2) % 3] = b[k >= 2];
        turned(scene, p, model->points[model->point_count]);
        model->corners[model->corner_count++] = (uint32_t)model->point_count++;
    }
}

void room_scene_box(struct room_scene *scene, const double low[3], const double high[3], uint32_t colour)
{
    for (int axis = 0; axis < 3; axis++) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double a[2] = {low[u], high[u]}, b[2] = {low[v], high[v]};
        room_scene_quad(scene, axis, low[axis], -1, a, b, colour);
        room_scene_quad(scene, axis, high[axis], 1, a, b, colour);
    }
}

/* A part of a wall: t along the wall, y upwards. */
static void wall_part(struct room_scene *scene, int axis, double at, int sign, const double t[2], double y0, double y1,
                      uint32_t colour)
{
    const double y[2] = {y0, y1};

    if (axis == 0)
        room_scene_quad(scene, 0, at, sign, y, t, colour);
    else
        room_scene_quad(scene, 2, at, sign, t, y, colour);
}

void room_scene_wall(struct room_scene *scene, int axis, double at, int sign, const double t[2], const double *door,
                     uint32_t colour)
{
    if (!door) {
        wall_part(scene, axis, at, sign, t, 0, HEIGHT_M, colour);
        return;
    }
    const double before[2] = {t[0], door[0]}, behind[2] = {door[1], t[1]};
    wall_part(scene, axis, at, sign, before, 0, HEIGHT_M, colour);
    wall_part(scene, axis, at, sign, behind, 0, HEIGHT_M, colour);
    wall_part(scene, axis, at, sign, door, DOOR_HEIGHT_M, HEIGHT_M, colour);
}

void room_scene_floor(struct room_scene *scene, const double x[2], const double z[2], double height_m, uint32_t colour)
{
    room_scene_quad(scene, 1, 0, 1, z, x, colour);
    room_scene_quad(scene, 1, height_m, -1, z, x, colour ^ 0x202020);
}

/* Random buildings --------------------------------------------------------------------------- */

static uint32_t random_colour(struct random *random)
{
    return (uint32_t)random_u64(random) & 0xFFFFFF;
}

/* The doorway behind the wall of room i, j at its greater end along the axis (0: x, 2: z). */
static void doorway(struct room_scene *scene, struct random *random, int axis, int i, int j, const double door[2])
{
    const double from = (axis ? j : i) * PITCH_M + ROOM_M, across = (axis ? i : j) * PITCH_M;
    const double through[2] = {from, from + PITCH_M - ROOM_M}, side[2] = {across + door[0], across + door[1]};
    const uint32_t colour = random_colour(random);

    room_scene_floor(scene, axis ? side : through, axis ? through : side, DOOR_HEIGHT_M, colour);
    wall_part(scene, 2 - axis, side[0], 1, through, 0, DOOR_HEIGHT_M, colour ^ 0x404040);
    wall_part(scene, 2 - axis, side[1], -1, through, 0, DOOR_HEIGHT_M, colour ^ 0x404040);
}

static void furnish(struct room_scene *scene, struct random *random, double x_m, double z_m)
{
    const int boxes = (int)random_in(random, 0, 4);

    for (int k = 0; k < boxes; k++) {
        double low[3], high[3];
        for (int i = 0; i < 3; i++) {
            low[i] = floor(random_unit(random) * 20) / 10;
            high[i] = low[i] + 0.1 + floor(random_unit(random) * 15) / 10;
        }
        if (random_u64(random) % 3) high[1] -= low[1], low[1] = 0; /* on the floor, or through the ceiling */
        low[0] += x_m, high[0] += x_m, low[2] += z_m, high[2] += z_m;
        room_scene_box(scene, low, high, random_colour(random));
    }
    if (random_u64(random) % 3 == 0) {
        const double y[2] = {0, 1 + 1.5 * random_unit(random)}, z[2] = {z_m, z_m + 1 + 3 * random_unit(random)};
        const double at = x_m + 1 + 2 * random_unit(random);
        const uint64_t sides = random_u64(random) % 3;
        if (sides != 1) room_scene_quad(scene, 0, at, 1, y, z, random_colour(random));
        if (sides != 0) room_scene_quad(scene, 0, at, -1, y, z, random_colour(random));
    }
}

static void random_turn(struct random *random, double m[3][3])
{
    const double yaw = random_u64(random) % 3 ? random_unit(random) * 6.3 : 0;
    const double pitch = random_u64(random) % 2 ? random_unit(random) * 6.3 : 0;
    const double c = cos(yaw), s = sin(yaw), d = cos(pitch), t = sin(pitch);
    const double rows[3][3] = {{c, 0, s}, {t * s, d, -t * c}, {-d * s, t, d * c}};

    memcpy(m, rows, sizeof rows);
}

/* Doors of each room towards greater x and greater z; a negative start: none. */
struct doors {
    double at[SIDE_MAX][SIDE_MAX][2][2];
};

static void room(struct room_scene *scene, struct random *random, const struct doors *doors, int i, int j)
{
    const double x[2] = {i * PITCH_M, i * PITCH_M + ROOM_M}, z[2] = {j * PITCH_M, j * PITCH_M + ROOM_M};
    const double *gates[4] = {i ? doors->at[i - 1][j][0] : NULL, doors->at[i][j][0], j ? doors->at[i][j - 1][1] : NULL,
                              doors->at[i][j][1]};

    room_scene_floor(scene, x, z, HEIGHT_M, random_colour(random));
    for (int k = 0; k < 4; k++) {
        const int axis = k / 2 * 2;
        const double *along = axis ? x : z, *across = axis ? z : x;
        const bool open = gates[k] && gates[k][0] >= 0;
        const double door[2] = {along[0] + (open ? gates[k][0] : 0), along[0] + (open ? gates[k][1] : 0)};
        room_scene_wall(scene, axis, across[k % 2], k % 2 ? -1 : 1, along, open ? door : NULL, random_colour(random));
        if (open && k % 2) doorway(scene, random, axis, i, j, gates[k]);
    }
    furnish(scene, random, x[0], z[0]);
}

void room_scene_random(struct room_scene *scene, struct random *random)
{
    const int columns = (int)random_in(random, 2, SIDE_MAX), rows = (int)random_in(random, 2, SIDE_MAX);
    struct doors doors;

    room_scene_begin(scene);
    random_turn(random, scene->turn);
    for (int i = 0; i < columns; i++)
        for (int j = 0; j < rows; j++)
            for (int k = 0; k < 2; k++) {
                const bool border = k ? j + 1 == rows : i + 1 == columns;
                const double start = floor(random_unit(random) * 30) / 10;
                doors.at[i][j][k][0] = border || random_u64(random) % 4 == 0 ? -1 : start;
                doors.at[i][j][k][1] = start + DOOR_M;
            }
    for (int i = 0; i < columns; i++)
        for (int j = 0; j < rows; j++)
            room(scene, random, &doors, i, j);
    scene->extent_m[0] = columns * PITCH_M;
    scene->extent_m[1] = HEIGHT_M;
    scene->extent_m[2] = rows * PITCH_M;
}

struct viewpoint room_scene_view(const struct room_scene *scene, struct random *random)
{
    struct viewpoint viewpoint = {.line = 1};
    double eye[3], target[3];

    for (int i = 0; i < 3; i++) {
        eye[i] = random_unit(random) * scene->extent_m[i];
        target[i] = random_unit(random) * scene->extent_m[i];
        if (random_u64(random) % 4 == 0) eye[i] = floor(eye[i] * 10) / 10;
    }
    turned(scene, eye, viewpoint.eye_m);
    turned(scene, target, viewpoint.target_m);
    return viewpoint;
}

static bool compile_cleaned(struct mesh *mesh, enum portals_wanted portals, const struct core *core,
                            struct compiled *out, struct error *err)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "auto", .keep_faces = true, .portals = portals, .core = core};
    const bool ok = mesh_insert_t_vertices(mesh, err) && compile_mesh(mesh, &options, out, err);
    mesh_free(mesh);
    return ok;
}

bool room_scene_compile(const struct room_scene *scene, enum portals_wanted portals, const struct core *core,
                        struct compiled *out, struct error *err)
{
    struct mesh mesh;
    return mesh_clean(&scene->model, &mesh, err) && compile_cleaned(&mesh, portals, core, out, err);
}

bool room_scene_compile_long(const struct room_scene *scene, enum portals_wanted portals, const struct core *core,
                             struct compiled *out, struct error *err)
{
    struct grid grid;
    struct mesh mesh;
    return grid_choose_long(&scene->model, &(struct grid_views){0}, &grid, err) &&
           mesh_clean_on(&scene->model, &grid, &mesh, err) && compile_cleaned(&mesh, portals, core, out, err);
}
