/* SPDX-License-Identifier: MIT
 *
 * The eye exactly where no decision is easy: on planes, edges and vertices, and a unit or the least
 * step off them, in front of faces, behind them and inside of solids. */
#include "extreme.h"
#include "rigs/boxes.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

enum { WALLS = 6, FRAMES = 250 };

static const double LEAST_STEP_M = 1.0 / 256;

static const double *corner_of(const struct mesh *mesh, const struct mesh_polygon *polygon, uint32_t k)
{
    return mesh->points[mesh->corners[polygon->first + k % polygon->count]];
}

/* From a random corner of a random solid's face: i/256 along one side and j/256 along the other, which
 * are whole metres, as all corners are multiples of 256. */
static void point_on_plane(const struct mesh *mesh, struct random *random, int64_t i, int64_t j, double out_m[3])
{
    const size_t p = (size_t)random_in(random, WALLS, (int64_t)mesh->polygon_count - 1);
    const struct mesh_polygon *polygon = &mesh->polygons[p];
    const uint32_t k = (uint32_t)random_in(random, 0, polygon->count - 1);
    const double *a = corner_of(mesh, polygon, k + polygon->count - 1), *b = corner_of(mesh, polygon, k);
    const double *c = corner_of(mesh, polygon, k + 1);

    for (int axis = 0; axis < 3; axis++) {
        out_m[axis] = b[axis] + ((double)i * (a[axis] - b[axis]) + (double)j * (c[axis] - b[axis])) / 256;
        if (out_m[axis] > BOXES_END_M) out_m[axis] = BOXES_END_M;
        if (out_m[axis] < -BOXES_END_M) out_m[axis] = -BOXES_END_M;
    }
}

/* Mostly along the plane or at something near by. */
static void look_around(struct extreme *extreme, struct random *random, double eye_m[3], double off_m)
{
    double target_m[3];

    if (off_m > 0) eye_m[random_u64(random) % 3] += random_u64(random) % 2 ? off_m : -off_m;
    do {
        point_on_plane(&extreme->mesh, random, random_in(random, 0, 256), random_in(random, 0, 256), target_m);
    } while (memcmp(target_m, eye_m, sizeof target_m) == 0);
    extreme_frame(extreme, eye_m, target_m);
}

static void look_from_plane(struct extreme *extreme, struct random *random, double off_m)
{
    double eye_m[3];

    point_on_plane(&extreme->mesh, random, random_in(random, -512, 512), random_in(random, -512, 512), eye_m);
    look_around(extreme, random, eye_m, off_m);
}

static void look_from_edge(struct extreme *extreme, struct random *random, double off_m)
{
    double eye_m[3];

    point_on_plane(&extreme->mesh, random, random_in(random, -256, 512), 0, eye_m);
    look_around(extreme, random, eye_m, off_m);
}

static void look_from_vertex(struct extreme *extreme, struct random *random, double off_m)
{
    double eye_m[3];

    point_on_plane(&extreme->mesh, random, 0, 0, eye_m);
    look_around(extreme, random, eye_m, off_m);
}

static void on_plane(struct extreme *extreme, struct random *random)
{
    look_from_plane(extreme, random, 0);
}
static void on_edge(struct extreme *extreme, struct random *random)
{
    look_from_edge(extreme, random, 0);
}
static void on_vertex(struct extreme *extreme, struct random *random)
{
    look_from_vertex(extreme, random, 0);
}

static void off_any(struct extreme *extreme, struct random *random, double off_m)
{
    switch (random_u64(random) % 3) {
    case 0:
        look_from_plane(extreme, random, off_m);
        break;
    case 1:
        look_from_edge(extreme, random, off_m);
        break;
    default:
        look_from_vertex(extreme, random, off_m);
    }
}

static void one_unit_off(struct extreme *extreme, struct random *random)
{
    off_any(extreme, random, 1);
}
static void least_step_off(struct extreme *extreme, struct random *random)
{
    off_any(extreme, random, LEAST_STEP_M);
}

static void run(const char *name, const char *about, void (*look)(struct extreme *extreme, struct random *random))
{
    const struct extreme_plan plan = {name, about, {120, 120, 60, 4}, boxes_add_jumble, look, FRAMES, true};

    extreme_run(&plan);
}

static void eye_exactly_on_a_plane(void **state)
{
    (void)state;
    run("eye-on-plane", "The eye lies exactly in the plane of a face", on_plane);
}

static void eye_exactly_on_an_edge_or_its_line(void **state)
{
    (void)state;
    run("eye-on-edge", "The eye lies exactly on an edge, or on its line", on_edge);
}

static void eye_exactly_on_a_vertex(void **state)
{
    (void)state;
    run("eye-on-vertex", "The eye lies exactly on a vertex", on_vertex);
}

static void eye_one_unit_off(void **state)
{
    (void)state;
    run("eye-1-unit-off", "The eye is one unit of the grid off a plane, an edge or a vertex", one_unit_off);
}

static void eye_the_least_step_off(void **state)
{
    (void)state;
    run("eye-1/256-unit-off", "The eye is 1/256 unit off, the least step that there is", least_step_off);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eye_exactly_on_a_plane),  cmocka_unit_test(eye_exactly_on_an_edge_or_its_line),
        cmocka_unit_test(eye_exactly_on_a_vertex), cmocka_unit_test(eye_one_unit_off),
        cmocka_unit_test(eye_the_least_step_off),
    };

    return cmocka_run_group_tests_name("extremes of the eye", tests, NULL, NULL);
}
