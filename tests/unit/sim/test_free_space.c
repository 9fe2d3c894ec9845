/* SPDX-License-Identifier: MIT
 *
 * Trees with leaves, and meshes, know their free space as well as the BSP tree does, and so want as much memory. */
#include "cameras/free_space.h"
#include "cameras/sample.h"
#include "compiler/compile.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "scene/mcu_mem.h"

enum { EYES = 1000, POINTS = 4000, FEW = POINTS / 500 };

static const enum tree_kind kinds[] = {TREE_CLUSTERS, TREE_AXIS, TREE_OCTREE, TREE_NONE, TREE_MESH};
enum { KINDS = sizeof kinds / sizeof *kinds };

static struct compiled compile(const char *path, enum tree_kind kind)
{
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "weighted-12",
                                            .tree = kind,
                                            .method = kind == TREE_MESH ? method_parse("mesh", NULL) : NULL};
    struct compiled scene;
    struct error err;
    const struct compile_options set = {.tolerance_units = 0.5, .splitter = "auto", .tree = kind};

    if (!compile_model(path, kind == TREE_NONE ? &set : &options, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}

/* Eyes that the sampler draws for one tree, judged by another. */
static int eyes_in_matter(const struct compiled *drawn, const struct compiled *judge)
{
    struct sampler sampler;
    int inside = 0;

    sampler_init(&sampler, drawn);
    for (int i = 0; i < EYES; i++)
        inside += !free_space_holds(judge, sampler_next(&sampler).eye_m);
    return inside;
}

/* Where two trees differ, in the bounds of the scene; `space` counts what the second takes for free. */
static int differences(const struct compiled *a, const struct compiled *b, int *space)
{
    struct sampler sampler;
    struct random random = {7};
    int differ = 0;

    sampler_init(&sampler, a);
    *space = 0;
    for (int i = 0; i < POINTS; i++) {
        double at_m[3];
        for (int k = 0; k < 3; k++)
            at_m[k] = sampler.low_m[k] + random_unit(&random) * (sampler.high_m[k] - sampler.low_m[k]);
        const bool second = free_space_holds(b, at_m);
        differ += free_space_holds(a, at_m) != second;
        *space += second;
    }
    return differ;
}

/* A point within the tolerance of a face may be on either side. */
static void agree(const char *path)
{
    struct compiled bsp = compile(path, TREE_BSP);

    for (int i = 0; i < KINDS; i++) {
        struct compiled tree = compile(path, kinds[i]);
        int space;
        assert_in_range(differences(&bsp, &tree, &space), 0, FEW);
        assert_in_range(space, POINTS / 20, POINTS - POINTS / 20); /* there is matter, and there is space */
        assert_in_range(eyes_in_matter(&tree, &bsp), 0, EYES / 500);
        compiled_free(&tree);
    }
    compiled_free(&bsp);
}

static void in_rooms_leaves_tell_space_from_matter(void **state)
{
    (void)state;
    agree("sim/scenes/rooms.obj");
}

static void in_tilted_rooms_they_do_too(void **state)
{
    (void)state;
    agree("sim/scenes/rooms-tilted.obj");
}

static void around_the_icosahedron_they_do_too(void **state)
{
    (void)state;
    agree("sim/scenes/icosahedron.obj");
}

/* Measured from inside walls, they would be three times as large. */
static void pools_of_rooms_do_not_depend_on_the_tree(void **state)
{
    struct compiled bsp = compile("sim/scenes/rooms.obj", TREE_BSP);

    (void)state;
    for (int i = 0; i < KINDS; i++) {
        if (kinds[i] == TREE_NONE || kinds[i] == TREE_MESH) continue; /* their methods want memory of other kinds */
        struct compiled tree = compile("sim/scenes/rooms.obj", kinds[i]);
        assert_true(mcu_mem_b(&tree) * 4 <= mcu_mem_b(&bsp) * 5);
        compiled_free(&tree);
    }
    compiled_free(&bsp);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_rooms_leaves_tell_space_from_matter),
        cmocka_unit_test(in_tilted_rooms_they_do_too),
        cmocka_unit_test(around_the_icosahedron_they_do_too),
        cmocka_unit_test(pools_of_rooms_do_not_depend_on_the_tree),
    };

    return cmocka_run_group_tests_name("free space", tests, NULL, NULL);
}
