/* SPDX-License-Identifier: MIT
 *
 * Where the compiler takes dense parts as mesh leaves: only where it may choose, where that is cheaper, where it is as
 * right as promised; and what errs most stays out. */
#include "compiler/mesh_leaf_choice.h"

#include "rigs/cmocka_ready.h"
#include "unit/leaves/choice_rig.h"

#include <math.h>
#include <string.h>

enum { ROUND = 24, BARS = 8, SEGMENTS = 6 };
static const double PI = 3.14159265358979323846;

static void ring_point(int i, int j, const double centre_m[3], double out[3])
{
    const double a = 2 * PI * i / ROUND, b = 2 * PI * j / (ROUND / 2), r = 2.0 / 3 + cos(b) / 3;
    out[0] = centre_m[0] + r * cos(a);
    out[1] = centre_m[1] + sin(b) / 3 * cos(1) - r * sin(a) * sin(1);
    out[2] = centre_m[2] + sin(b) / 3 * sin(1) + r * sin(a) * cos(1);
}

/* A ring round a ball: planes of the one go through the other, and distance orders both. */
static void ring(struct mesh *mesh, double x, double y, double z)
{
    const double centre_m[3] = {x, y, z};
    for (int i = 0; i < ROUND; i++)
        for (int j = 0; j < ROUND / 2; j++) {
            double at[4][3];
            for (int c = 0; c < 4; c++)
                ring_point((i + (c >= 2)) % ROUND, (j + (c == 1 || c == 2)) % (ROUND / 2), centre_m, at[c]);
            const double corners[4][3] = {{at[0][0], at[0][1], at[0][2]},
                                          {at[1][0], at[1][1], at[1][2]},
                                          {at[2][0], at[2][1], at[2][2]},
                                          {at[3][0], at[3][1], at[3][2]}};
            mesh_rig_add(mesh, corners, 4);
        }
    mesh_rig_ball(mesh, centre_m, 0.33, 12);
}

/* A square bar about a centre, turned about y, of many segments: with others through it no distance orders it. */
static void bar(struct mesh *mesh, const double centre_m[3], double turn, double tilt)
{
    static const double side[5][2] = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    for (int i = 0; i < SEGMENTS; i++)
        for (int k = 0; k < 4; k++) {
            double at[4][3];
            for (int c = 0; c < 4; c++) {
                const double along = 2.4 * (i + (c == 1 || c == 2)) / SEGMENTS - 1.2;
                const double u = 0.25 * side[k + (c >= 2)][0], v = 0.25 * side[k + (c >= 2)][1] + along * tilt;
                at[c][0] = centre_m[0] + along * cos(turn) - u * sin(turn);
                at[c][1] = centre_m[1] + v;
                at[c][2] = centre_m[2] + along * sin(turn) + u * cos(turn);
            }
            mesh_rig_triangle(mesh, (const double(*)[3])at, 1, 2);
            mesh_rig_triangle(mesh, (const double(*)[3])at, 2, 3);
        }
}

static void bars(struct mesh *mesh, double x, double y, double z)
{
    const double centre_m[3] = {x, y, z};
    for (int i = 0; i < BARS; i++)
        bar(mesh, centre_m, PI * i / BARS, 0.3 * (i % 3 - 1));
}

static struct mesh with_a_floor(void)
{
    struct mesh mesh = mesh_rig(3000.0);
    const double centre_m[3] = {0, -1.5, 0}, half_m[3] = {6, 0.1, 4};
    mesh_rig_box(&mesh, centre_m, half_m, 0.0, 0.0);
    return mesh;
}

/* What is chosen for the mesh. */
static struct compiled settled_of(const struct mesh *mesh, const struct compile_options *options)
{
    struct compiled scene = choice_rig_compile(mesh, options);
    struct reference reference = {0};
    struct leaf_trial trial;
    struct error err;
    if (leaf_trial_begin(&trial, mesh, options, &scene)) {
        reference = choice_rig_reference(mesh);
        if (!leaf_trial_settle(&trial, &reference, NULL, &scene, &err)) fail_msg("%s", err.text);
    }
    reference_free(&reference);
    leaf_trial_free(&trial);
    return scene;
}

static void dense_parts_that_trees_split_become_leaves(void **state)
{
    struct mesh mesh = with_a_floor();
    const struct compile_options options = choice_rig_options();
    (void)state;
    ring(&mesh, -3, 0, 0);
    ring(&mesh, 3, 0, 0);
    struct compiled scene = settled_of(&mesh, &options);
    const struct leaf_report *leaves = &scene.report.leaf_parts;
    assert_int_equal(scene.report.mesh_leaves, 2);
    assert_int_equal(leaves->count, 2);
    assert_true(leaves->tried && leaves->attempts == 1);
    assert_int_equal(leaves->polygons, mesh.polygon_count - 6);
    assert_true(leaves->instructions < leaves->without_instructions);
    assert_true(leaves->instructions == scene.report.instructions);
    assert_true(leaves->wrong_percent <= leaves->bound_percent);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void what_errs_most_stays_out(void **state)
{
    struct mesh mesh = with_a_floor();
    const struct compile_options options = choice_rig_options();
    (void)state;
    ring(&mesh, -4, 0, 0);
    const size_t first = mesh.polygon_count;
    bars(&mesh, 0, 0, 0);
    const size_t end = mesh.polygon_count;
    ring(&mesh, 4, 0, 0);
    struct compiled scene = settled_of(&mesh, &options);
    const struct leaf_report *leaves = &scene.report.leaf_parts;
    assert_int_equal(leaves->attempts, 2);
    assert_int_equal(leaves->count, 2);
    for (size_t i = 0; i < leaves->count; i++)
        assert_true(leaves->parts[i].face <= first || leaves->parts[i].face > end);
    assert_true(leaves->wrong_percent <= leaves->bound_percent);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* Nothing is left of it, and the scene is as it was. */
static void where_all_err_there_are_none(void **state)
{
    struct mesh mesh = with_a_floor();
    const struct compile_options options = choice_rig_options();
    (void)state;
    bars(&mesh, 0, 0, 0);
    struct compiled plain = choice_rig_compile(&mesh, &options), scene = settled_of(&mesh, &options);
    const struct leaf_report *leaves = &scene.report.leaf_parts;
    assert_true(leaves->tried && leaves->count == 0);
    assert_true(leaves->wrong_percent > leaves->bound_percent);
    assert_int_equal(scene.report.mesh_leaves, 0);
    assert_int_equal(scene.image_b, plain.image_b);
    assert_memory_equal(scene.image, plain.image, plain.image_b);
    compiled_free(&plain);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static bool is_tried(const struct mesh *mesh, const struct compile_options *options)
{
    struct compiled scene = choice_rig_compile(mesh, options);
    struct leaf_trial trial;
    const bool wants_reference = leaf_trial_begin(&trial, mesh, options, &scene);
    const bool tried = scene.report.leaf_parts.tried;
    leaf_trial_free(&trial);
    compiled_free(&scene);
    assert_true(tried || !wants_reference);
    return tried;
}

static void what_is_said_or_must_be_exact_is_not_tried(void **state)
{
    struct mesh mesh = with_a_floor();
    struct compile_options options = choice_rig_options();
    (void)state;
    ring(&mesh, 0, 0, 0);
    choice_rig_assert_open(&mesh, is_tried);
    options.mesh_leaves = MESH_LEAVES_NONE;
    assert_false(is_tried(&mesh, &options));
    options.mesh_leaves = MESH_LEAVES_ALL;
    assert_false(is_tried(&mesh, &options));
    options = choice_rig_options();
    options.method = method_parse("nearest", NULL);
    options.leaves_open = true; /* the compiler named it */
    assert_true(is_tried(&mesh, &options));
    mesh_rig_free(&mesh);
}

/* Boxes alone have nothing that is dense. */
static void where_nothing_is_dense_nothing_is_tried(void **state)
{
    struct mesh mesh = with_a_floor();
    const struct compile_options options = choice_rig_options();
    (void)state;
    assert_false(is_tried(&mesh, &options));
    mesh_rig_free(&mesh);
}

/* What moves is one leaf or none. */
static void what_moves_is_whole(void **state)
{
    struct mesh mesh = mesh_rig(3000.0);
    struct compile_options options = choice_rig_options();
    (void)state;
    options.method = method_parse("nearest", NULL);
    options.tree = TREE_BSP;
    options.mesh_leaves = MESH_LEAVES_ALL;
    options.whole_leaf = true;
    ring(&mesh, -3, 0, 0);
    ring(&mesh, 3, 0, 0);
    struct compiled scene = choice_rig_compile(&mesh, &options);
    assert_int_equal(scene.scene.node_count, 1);
    assert_int_equal(scene.report.mesh_leaves, 1);
    const lim_index *words = lim_mesh_leaf_words(&scene.scene.polygons[scene.scene.nodes[0].front_run]);
    assert_int_equal(words[LIM_MESH_LEAF_POLYGONS], mesh.polygon_count);
    compiled_free(&scene);
    const double centre_m[3] = {0, 0, 0}, half_m[3] = {1, 0.5, 0.5};
    mesh_rig_box(&mesh, centre_m, half_m, 0.0, 0.0);
    scene = choice_rig_compile(&mesh, &options);
    assert_int_equal(scene.report.mesh_leaves, 0);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dense_parts_that_trees_split_become_leaves),
        cmocka_unit_test(what_errs_most_stays_out),
        cmocka_unit_test(where_all_err_there_are_none),
        cmocka_unit_test(what_is_said_or_must_be_exact_is_not_tried),
        cmocka_unit_test(where_nothing_is_dense_nothing_is_tried),
        cmocka_unit_test(what_moves_is_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
