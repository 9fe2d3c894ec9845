/* SPDX-License-Identifier: MIT
 *
 * Trees with leaves, and meshes, know their free space as well as the BSP tree does, and so want as much memory. */
#include "cameras/free_space.h"
#include "cameras/sample.h"
#include "compiler/compile.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "scene/mcu_mem.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

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

/* Yards under the sky, here and there, on several heights: a floor and walls around six corners, all to be seen from
 * within. Faces run counter-clockwise for who looks at their fronts. */
enum { YARDS = 5, CORNERS = 6, TALL_M = 9 };
static const struct yard {
    double at[2], floor, angle;
} yards[YARDS] = {
    {{0, 0}, 0, 0.1}, {{60, 5}, 1, 0.8}, {{-30, 60}, 2, 1.7}, {{50, 60}, 0.5, 2.5}, {{10, -60}, 1.5, 4.0}};

/* From a yard's own metres, and back. */
static void turn(double angle, const double from[2], double to[2])
{
    to[0] = cos(angle) * from[0] - sin(angle) * from[1];
    to[1] = sin(angle) * from[0] + cos(angle) * from[1];
}

static void write_yards(const char *path)
{
    static const double corners[CORNERS][2] = {{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 30}, {0, 30}};
    FILE *file = fopen(path, "w");

    assert_non_null(file);
    for (int i = 0; i < YARDS * 2 * CORNERS; i++) {
        const struct yard *yard = &yards[i / (2 * CORNERS)];
        double at[2];
        turn(yard->angle, corners[i % CORNERS], at);
        fprintf(file, "v %.6f %.6f %.6f\n", yard->at[0] + at[0], yard->floor + i / CORNERS % 2 * TALL_M,
                -(yard->at[1] + at[1]));
    }
    for (int first = 1; first < YARDS * 2 * CORNERS; first += 2 * CORNERS) {
        fprintf(file, "f");
        for (int i = 0; i < CORNERS; i++)
            fprintf(file, " %d", first + (i));
        for (int i = 0; i < CORNERS; i++) {
            const int a = first + i, b = first + (i + 1) % CORNERS;
            fprintf(file, "\nf %d %d %d %d", a + CORNERS, b + CORNERS, b, a);
        }
        fprintf(file, "\n");
    }
    assert_int_equal(fclose(file), 0);
}

static bool is_in_a_yard(const double eye_m[3])
{
    for (int i = 0; i < YARDS; i++) {
        const double from[2] = {eye_m[0] - yards[i].at[0], -eye_m[2] - yards[i].at[1]};
        double at[2];
        turn(-yards[i].angle, from, at);
        if (at[0] > 0 && at[1] > 0 && ((at[0] < 30 && at[1] < 10) || (at[0] < 10 && at[1] < 30))) return true;
    }
    return false;
}

static struct compiled compile_yards(void)
{
    char folder[] = "/tmp/limner_yards_XXXXXX", path[sizeof folder + sizeof "/yards.obj"];

    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/yards.obj", folder);
    write_yards(path);
    const struct compiled scene = compile(path, TREE_BSP);
    remove(path);
    rmdir(folder);
    return scene;
}

/* Who stands in a yard sees its walls from the front; who stands beside all of them sees them from behind. */
static void fronts_are_seen_from_within(void **state)
{
    const double high_m = 3.2, reach_m = 80;
    struct compiled scene = compile_yards();
    struct random random = {3};
    double targets_m[FREE_SPACE_RAYS_MAX][3];
    int within = 0, beside = 0, seen_from_within = 0, seen_from_beside = 0;

    (void)state;
    for (int i = 0; i < FREE_SPACE_RAYS_MAX; i++)
        for (int k = 0; k < 3; k++)
            targets_m[i][k] = k == 1 ? random_unit(&random) * TALL_M : (random_unit(&random) * 2 - 1) * reach_m;
    for (int i = 0; i < POINTS; i++) {
        const double eye_m[3] = {(random_unit(&random) * 2 - 1) * reach_m, high_m,
                                 (random_unit(&random) * 2 - 1) * reach_m};
        const bool sees = free_space_shows_fronts(&scene, eye_m, (const double(*)[3])targets_m, FREE_SPACE_RAYS_MAX);
        const bool is_within = is_in_a_yard(eye_m);
        seen_from_within += sees && is_within;
        within += is_within;
        beside += !is_within;
        seen_from_beside += sees && !is_within;
    }
    assert_true(within > POINTS / 50);
    assert_true(seen_from_within >= within - within / 100); /* a corner behind which others are */
    assert_true(seen_from_beside <= beside / 50);           /* through two walls' backs, or past all of them */
    compiled_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_rooms_leaves_tell_space_from_matter),
        cmocka_unit_test(in_tilted_rooms_they_do_too),
        cmocka_unit_test(around_the_icosahedron_they_do_too),
        cmocka_unit_test(pools_of_rooms_do_not_depend_on_the_tree),
        cmocka_unit_test(fronts_are_seen_from_within),
    };

    return cmocka_run_group_tests_name("free space", tests, NULL, NULL);
}
