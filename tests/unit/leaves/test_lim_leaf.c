/* SPDX-License-Identifier: MIT
 *
 * Mesh leaves in a scene: what a renderer relies on is checked, rule by rule. */
#include "compiler/compile_mesh.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "scene/lim_check.h"

#include <stdlib.h>
#include <string.h>

/* A scene with arrays of its own, that a test breaks. */
struct broken {
    struct lim_scene scene;
    lim_index *words;
    struct lim_node *nodes;
    size_t leaf; /* a node that is a mesh leaf */
};

static struct compiled whole; /* two balls beside a box */

static int setup(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);
    const double left_m[3] = {-3, 0, 0}, right_m[3] = {3, 0, 0}, middle_m[3] = {0, 0, 0}, half_m[3] = {1, 1, 1};
    const struct compile_options options = {
        .tolerance_units = 0.01, .splitter = "weighted-12", .tree = TREE_BSP, .mesh_leaves = MESH_LEAVES_ALL};
    struct error err;
    (void)state;
    mesh_rig_box(&mesh, middle_m, half_m, 0.3, 0.1);
    mesh_rig_ball(&mesh, left_m, 1.0, 8);
    mesh_rig_ball(&mesh, right_m, 1.0, 6);
    const bool ok = compile_mesh(&mesh, &options, &whole, &err);
    mesh_rig_free(&mesh);
    return ok ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    compiled_free(&whole);
    return 0;
}

static bool is_leaf(const struct lim_scene *scene, size_t node)
{
    return scene->nodes[node].split.plane == LIM_NO_INDEX &&
           lim_is_mesh_leaf(&scene->polygons[scene->nodes[node].front_run]);
}

static struct broken broken_begin(void)
{
    struct broken out = {.scene = whole.scene};
    out.words = malloc(out.scene.polygon_words * sizeof *out.words);
    out.nodes = malloc(out.scene.node_count * sizeof *out.nodes);
    assert_true(out.words && out.nodes);
    memcpy(out.words, out.scene.polygons, out.scene.polygon_words * sizeof *out.words);
    memcpy(out.nodes, out.scene.nodes, out.scene.node_count * sizeof *out.nodes);
    out.scene.polygons = out.words;
    out.scene.nodes = out.nodes;
    while (!is_leaf(&out.scene, out.leaf))
        out.leaf++;
    return out;
}

static void broken_refused(struct broken *broken, const char *reason)
{
    struct error err = {""};
    assert_false(lim_check(&broken->scene, &err));
    if (!strstr(err.text, reason)) fail_msg("'%s' lacks '%s'", err.text, reason);
    free(broken->words);
    free(broken->nodes);
}

static lim_index *first_record(struct broken *broken)
{
    return broken->words + broken->nodes[broken->leaf].front_run;
}

static lim_index *second_record(struct broken *broken)
{
    return first_record(broken) + lim_record_words(*first_record(broken));
}

static lim_index *words_of(struct broken *broken)
{
    return broken->words + (lim_mesh_leaf_words(first_record(broken)) - broken->words);
}

static void assert_word_refused(int word, lim_index value, const char *reason)
{
    struct broken broken = broken_begin();
    words_of(&broken)[word] = value;
    broken_refused(&broken, reason);
}

static void a_scene_with_mesh_leaves_is_sound(void **state)
{
    struct error err;
    size_t leaves = 0, vertices = 0;
    (void)state;
    assert_true(lim_check(&whole.scene, &err));
    for (size_t i = 0; i < whole.scene.node_count; i++) {
        if (!is_leaf(&whole.scene, i)) continue;
        const lim_index *words = lim_mesh_leaf_words(&whole.scene.polygons[whole.scene.nodes[i].front_run]);
        leaves++;
        vertices = words[LIM_MESH_LEAF_COUNT] > vertices ? words[LIM_MESH_LEAF_COUNT] : vertices;
        assert_int_not_equal(whole.scene.nodes[i].box, LIM_NO_INDEX);
    }
    assert_int_equal(leaves, 2);
    assert_int_equal(whole.report.mesh_leaves, 2);
    assert_true(whole.scene.limits.leaf_polygons >= 1);
    assert_int_equal(vertices, whole.scene.limits.leaf_vertices);
}

static void what_a_leaf_says_of_itself_is_checked(void **state)
{
    const lim_index vertices = whole.scene.vertex_count;
    struct broken at = broken_begin();
    const lim_index *words = words_of(&at);
    (void)state;
    assert_word_refused(LIM_MESH_LEAF_COUNT, 0, "a mesh leaf of 0 vertices");
    assert_word_refused(LIM_MESH_LEAF_COUNT, vertices + 1, "a mesh leaf of ");
    assert_word_refused(LIM_MESH_LEAF_COUNT, words[LIM_MESH_LEAF_COUNT] - 1, "is none of its mesh leaf");
    assert_word_refused(LIM_MESH_LEAF_FIRST, words[LIM_MESH_LEAF_FIRST] + 1, "mesh leaf");
    assert_word_refused(LIM_MESH_LEAF_FIRST, vertices, "vertices from ");
    assert_word_refused(LIM_MESH_LEAF_FIRST, LIM_NO_INDEX, "vertices from ");
    assert_word_refused(LIM_MESH_LEAF_POLYGONS, 0, "a mesh leaf of 0 polygons");
    assert_word_refused(LIM_MESH_LEAF_POLYGONS, words[LIM_MESH_LEAF_POLYGONS] - 1, "that says it has");
    assert_word_refused(LIM_MESH_LEAF_POLYGONS, 32768, "a mesh leaf of 32768 polygons, 32767 are the most");
    assert_word_refused(LIM_MESH_LEAF_BOX, LIM_NO_INDEX, "whose box is not the node's");
    assert_word_refused(LIM_MESH_LEAF_BOX, words[LIM_MESH_LEAF_BOX] + 1, "whose box is not the node's");
    at.nodes[at.leaf].box = LIM_NO_INDEX;
    broken_refused(&at, "whose box is not the node's");
}

static void flags_in_a_leaf_are_checked(void **state)
{
    const lim_index barred[] = {LIM_POLYGON_PLANE, LIM_POLYGON_BACK, LIM_POLYGON_ALPHA, LIM_POLYGON_EDGES};
    struct broken broken;
    (void)state;
    for (size_t i = 0; i < sizeof barred / sizeof *barred; i++) {
        broken = broken_begin();
        *first_record(&broken) |= barred[i];
        broken_refused(&broken, "in a mesh leaf, with a plane, alpha or flags of edges");
        broken = broken_begin();
        *second_record(&broken) |= barred[i];
        broken_refused(&broken, "in a mesh leaf, with a plane, alpha or flags of edges");
    }
    broken = broken_begin();
    *second_record(&broken) |= LIM_POLYGON_MESH;
    broken_refused(&broken, "of which it is not the first");
    broken = broken_begin();
    *first_record(&broken) &= ~(lim_index)LIM_POLYGON_MESH;
    broken_refused(&broken, "in a leaf, without a plane");
}

static void records_of_nodes_begin_no_mesh_leaf(void **state)
{
    struct broken broken = broken_begin();
    size_t node = 0;
    (void)state;
    while (broken.nodes[node].split.plane == LIM_NO_INDEX || broken.nodes[node].front_run == LIM_NO_INDEX)
        node++;
    broken.words[broken.nodes[node].front_run] |= LIM_POLYGON_MESH;
    broken_refused(&broken, "of which it is not the first");
}

static void limits_of_leaves_are_checked(void **state)
{
    struct broken broken = broken_begin();
    (void)state;
    broken.scene.limits.leaf_vertices--;
    broken_refused(&broken, "vertices, the limit is");
    broken = broken_begin();
    broken.scene.limits.leaf_polygons = 0;
    broken_refused(&broken, "limit of 0 polygons of a mesh leaf, 1 to 32767");
    broken = broken_begin();
    broken.scene.limits.leaf_polygons = 32768;
    broken_refused(&broken, "limit of 32768 polygons of a mesh leaf, 1 to 32767");
}

/* A leaf that is all of a scene has a level; without one it would be a set. */
static void a_set_is_no_mesh_leaf(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);
    const double at_m[3] = {0, 0, 0};
    const struct compile_options options = {
        .tolerance_units = 0.01, .splitter = "weighted-12", .tree = TREE_BSP, .mesh_leaves = MESH_LEAVES_ALL};
    struct compiled ball;
    struct error err;
    (void)state;
    mesh_rig_ball(&mesh, at_m, 1.0, 8);
    assert_true(compile_mesh(&mesh, &options, &ball, &err));
    assert_int_equal(ball.scene.node_count, 1);
    assert_int_equal(ball.scene.limits.depth, 1);
    assert_int_equal(ball.scene.plane_count, 0);
    assert_true(lim_check(&ball.scene, &err));
    ball.scene.limits.depth = 0;
    assert_false(lim_check(&ball.scene, &err));
    assert_non_null(strstr(err.text, "a mesh leaf, and no levels of a tree"));
    compiled_free(&ball);
    mesh_rig_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_scene_with_mesh_leaves_is_sound), cmocka_unit_test(what_a_leaf_says_of_itself_is_checked),
        cmocka_unit_test(flags_in_a_leaf_are_checked),       cmocka_unit_test(records_of_nodes_begin_no_mesh_leaf),
        cmocka_unit_test(limits_of_leaves_are_checked),      cmocka_unit_test(a_set_is_no_mesh_leaf),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
