/* SPDX-License-Identifier: MIT
 *
 * The generator behind closed_scene.h. */
#include "closed_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_FACES = 2000, MAX_SIDES = 8 };

static void add_face(struct model *model, const uint32_t *corners, uint32_t count)
{
    struct model_face *face = &model->faces[model->face_count++];

    memset(face, 0, sizeof *face);
    face->first = (uint32_t)model->corner_count;
    face->count = count;
    face->colour = (uint32_t)model->face_count * 2654435761u & 0xFFFFFFu;
    for (uint32_t i = 0; i < count; i++)
        model->corners[model->corner_count++] = corners[i];
}

static uint32_t add_point(struct model *model, double x, double y, double z)
{
    double *p = model->points[model->point_count];

    p[0] = x;
    p[1] = y;
    p[2] = z;
    return (uint32_t)model->point_count++;
}

/* A rectangle of the wall axis = side * half, between fractions of its extent, facing inwards. */
static void add_tile(struct closed_scene *scene, int axis, int side, const double u[2], const double v[2])
{
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    uint32_t corners[4];

    for (int i = 0; i < 4; i++) {
        const int at = side > 0 ? 3 - i : i; /* counter-clockwise seen from inside */
        double p[3];
        p[axis] = side * scene->half_m[axis];
        p[a] = scene->half_m[a] * u[at == 1 || at == 2];
        p[b] = scene->half_m[b] * v[at >= 2];
        corners[i] = add_point(&scene->model, p[0], p[1], p[2]);
    }
    add_face(&scene->model, corners, 4);
}

/* Rows of tiles whose joints do not line up from row to row. */
static void add_wall(struct closed_scene *scene, int axis, int side, struct random *random)
{
    const int rows = (int)random_in(random, 1, 3);

    for (int row = 0; row < rows; row++) {
        const double v[2] = {-1 + 2.0 * row / rows, -1 + 2.0 * (row + 1) / rows};
        const int tiles = (int)random_in(random, 1, 4);
        double from = -1;
        for (int tile = 0; tile < tiles; tile++) {
            const double to = tile + 1 == tiles ? 1 : from + (1 - from) * (0.2 + 0.6 * random_unit(random));
            const double u[2] = {from, to};
            add_tile(scene, axis, side, u, v);
            from = to;
        }
    }
}

/* A rotation as a unit quaternion, at random or none. */
static void random_turn(struct random *random, double m[3][3])
{
    double q[4], length = 0;

    for (int i = 0; i < 4; i++)
        q[i] = 2 * random_unit(random) - 1;
    if (random_u64(random) % 4 == 0) q[1] = q[2] = q[3] = 0, q[0] = 1;
    if (random_u64(random) % 4 == 0) q[1] = q[3] = 0; /* upright */
    for (int i = 0; i < 4; i++)
        length += q[i] * q[i];
    for (int i = 0; i < 4; i++)
        q[i] /= sqrt(length);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                               {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                               {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    memcpy(m, rows, sizeof rows);
}

/* A prism or a cut cone of 3 to 8 sides, from splinter to wardrobe. */
static void add_solid(struct closed_scene *scene, struct random *random)
{
    const uint32_t sides = (uint32_t)random_in(random, 3, MAX_SIDES);
    const double radius = 0.02 + random_unit(random), height = 0.02 + 1.5 * random_unit(random);
    const double taper = random_u64(random) % 2 ? 1 : 0.3 + 0.6 * random_unit(random);
    double m[3][3], centre[3];
    uint32_t bottom[MAX_SIDES], top[MAX_SIDES], ring[MAX_SIDES];

    random_turn(random, m);
    for (int i = 0; i < 3; i++)
        centre[i] = (2 * random_unit(random) - 1) * scene->half_m[i];
    for (uint32_t end = 0; end < 2; end++) {
        for (uint32_t k = 0; k < sides; k++) {
            const double angle = 2 * 3.14159265358979 * k / sides, r = end ? radius * taper : radius;
            const double local[3] = {r * cos(angle), end ? height / 2 : -height / 2, -r * sin(angle)};
            double p[3];
            for (int i = 0; i < 3; i++)
                p[i] = centre[i] + m[i][0] * local[0] + m[i][1] * local[1] + m[i][2] * local[2];
            (end ? top : bottom)[k] = add_point(&scene->model, p[0], p[1], p[2]);
        }
    }
    scene->first_face[scene->solids++] = scene->model.face_count;
    add_face(&scene->model, top, sides);
    for (uint32_t k = 0; k < sides; k++)
        ring[k] = bottom[sides - 1 - k];
    add_face(&scene->model, ring, sides);
    for (uint32_t k = 0; k < sides; k++) {
        const uint32_t next = (k + 1) % sides;
        const uint32_t side[4] = {bottom[k], bottom[next], top[next], top[k]};
        add_face(&scene->model, side, 4);
    }
}

void closed_scene_make(struct closed_scene *scene, struct random *random)
{
    memset(scene, 0, sizeof *scene);
    scene->model.points = calloc(MAX_FACES * 4, sizeof *scene->model.points);
    scene->model.corners = calloc(MAX_FACES * MAX_SIDES, sizeof *scene->model.corners);
    scene->model.faces = calloc(MAX_FACES, sizeof *scene->model.faces);
    for (int i = 0; i < 3; i++)
        scene->half_m[i] = 1.5 + 6 * random_unit(random);
    for (int axis = 0; axis < 3; axis++) {
        add_wall(scene, axis, -1, random);
        add_wall(scene, axis, 1, random);
    }
    const size_t solids = (size_t)random_in(random, 0, CLOSED_MAX_SOLIDS);
    for (size_t i = 0; i < solids; i++)
        add_solid(scene, random);
    scene->first_face[scene->solids] = scene->model.face_count;
}

void closed_scene_free(struct closed_scene *scene)
{
    free(scene->model.points);
    free(scene->model.corners);
    free(scene->model.faces);
}

/* Signed distance of a point from a face's plane. */
static double distance_m(const struct model *model, size_t face, const double p[3])
{
    const uint32_t *corners = &model->corners[model->faces[face].first];
    const double *a = model->points[corners[0]], *b = model->points[corners[1]], *c = model->points[corners[2]];
    double n[3], sum = 0, length = 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
        length += n[i] * n[i];
    }
    for (int i = 0; i < 3; i++)
        sum += n[i] * (p[i] - a[i]);
    return sum / sqrt(length);
}

/* Outside of every solid by a margin: the camera keeps its near plane clear of all surfaces. */
static bool is_free(const struct closed_scene *scene, const double p[3], double margin_m)
{
    for (int i = 0; i < 3; i++) {
        if (fabs(p[i]) > scene->half_m[i] - margin_m) return false;
    }
    for (size_t s = 0; s < scene->solids; s++) {
        bool outside = false;
        for (size_t f = scene->first_face[s]; f < scene->first_face[s + 1] && !outside; f++)
            outside = distance_m(&scene->model, f, p) > margin_m;
        if (!outside) return false;
    }
    return true;
}

/* Moves the eye along the vertical onto the plane of a random face, give or take a hair. */
static void graze(const struct closed_scene *scene, struct random *random, double eye[3])
{
    const size_t face = (size_t)random_in(random, 0, (int64_t)scene->model.face_count - 1);
    const double raised[3] = {eye[0], eye[1] + 1, eye[2]};
    const double here = distance_m(&scene->model, face, eye);
    const double slope = distance_m(&scene->model, face, raised) - here;

    if (fabs(slope) < 0.01) return;
    eye[1] -= here / slope;
    if (random_u64(random) % 2) eye[1] += (random_unit(random) - 0.5) * 0.002;
}

struct viewpoint closed_scene_viewpoint(const struct closed_scene *scene, struct random *random)
{
    struct viewpoint viewpoint = {.line = 1};
    double *eye = viewpoint.eye_m;

    do {
        for (int i = 0; i < 3; i++)
            eye[i] = (2 * random_unit(random) - 1) * scene->half_m[i];
        if (random_u64(random) % 2) graze(scene, random, eye);
    } while (!is_free(scene, eye, 0.12));
    for (int i = 0; i < 3; i++)
        viewpoint.target_m[i] = (2 * random_unit(random) - 1) * scene->half_m[i];
    return viewpoint;
}
