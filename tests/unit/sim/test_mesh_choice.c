/* SPDX-License-Identifier: MIT
 *
 * Where the compiler draws a model as a mesh: only where it may choose, where that is cheaper, and where it is as right
 * as promised. */
#include "accuracy/promise.h"
#include "compiler/mesh_choice.h"

#include "core/core.h"
#include "rigs/cmocka_ready.h"
#include "unit/leaves/choice_rig.h"

#include <math.h>
#include <string.h>

enum { RINGS = 22 };
static const double PI = 3.14159265358979323846;

static void bumpy_point(int i, int j, double bumps, double out[3])
{
    const double a = PI * i / RINGS, b = 2 * PI * (j % RINGS) / RINGS, r = 1 + bumps * sin(5 * a) * cos(4 * b);
    out[0] = i % RINGS ? r * sin(a) * cos(b) : 0;
    out[1] = r * cos(a);
    out[2] = i % RINGS ? r * sin(a) * sin(b) : 0;
}

/* Not convex, so that a tree has to split it; its triangles are alike. */
static struct mesh bumpy_ball(void)
{
    struct mesh mesh = mesh_rig(3000.0);
    for (int i = 0; i < RINGS; i++)
        for (int j = 0; j < RINGS; j++) {
            double at[4][3];
            bumpy_point(i, j, 0.1, at[0]);
            bumpy_point(i, j + 1, 0.1, at[1]);
            bumpy_point(i + 1, j + 1, 0.1, at[2]);
            bumpy_point(i + 1, j, 0.1, at[3]);
            if (i) mesh_rig_triangle(&mesh, (const double(*)[3])at, 1, 2);
            if (i + 1 < RINGS) mesh_rig_triangle(&mesh, (const double(*)[3])at, 2, 3);
        }
    return mesh;
}

static void settle(const struct mesh *mesh, const struct compile_options *options, struct mesh_trials *trials,
                   struct compiled *scene)
{
    struct reference reference = choice_rig_reference(mesh);
    struct error err;
    if (!mesh_choice_settle(trials, mesh, options, &reference, NULL, scene, &err)) fail_msg("%s", err.text);
    reference_free(&reference);
    mesh_trials_free(trials);
}

static void a_dense_mesh_is_drawn_as_one(void **state)
{
    struct mesh mesh = bumpy_ball();
    const struct compile_options options = choice_rig_options();
    struct compiled scene = choice_rig_compile(&mesh, &options);
    struct mesh_trials trials;
    const double tree = scene.report.instructions;

    (void)state;
    assert_false(lim_scene_is_mesh(&scene.scene));
    assert_true(mesh_choice_try(&mesh, &options, &scene, &trials));
    settle(&mesh, &options, &trials, &scene);
    const struct mesh_choice *choice = &scene.report.as_mesh;
    assert_true(lim_scene_is_mesh(&scene.scene));
    assert_true(scene.report.draws == LIM_MESH || scene.report.draws == LIM_MESH_DEPTH);
    assert_int_equal(choice->by_distance.taken + choice->by_depth.taken, 1);
    assert_true(scene.report.instructions < tree && choice->tree_instructions == tree);
    const struct mesh_trial *taken = choice->by_distance.taken ? &choice->by_distance : &choice->by_depth;
    assert_true(taken->wrong_percent <= choice->bound_percent);
    assert_true(choice->bound_percent >= 0.05 && choice->bound_percent < 0.2);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static bool is_tried(const struct mesh *mesh, const struct compile_options *options)
{
    struct compiled scene = choice_rig_compile(mesh, options);
    struct mesh_trials trials;
    const bool wants_reference = mesh_choice_try(mesh, options, &scene, &trials), tried = scene.report.as_mesh.tried;
    mesh_trials_free(&trials);
    compiled_free(&scene);
    assert_true(tried || !wants_reference);
    return tried;
}

static void what_is_said_or_must_be_exact_is_not_tried(void **state)
{
    struct random random = {3};
    struct mesh mesh = mesh_rig(3000.0);
    struct compile_options options = choice_rig_options();

    (void)state;
    mesh_rig_solids(&mesh, &random, 3);
    choice_rig_assert_open(&mesh, is_tried);
    options.framebuffer = true;
    assert_false(is_tried(&mesh, &options));
    mesh_rig_free(&mesh);
}

/* Long bars through one another: by distance they are wrong in any view. */
static void what_distance_cannot_order_is_not_drawn_by_it(void **state)
{
    struct mesh mesh = mesh_rig(3000.0);
    struct compile_options options = choice_rig_options();

    (void)state;
    for (int i = 0; i < 12; i++) {
        const double centre_m[3] = {0, 0.02 * i, 0}, half_m[3] = {3, 0.3, 0.3};
        mesh_rig_box(&mesh, centre_m, half_m, 0.26 * i, 0.1 * i);
    }
    struct compiled scene = choice_rig_compile(&mesh, &options);
    struct mesh_trials trials;
    if (mesh_choice_try(&mesh, &options, &scene, &trials)) {
        settle(&mesh, &options, &trials, &scene);
        assert_false(scene.report.as_mesh.by_distance.taken);
        assert_true(scene.report.as_mesh.by_distance.wrong_percent > scene.report.as_mesh.bound_percent);
        assert_int_not_equal(scene.report.draws, LIM_MESH);
    } else
        fail_msg("bars that are split much are dearer than a mesh of them");
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void profiles_promise_what_the_readme_says(void **state)
{
    (void)state;
    assert_true(promise_wrong_percent(NULL) == 0.05);
    assert_true(promise_wrong_percent(&core_fast) == 0.05);
    assert_true(promise_wrong_percent(&core_fine) == 0.03);
    assert_true(promise_wrong_percent(&core_exact) == 0.005);
    assert_true(promise_wrong_percent(&core_draft) == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_dense_mesh_is_drawn_as_one),
        cmocka_unit_test(what_is_said_or_must_be_exact_is_not_tried),
        cmocka_unit_test(what_distance_cannot_order_is_not_drawn_by_it),
        cmocka_unit_test(profiles_promise_what_the_readme_says),
    };
    return cmocka_run_group_tests_name("choice of a mesh", tests, NULL, NULL);
}
