/* SPDX-License-Identifier: MIT
 *
 * The gate of scenes at its bounds: each array of a scene is an allocation of its own and of its size, each index in it
 * is tried at the array's last element and one beyond. A gate that looks beyond an array ends under the address
 * sanitizer, where the arrays of one file lie side by side and hide that. */
#include "compiler/compile_mesh.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "scene/lim_check.h"

#include <stdlib.h>
#include <string.h>

static struct compiled sources[2]; /* with planes at nodes, and in leaves */
static struct lim_scene owned[2];  /* the same in arrays of their own */
static struct lim_texture texture = {.levels = 1};

static const void *copy_of(const void *items, size_t count, size_t item_b)
{
    void *copy = malloc(count * item_b);
    assert_true(copy || !count);
    if (count) memcpy(copy, items, count * item_b);
    return copy;
}

static struct lim_scene own_arrays(const struct lim_scene *from)
{
    struct lim_scene to = *from;
    to.vertices = copy_of(from->vertices, from->vertex_count, sizeof *to.vertices);
    to.nodes = copy_of(from->nodes, from->node_count, sizeof *to.nodes);
    to.planes = copy_of(from->planes, from->plane_count, sizeof *to.planes);
    to.exact = copy_of(from->exact, from->exact_count, sizeof *to.exact);
    to.boxes = copy_of(from->boxes, from->box_count, sizeof *to.boxes);
    to.polygons = copy_of(from->polygons, from->polygon_words, sizeof *to.polygons);
    to.mappings = copy_of(from->mappings, from->mapping_count, sizeof *to.mappings);
    return to;
}

static void free_arrays(const struct lim_scene *scene)
{
    const void *const arrays[] = {scene->vertices, scene->nodes,    scene->planes,  scene->exact,
                                  scene->boxes,    scene->polygons, scene->mappings};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        free((void *)(uintptr_t)arrays[i]);
}

/* Of words that the scene may not change, and this test does. */
static lim_index *word(const lim_index *of)
{
    return (lim_index *)(uintptr_t)of;
}

static void assert_refused(const struct lim_scene *scene, const char *reason)
{
    struct error err = {""};
    if (lim_check(scene, &err)) fail_msg("accepted, where it should say '%s'", reason);
    if (!strstr(err.text, reason)) fail_msg("'%s' lacks '%s'", err.text, reason);
}

/* One beyond is refused for its reason; at the last element it is not, though others may be. */
static void try_index(const struct lim_scene *scene, const lim_index *field, lim_index beyond, lim_index step,
                      const char *reason)
{
    struct error err = {""};
    const lim_index was = *field;
    *word(field) = beyond;
    assert_refused(scene, reason);
    *word(field) = beyond - step;
    if (!lim_check(scene, &err) && strstr(err.text, reason)) fail_msg("the last one is refused: %s", err.text);
    *word(field) = was;
    if (!lim_check(scene, &err)) fail_msg("%s", err.text);
}

static const struct lim_node *node_of(const struct lim_scene *scene, bool leaf)
{
    for (size_t i = 0; i < scene->node_count; i++) {
        const struct lim_node *node = &scene->nodes[i];
        const bool slanted = node->split.plane < LIM_PLANE_X && node->front_run != LIM_NO_INDEX;
        if (leaf ? node->split.plane == LIM_NO_INDEX : slanted) return node;
    }
    fail();
    return NULL;
}

static void indices_of_nodes_end_with_their_arrays(void **state)
{
    (void)state;
    const struct lim_scene *scene = &owned[0];
    const struct lim_node *node = node_of(scene, false), *parent = scene->nodes;
    while (parent->front == LIM_NO_INDEX || parent->back == LIM_NO_INDEX)
        parent++;
    try_index(scene, &node->split.plane, scene->plane_count * LIM_PLANE_WORDS, LIM_PLANE_WORDS, "where none of");
    try_index(scene, &parent->front, scene->node_count, 1, "child");
    try_index(scene, &parent->back, scene->node_count, 1, "child");
    try_index(scene, &node->front_run, scene->polygon_words, 1, "behind the last polygon");
    try_index(scene, &node->back_run, scene->polygon_words, 1, "behind the last polygon");
    try_index(scene, &scene->nodes[0].box, scene->box_count, 1, ": box ");
}

static void indices_of_records_end_with_their_arrays(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        const struct lim_scene *scene = &owned[i];
        const lim_index *record = &scene->polygons[node_of(scene, i)->front_run];
        for (lim_index k = 0; k < (*record & LIM_POLYGON_COUNT); k++)
            try_index(scene, record + LIM_POLYGON_HEAD_WORDS + k, scene->vertex_count, 1, ": vertex ");
    }
    const struct lim_scene *leafy = &owned[1];
    lim_index run = node_of(leafy, true)->front_run;
    while (lim_record_plane(&leafy->polygons[run])->plane >= LIM_PLANE_X)
        run += (lim_index)lim_record_words(leafy->polygons[run]);
    const struct lim_plane_ref *ref = lim_record_plane(&leafy->polygons[run]);
    try_index(leafy, &ref->plane, leafy->plane_count * LIM_PLANE_WORDS, LIM_PLANE_WORDS, "where none of");
}

/* The record that lies last in memory. */
static size_t last_record(const struct lim_scene *scene)
{
    size_t last = 0;
    for (size_t at = 0; at < scene->polygon_words; at += lim_record_words(scene->polygons[at]))
        last = at;
    return last;
}

/* With one corner more, or one word less in the scene, it ends a word beyond. */
static void a_record_a_word_beyond_is_refused(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct lim_scene *scene = &owned[i];
        const size_t last = last_record(scene);
        const uint16_t most = scene->limits.vertices;
        scene->limits.vertices = 250;
        ++*word(&scene->polygons[last]);
        assert_refused(scene, "runs over the end");
        --*word(&scene->polygons[last]);
        scene->limits.vertices = most;
        struct lim_scene shorter = *scene;
        shorter.polygon_words--;
        shorter.polygons = copy_of(scene->polygons, shorter.polygon_words, sizeof *shorter.polygons);
        assert_refused(&shorter, "runs over the end");
        free(word(shorter.polygons));
    }
}

/* A textured triangle on a node. */
static struct lim_scene textured(const struct lim_node *node)
{
    static const lim_index words[] = {3 | LIM_POLYGON_TEXTURE | LIM_POLYGON_LAST, 0, 0, 1, 2, 0, 1};
    static const struct lim_vertex vertices[3] = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const struct lim_mapping mappings[2] = {{.scale = LIM_MAPPING_UPRIGHT}, {.scale = LIM_MAPPING_UPRIGHT}};
    const struct lim_scene from = {.vertices = vertices,
                                   .nodes = node,
                                   .polygons = words,
                                   .vertex_count = 3,
                                   .node_count = 1,
                                   .polygon_words = 7,
                                   .polygon_count = 1,
                                   .limits = {.depth = 1, .vertices = 3},
                                   .textures = &texture,
                                   .mappings = mappings,
                                   .texture_count = 1,
                                   .mapping_count = 2,
                                   .palette_colours = 256,
                                   .texel_blocks = 1};
    return own_arrays(&from);
}

static void mappings_and_textures_end_with_their_arrays(void **state)
{
    (void)state;
    const lim_index none = LIM_NO_INDEX;
    const struct lim_node node = {{LIM_PLANE_X, 0}, none, none, 0, none, none};
    const struct lim_scene scene = textured(&node);
    struct error err;
    if (!lim_check(&scene, &err)) fail_msg("%s", err.text);
    try_index(&scene, &scene.polygons[5], scene.texture_count, 1, "texture 1 of 1");
    try_index(&scene, &scene.polygons[6], scene.mapping_count, 1, "mapping 2 of 2");
    free_arrays(&scene);
}

/* Two indices of an exact plane are one; one beyond is none. */
static void exact_planes_end_with_their_array(void **state)
{
    (void)state;
    struct lim_scene scene = owned[0];
    size_t at = scene.plane_count;
    for (size_t i = 0; i < scene.plane_count; i++)
        if (lim_plane_exact(&scene.planes[i]) == scene.exact_count - 1u) at = i;
    assert_true(scene.exact_count > 0 && at < scene.plane_count);
    scene.exact = copy_of(scene.exact, --scene.exact_count, sizeof *scene.exact);
    assert_refused(&scene, ": exact plane ");
    free((void *)(uintptr_t)scene.exact);
}

static int setup(void **state)
{
    (void)state;
    struct random random = {5};
    struct error err;
    const double centre_m[3] = {0.0, 0.0, 0.0}, half_m[3] = {1.0, 2.0, 3.0};
    const struct compile_options clusters = {.tolerance_units = 0.01, .splitter = "weighted-12", .tree = TREE_CLUSTERS};
    struct mesh mesh = mesh_rig(3000.0);
    mesh_rig_box(&mesh, centre_m, half_m, 0.0, 0.0);
    mesh_rig_solids(&mesh, &random, 8);
    sources[0] = mesh_rig_compile(&mesh, "weighted-12", 0.01);
    const bool ok = compile_mesh(&mesh, &clusters, &sources[1], &err);
    mesh_rig_free(&mesh);
    for (int i = 0; i < 2; i++)
        owned[i] = own_arrays(&sources[i].scene);
    return ok ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        free_arrays(&owned[i]);
        compiled_free(&sources[i]);
    }
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(indices_of_nodes_end_with_their_arrays),
        cmocka_unit_test(indices_of_records_end_with_their_arrays),
        cmocka_unit_test(a_record_a_word_beyond_is_refused),
        cmocka_unit_test(mappings_and_textures_end_with_their_arrays),
        cmocka_unit_test(exact_planes_end_with_their_array),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
