/* SPDX-License-Identifier: MIT
 *
 * Parts of a model that are dear leaves where the eye is near them: the walls of a building of many rooms, of which an
 * eye in a room sees a few and a leaf takes all. What stands outside, and is looked at as a whole, stays. */
#include "compiler/leaf_places.h"

#include "compiler/compile_mesh.h"
#include "rigs/cmocka_ready.h"
#include "unit/leaves/choice_rig.h"

enum { ROOMS = 8, STOREY_M = 3 };
static const double ROOM_M = 4.0;

static void upright(struct mesh *mesh, const double from[2], const double to[2], double low, double high)
{
    const double corners[4][3] = {
        {from[0], low, from[1]}, {to[0], low, to[1]}, {to[0], high, to[1]}, {from[0], high, from[1]}};
    const double back[4][3] = {
        {to[0], low, to[1]}, {from[0], low, from[1]}, {from[0], high, from[1]}, {to[0], high, to[1]}};
    mesh_rig_add(mesh, corners, 4);
    mesh_rig_add(mesh, back, 4);
}

/* Between two rooms, with a doorway in its middle. */
static void wall(struct mesh *mesh, double x, double z, double dx, double dz)
{
    const double ends[4][2] = {{x, z}, {x + 0.4 * dx, z + 0.4 * dz}, {x + 0.6 * dx, z + 0.6 * dz}, {x + dx, z + dz}};
    upright(mesh, ends[0], ends[1], 0, 2);
    upright(mesh, ends[2], ends[3], 0, 2);
    for (int i = 0; i < 3; i++)
        upright(mesh, ends[i], ends[i + 1], 2, STOREY_M);
}

/* Over a room, and roof above it. */
static void ceiling(struct mesh *mesh, double x, double z)
{
    const double high = STOREY_M, x1 = x + ROOM_M, z1 = z + ROOM_M;
    const double below[4][3] = {{x, high, z}, {x1, high, z}, {x1, high, z1}, {x, high, z1}};
    const double above[4][3] = {{x, high, z1}, {x1, high, z1}, {x1, high, z}, {x, high, z}};
    mesh_rig_add(mesh, below, 4);
    mesh_rig_add(mesh, above, 4);
}

static void building(struct mesh *mesh)
{
    for (int i = 0; i < ROOMS * ROOMS; i++)
        ceiling(mesh, ROOM_M * (i % ROOMS), ROOM_M * (i / ROOMS));
    for (int i = 0; i <= ROOMS; i++)
        for (int k = 0; k < ROOMS; k++) {
            wall(mesh, ROOM_M * i, ROOM_M * k, 0, ROOM_M);
            wall(mesh, ROOM_M * k, ROOM_M * i, ROOM_M, 0);
        }
}

/* The building, and a ball that the eye sees half of, wherever it is; on a ground far larger than both. */
static struct mesh with_a_building(void)
{
    struct mesh mesh = mesh_rig(300.0);
    const double ground_m[3] = {16, -0.6, 16}, half_m[3] = {80, 0.5, 80}, ball_m[3] = {-30, 4, -30};
    mesh_rig_box(&mesh, ground_m, half_m, 0.0, 0.0);
    building(&mesh);
    mesh_rig_ball(&mesh, ball_m, 3.0, 12);
    return mesh;
}

static void walls_of_many_rooms_are_left_to_the_tree(void **state)
{
    struct mesh mesh = with_a_building();
    struct compile_options options = choice_rig_options();
    struct compilation work;
    struct compiled with;
    struct error err;
    (void)state;
    options.splitter = "fewest";
    options.mesh_leaves = MESH_LEAVES_NONE;
    struct compiled without = choice_rig_compile(&mesh, &options);
    options.mesh_leaves = MESH_LEAVES_ALL;
    assert_true(compilation_begin(&work, &mesh, &options, &err));
    assert_int_equal(work.parts.count, 2);
    const size_t walls = work.parts.items[0].polygons > work.parts.items[1].polygons ? 0 : 1;
    assert_true(compilation_tree(&work, TREE_BSP, &with, &err));
    assert_int_equal(leaf_places_leave_out(&without, &with, options.core, &mesh, &work.parts), 1);
    assert_int_equal(work.parts.items[walls].polygons, 0);
    assert_true(work.parts.items[1 - walls].polygons > 0);
    assert_int_equal(leaf_places_leave_out(&with, &with, options.core, &mesh, &work.parts), 0);
    compiled_free(&with);
    compilation_end(&work);
    compiled_free(&without);
    mesh_rig_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(walls_of_many_rooms_are_left_to_the_tree)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
