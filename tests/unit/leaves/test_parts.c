/* SPDX-License-Identifier: MIT
 *
 * Dense parts of a mesh, and trees that have them as leaves: rooms of walls with up to 20 things in them, at random
 * places and scales, that touch walls and each other, of no thickness, one in another, and across walls' planes. */
#include "trees/parts.h"

#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "scene/lim_check.h"
#include "scene/records.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { THINGS_MAX = 20, TRIES = 24, SHEET_SIDE = 9 };

/* Points in units. The caller frees them. */
static double (*points_of(const struct mesh *mesh))[3]
{
    double(*points)[3] = malloc(mesh->point_count * sizeof *points);
    assert_non_null(points);
    for (size_t i = 0; i < mesh->point_count; i++)
        for (int k = 0; k < 3; k++)
            points[i][k] = mesh->points[i][k] * mesh->grid.units_per_m;
    return points;
}

static struct parts parts_of(const struct mesh *mesh)
{
    double(*points)[3] = points_of(mesh);
    struct parts parts;
    parts_find(mesh, points, &parts);
    free(points);
    return parts;
}

static void ball_at(struct mesh *mesh, double x, double y, double z, double radius_m, unsigned rings)
{
    const double centre_m[3] = {x, y, z};
    mesh_rig_ball(mesh, centre_m, radius_m, rings);
}

static void box_at(struct mesh *mesh, double x, double y, double z, double half_x, double half_y, double half_z)
{
    const double centre_m[3] = {x, y, z}, half_m[3] = {half_x, half_y, half_z};
    mesh_rig_box(mesh, centre_m, half_m, 0.0, 0.0);
}

/* A wavy sheet, seen from both sides. */
static void sheet_at(struct mesh *mesh, double x, double y, double z, double side_m)
{
    for (int i = 0; i < SHEET_SIDE; i++)
        for (int k = 0; k < SHEET_SIDE; k++) {
            double at[4][3];
            for (int c = 0; c < 4; c++) {
                const int u = i + (c == 1 || c == 2), v = k + (c >= 2);
                at[c][0] = x + side_m * u / SHEET_SIDE;
                at[c][1] = y + side_m / 5 * sin(u * 0.9) * cos(v * 0.7);
                at[c][2] = z + side_m * v / SHEET_SIDE;
            }
            const double first[3][3] = {
                {at[0][0], at[0][1], at[0][2]}, {at[1][0], at[1][1], at[1][2]}, {at[2][0], at[2][1], at[2][2]}};
            const double second[3][3] = {
                {at[0][0], at[0][1], at[0][2]}, {at[2][0], at[2][1], at[2][2]}, {at[3][0], at[3][1], at[3][2]}};
            mesh_rig_add(mesh, first, 3)->two_sided = true;
            mesh_rig_add(mesh, second, 3)->two_sided = true;
        }
}

/* Which polygons are dense ----------------------------------------------------------------------- */

static void balls_are_dense_and_boxes_are_not(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);
    (void)state;
    box_at(&mesh, 0, 0, 0, 1, 1, 1);
    const size_t of_box = mesh.polygon_count;
    ball_at(&mesh, 4, 0, 0, 1, 8);
    const size_t before = mesh.polygon_count;
    ball_at(&mesh, 0, 4, 0, 1, 3); /* too few polygons */
    const size_t few = mesh.polygon_count;
    assert_true(few - before < PART_POLYGONS_MIN);
    struct parts parts = parts_of(&mesh);
    assert_int_equal(parts.count, 1);
    assert_int_equal(parts.items[0].polygons, before - of_box);
    assert_int_equal(parts.items[0].face, of_box + 1);
    for (size_t i = 0; i < mesh.polygon_count; i++)
        assert_int_equal(parts.of[i], i >= of_box && i < before);
    assert_int_equal(parts_taken(&parts), 1);
    parts_leave_out(&parts, &mesh, 0);
    assert_int_equal(parts_taken(&parts), 0);
    assert_int_equal(parts.of[of_box], 0);
    parts_free(&parts);
    mesh_rig_free(&mesh);
}

static void glass_is_never_dense(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);
    (void)state;
    ball_at(&mesh, 0, 0, 0, 1, 8);
    for (size_t i = 0; i < mesh.polygon_count; i++)
        mesh.polygons[i].transparency = 100;
    struct parts parts = parts_of(&mesh);
    assert_int_equal(parts.count, 0);
    parts_free(&parts);
    mesh_rig_free(&mesh);
}

/* A polygon as long as half of all is a wall, whatever hangs at it. */
static void a_large_polygon_is_dense_with_nothing(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);
    const double tail[3][3] = {{1, 0, 0}, {9, 1, 0}, {9, 0, 1}};
    (void)state;
    ball_at(&mesh, 0, 0, 0, 1, 8);
    mesh_rig_add(&mesh, tail, 3); /* at one of the ball's points */
    struct parts parts = parts_of(&mesh);
    size_t dense = 0;
    for (size_t i = 0; i < mesh.polygon_count; i++)
        dense += parts.of[i] > 0;
    assert_true(dense == 0 || !parts.of[mesh.polygon_count - 1]);
    parts_free(&parts);
    mesh_rig_free(&mesh);
}

/* What has all others in its box is a room or the ground. */
static void walls_round_others_are_not_dense(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);
    (void)state;
    ball_at(&mesh, 0, 0, 0, 10, 8);
    const size_t room = mesh.polygon_count;
    for (int i = 0; i < 4; i++)
        ball_at(&mesh, 3 * i - 4.5, 0, 0, 1, 8);
    struct parts parts = parts_of(&mesh);
    assert_int_equal(parts.count, 4);
    assert_int_equal(parts.of[0], 0);
    assert_int_equal(parts.of[room], 1);
    parts_free(&parts);
    mesh_rig_free(&mesh);
}

static void parts_of_all_are_united(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);
    (void)state;
    ball_at(&mesh, 0, 0, 0, 1, 8);
    ball_at(&mesh, 5, 0, 0, 1, 8);
    struct parts parts = parts_of(&mesh);
    assert_int_equal(parts.count, 2);
    parts_unite(&parts, &mesh);
    assert_int_equal(parts.count, 1);
    assert_int_equal(parts.items[0].polygons, mesh.polygon_count);
    assert_true(parts.items[0].high[0] > 5500.0 && parts.items[0].low[0] < -500.0);
    for (size_t i = 0; i < mesh.polygon_count; i++)
        assert_int_equal(parts.of[i], 1);
    parts_free(&parts);
    box_at(&mesh, 0, 5, 0, 1, 1, 1);
    parts = parts_of(&mesh);
    parts_unite(&parts, &mesh);
    assert_int_equal(parts.count, 0);
    assert_int_equal(parts.of[0], 0);
    parts_free(&parts);
    mesh_rig_free(&mesh);
}

/* Trees ------------------------------------------------------------------------------------------ */

enum way { APART, TOUCHING, ENCLOSED, SHEETS, ACROSS, WAYS };

static double between(struct random *random, double low, double high)
{
    return low + (high - low) * (double)random_in(random, 0, 4096) / 4096.0;
}

static void add_thing(struct mesh *mesh, struct random *random, enum way way)
{
    const double radius = between(random, 0.2, 0.9), z = between(random, -6, 6);
    const double x = way == ACROSS ? between(random, -0.2, 0.2) : between(random, 1.5, 8), y = between(random, -1, 1);
    const unsigned rings = (unsigned)random_in(random, 6, 9);
    if (way == SHEETS)
        sheet_at(mesh, x, y, z, 2 * radius);
    else if (way == TOUCHING) {
        ball_at(mesh, 0.1 + radius, y, z, radius, 8); /* at the partition */
        ball_at(mesh, 0.1 + 2 * radius + radius / 2, y, z, radius / 2, rings);
    } else
        ball_at(mesh, x, y, z, radius, rings);
    if (way == ENCLOSED) ball_at(mesh, x, y, z, radius / 2, rings);
}

/* A floor, four walls and a partition, which are boxes; and things. */
static struct mesh furnished(struct random *random, enum way way, int things)
{
    struct mesh mesh = mesh_rig(1500.0);
    box_at(&mesh, 0, -2.2, 0, 10, 0.2, 8);
    box_at(&mesh, 0, 0, -8.1, 10, 2, 0.1);
    box_at(&mesh, 0, 0, 8.1, 10, 2, 0.1);
    box_at(&mesh, -10.1, 0, 0, 0.1, 2, 8);
    box_at(&mesh, 10.1, 0, 0, 0.1, 2, 8);
    box_at(&mesh, 0, 0, -5, 0.1, 2, 2);
    box_at(&mesh, 0, 0, 5, 0.1, 2, 2);
    for (int i = 0; i < things; i++)
        add_thing(&mesh, random, way);
    return mesh;
}

/* All faces have records, and only those of dense parts are in mesh leaves. */
static void assert_complete(const struct mesh *mesh, const struct parts *parts, const struct compiled *scene)
{
    const struct lim_scene *s = &scene->scene;
    bool *met = calloc(mesh->polygon_count + 1, sizeof *met);
    uint32_t *numbers = calloc(s->polygon_words, sizeof *numbers);
    assert_true(met && numbers);
    for (size_t word = 0, number = 0; word < s->polygon_words; word += record_at(s, word).words) {
        met[scene->faces[number]] = true;
        numbers[word] = (uint32_t)number++;
    }
    for (size_t i = 0; i < mesh->polygon_count; i++)
        assert_true(met[mesh->polygons[i].face]);
    for (size_t i = 0; i < s->node_count; i++) {
        const lim_index run = s->nodes[i].front_run;
        if (s->nodes[i].split.plane != LIM_NO_INDEX || !lim_is_mesh_leaf(&s->polygons[run])) continue;
        for (size_t word = run;; word += record_at(s, word).words) {
            assert_true(parts->of[scene->faces[numbers[word]] - 1]); /* faces are polygons here */
            if (record_at(s, word).flags & LIM_POLYGON_LAST) break;
        }
    }
    free(met);
    free(numbers);
}

static void assert_tree(const struct mesh *mesh, enum tree_kind kind, const char *splitter, struct compiled *scene)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = splitter, .tree = kind, .mesh_leaves = MESH_LEAVES_ALL};
    struct parts parts = parts_of(mesh);
    struct error err;
    if (!compile_mesh(mesh, &options, scene, &err)) fail_msg("%s", err.text);
    if (!lim_check(&scene->scene, &err)) fail_msg("%s", err.text);
    assert_true(scene->report.worst_violation_units <= 0.5 + 1e-9);
    assert_complete(mesh, &parts, scene);
    assert_int_equal(scene->report.leaf_parts.count, parts.count);
    parts_free(&parts);
}

static void furnished_rooms_have_sound_trees(void **state)
{
    static const enum tree_kind kinds[] = {TREE_BSP, TREE_CLUSTERS, TREE_AXIS, TREE_OCTREE};
    static const char *const heuristics[] = {"weighted-12", "fewest", "balanced", "sampled", "first"};
    struct random random = {31};
    (void)state;
    for (int i = 0; i < TRIES; i++) {
        const enum way way = (enum way)(i % WAYS);
        struct mesh mesh = furnished(&random, way, (int)random_in(&random, 1, i % 3 ? 5 : THINGS_MAX));
        struct compiled scene;
        assert_tree(&mesh, kinds[i % 4], heuristics[i % 5], &scene);
        assert_true(scene.report.mesh_leaves > 0);
        compiled_free(&scene);
        mesh_rig_free(&mesh);
    }
}

/* Nothing of what stands apart is split, and each thing is one leaf. */
static void things_apart_are_whole(void **state)
{
    struct random random = {5};
    struct mesh mesh = furnished(&random, APART, 0);
    struct compiled scene;
    (void)state;
    for (int i = 0; i < 12; i++)
        ball_at(&mesh, 2 + 3 * (i % 3), i % 2 - 0.5, -6 + 3 * (i / 3), 0.7, 6 + (unsigned)i % 3);
    assert_tree(&mesh, TREE_BSP, "weighted-12", &scene);
    assert_int_equal(scene.report.splits, 0);
    assert_int_equal(scene.report.mesh_leaves, 12);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* What stands on a floor, or against a wall, is on one side of it. */
static void things_at_walls_are_whole(void **state)
{
    struct random random = {5};
    struct mesh mesh = furnished(&random, APART, 0);
    struct compiled scene;
    (void)state;
    ball_at(&mesh, 0.1 + 0.5, -1.5, 4, 0.5, 8);
    ball_at(&mesh, 5, -1.4, 8 - 0.6, 0.6, 8);
    assert_tree(&mesh, TREE_BSP, "weighted-12", &scene);
    assert_int_equal(scene.report.splits, 0);
    assert_int_equal(scene.report.mesh_leaves, 2);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* Where the partition's plane goes through them they are cut round, not split. */
static void planes_through_things_give_way(void **state)
{
    struct random random = {5};
    struct mesh mesh = furnished(&random, APART, 0);
    struct compiled scene;
    (void)state;
    ball_at(&mesh, 0.05, 0, 0, 0.9, 8);
    ball_at(&mesh, 0, 1.1, 0.5, 0.3, 8);
    assert_tree(&mesh, TREE_BSP, "weighted-12", &scene);
    assert_true(scene.report.splits < 8);
    assert_in_range(scene.report.mesh_leaves, 1, 2);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void profiles_that_promise_an_order_have_none(void **state)
{
    struct compile_options options = {.mesh_leaves = MESH_LEAVES_ALL};
    (void)state;
    assert_true(compile_options_may_leaf(&options));
    options.core = &core_exact;
    assert_false(compile_options_may_leaf(&options));
    options.core = &core_fine;
    assert_true(compile_options_may_leaf(&options));
    options.wireframe = true;
    assert_false(compile_options_may_leaf(&options));
    options.wireframe = false;
    options.framebuffer = true;
    assert_false(compile_options_may_leaf(&options));
    options.framebuffer = false;
    options.portals = PORTALS_ON;
    assert_false(compile_options_may_leaf(&options));
    options.portals = PORTALS_AUTO;
    options.tree = TREE_NONE;
    assert_false(compile_options_may_leaf(&options));
    options.tree = TREE_MESH;
    assert_false(compile_options_may_leaf(&options));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(balls_are_dense_and_boxes_are_not),
        cmocka_unit_test(glass_is_never_dense),
        cmocka_unit_test(a_large_polygon_is_dense_with_nothing),
        cmocka_unit_test(walls_round_others_are_not_dense),
        cmocka_unit_test(parts_of_all_are_united),
        cmocka_unit_test(furnished_rooms_have_sound_trees),
        cmocka_unit_test(things_apart_are_whole),
        cmocka_unit_test(things_at_walls_are_whole),
        cmocka_unit_test(planes_through_things_give_way),
        cmocka_unit_test(profiles_that_promise_an_order_have_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
