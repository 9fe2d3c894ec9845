/* SPDX-License-Identifier: MIT
 *
 * Cameras that look along faces: of a slab, where every eye must be and what it must look at can be told by hand. */
#include "cameras/free_space.h"
#include "cameras/grazing.h"
#include "compiler/compile.h"
#include "rigs/cmocka_ready.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EYES = 2000 };
static const double SIDE_M = 8.0, THICK_M = 0.1, NEAR_M = 0.02, ROUNDING_M = 1e-9;

/* Width of a square side: how far two corners are from the diagonal through the others. */
static double side_width_m(void)
{
    return SIDE_M * sqrt(0.5);
}

static struct compiled slab(void)
{
    static const char faces[] = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
    static const char path[] = "limner-test-grazing.obj";
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .tree = TREE_BSP};
    struct compiled scene;
    struct error err;
    FILE *file = fopen(path, "w");

    assert_non_null(file);
    for (int i = 0; i < 8; i++)
        fprintf(file, "v %g %g %g\n", i & 1 ? SIDE_M : 0, i & 4 ? THICK_M : 0, i & 2 ? SIDE_M : 0);
    fputs(faces, file);
    fclose(file);
    const bool ok = compile_model(path, &options, &scene, &err);
    remove(path);
    if (!ok) fail_msg("%s", err.text);
    return scene;
}

static struct sampler sampler_of(const struct compiled *scene, uint32_t seed)
{
    struct sampler sampler;

    sampler_init(&sampler, scene);
    sampler_seed(&sampler, seed);
    sampler.near_m = NEAR_M;
    return sampler;
}

/* Above the upper side or below the lower one; less than 0: beside the slab. */
static double height_m(const double at_m[3])
{
    return fmax(at_m[1] - THICK_M, -at_m[1]);
}

static bool is_within_m(double value, double low, double high)
{
    return value >= low - ROUNDING_M && value <= high + ROUNDING_M;
}

/* Of the slab's two large sides: where the eye is, and that it looks between level and a point of that side. */
static void check_view(const struct viewpoint *view)
{
    const double height = height_m(view->eye_m), target = height_m(view->target_m);

    assert_true(is_within_m(height, 0.02 * side_width_m(), 0.5 * side_width_m()));
    assert_true(is_within_m(target, 0.0, height));
    assert_true((view->eye_m[1] > THICK_M) == (view->target_m[1] >= THICK_M - ROUNDING_M));
    assert_true(is_within_m(view->target_m[0], 0, SIDE_M) && is_within_m(view->target_m[2], 0, SIDE_M));
}

static int compare_heights(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

static void eyes_stand_a_little_over_faces_and_look_along_them(void **state)
{
    struct compiled scene = slab();
    struct sampler sampler = sampler_of(&scene, 1);
    static double heights_m[EYES];
    size_t over = 0, beside = 0;

    (void)state;
    for (int i = 0; i < EYES; i++) {
        struct viewpoint view;
        assert_true(sampler_grazing(&sampler, &view));
        assert_true(free_space_holds(&scene, view.eye_m));
        if (height_m(view.eye_m) < 0.02 * side_width_m() - ROUNDING_M)
            continue; /* along an edge: a fortieth of the area */
        check_view(&view);
        beside += view.eye_m[0] < 0 || view.eye_m[0] > SIDE_M || view.eye_m[2] < 0 || view.eye_m[2] > SIDE_M;
        heights_m[over++] = height_m(view.eye_m);
    }
    assert_in_range(over, EYES * 0.95, EYES * 0.995);
    assert_in_range(beside, over / 5, over / 2);
    qsort(heights_m, over, sizeof *heights_m, compare_heights);
    const double quarter = log(heights_m[over / 4] / (0.02 * side_width_m())) / log(25.0);
    const double half = log(heights_m[over / 2] / (0.02 * side_width_m())) / log(25.0);
    assert_true(quarter > 0.2 && quarter < 0.3 && half > 0.45 && half < 0.55); /* even by the logarithm */
    compiled_free(&scene);
}

static void no_eye_is_nearer_than_twice_the_near_plane(void **state)
{
    struct compiled scene = slab();
    struct sampler sampler = sampler_of(&scene, 2);
    struct viewpoint view;
    double lowest = SIDE_M;

    (void)state;
    sampler.near_m = 0.5;
    for (int i = 0; i < EYES; i++) {
        assert_true(sampler_grazing(&sampler, &view));
        if (height_m(view.eye_m) > 0 && is_within_m(view.eye_m[0], 0, SIDE_M) && is_within_m(view.eye_m[2], 0, SIDE_M))
            lowest = fmin(lowest, height_m(view.eye_m));
    }
    assert_true(lowest >= 1.0 - ROUNDING_M && lowest < 1.05);
    compiled_free(&scene);
}

static void a_seed_gives_the_same_eyes_and_another_gives_others(void **state)
{
    struct compiled scene = slab();
    struct sampler first = sampler_of(&scene, 3), again = sampler_of(&scene, 3), other = sampler_of(&scene, 4);
    struct viewpoint a, b, c;

    (void)state;
    for (int i = 0; i < 50; i++) {
        assert_true(sampler_grazing(&first, &a) && sampler_grazing(&again, &b) && sampler_grazing(&other, &c));
        assert_memory_equal(a.eye_m, b.eye_m, sizeof a.eye_m);
        assert_memory_equal(a.target_m, b.target_m, sizeof a.target_m);
        assert_true(memcmp(a.eye_m, c.eye_m, sizeof a.eye_m) != 0);
    }
    compiled_free(&scene);
}

static void a_scene_whose_model_is_not_known_has_none(void **state)
{
    struct compiled scene = slab(), bare = scene;
    struct viewpoint view;

    (void)state;
    bare.original = NULL;
    struct sampler sampler = sampler_of(&bare, 5);
    assert_false(sampler_grazing(&sampler, &view));
    compiled_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eyes_stand_a_little_over_faces_and_look_along_them),
        cmocka_unit_test(no_eye_is_nearer_than_twice_the_near_plane),
        cmocka_unit_test(a_seed_gives_the_same_eyes_and_another_gives_others),
        cmocka_unit_test(a_scene_whose_model_is_not_known_has_none),
    };
    return cmocka_run_group_tests_name("grazing", tests, NULL, NULL);
}
