/* SPDX-License-Identifier: MIT
 *
 * The predicted share of wrong pixels: next to nothing where the renderer is right, much where the
 * reference is made to disagree. */
#include "accuracy/predict.h"
#include "compiler/compile.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"

#include <math.h>
#include <string.h>

static const double CENTRE_M[3] = {0, 0, 0}, HALF_M[3] = {1, 1, 1};

static size_t most_face(const struct mesh *a, const struct mesh *b)
{
    size_t most = 0;
    for (size_t i = 0; i < a->polygon_count; i++)
        if (a->polygons[i].face > most) most = a->polygons[i].face;
    for (size_t i = 0; i < b->polygon_count; i++)
        if (b->polygons[i].face > most) most = b->polygons[i].face;
    return most;
}

/* What a scene compiled from one mesh shows wrong in the eyes of another. */
static double percent_wrong(const struct mesh *mesh, const struct mesh *truth, const uint32_t *groups)
{
    struct compiled scene = mesh_rig_compile(mesh, "auto", 0.5);
    struct reference reference;
    struct error err;
    struct predicted wrong = {.percent = NAN};

    assert_true(reference_init(&reference, truth, PREDICT_SIDE_PX, PREDICT_SIDE_PX, &err));
    if (!predict_wrong(&scene, NULL, &reference, groups, most_face(mesh, truth), &wrong, &err))
        fail_msg("%s", err.text);
    reference_free(&reference);
    compiled_free(&scene);
    assert_int_equal(wrong.cameras, PREDICT_CAMERAS);
    return wrong.percent;
}

static struct mesh turned_cube(void)
{
    struct mesh mesh = mesh_rig(3000.0);
    mesh_rig_box(&mesh, CENTRE_M, HALF_M, 0.7, 0.4);
    return mesh;
}

static void a_cube_is_drawn_right(void **state)
{
    struct mesh cube = turned_cube();

    (void)state;
    const double percent = percent_wrong(&cube, &cube, NULL);
    assert_true(percent >= 0 && percent < 0.01);
    mesh_rig_free(&cube);
}

static void every_run_predicts_the_same(void **state)
{
    struct random random = {5};
    struct mesh solids = mesh_rig(3000.0);

    (void)state;
    mesh_rig_solids(&solids, &random, 10);
    const double first = percent_wrong(&solids, &solids, NULL), second = percent_wrong(&solids, &solids, NULL);
    assert_true(first > 0 && first < 1); /* not a constant 0: needles lie between pixels */
    assert_memory_equal(&first, &second, sizeof first);
    mesh_rig_free(&solids);
}

/* Two faces that swapped numbers are wrong wherever they are seen, unless they count as one. */
static void faces_that_swapped_are_noticed(void **state)
{
    const uint32_t one_group[7] = {0, 1, 1, 1, 1, 1, 1};
    struct mesh cube = turned_cube(), swapped = turned_cube();

    (void)state;
    swapped.polygons[0].face = cube.polygons[1].face;
    swapped.polygons[1].face = cube.polygons[0].face;
    assert_true(percent_wrong(&cube, &swapped, NULL) > 1);
    assert_true(percent_wrong(&cube, &swapped, one_group) < 0.01);
    mesh_rig_free(&swapped);
    mesh_rig_free(&cube);
}

static void a_face_that_is_missing_is_noticed(void **state)
{
    struct mesh cube = turned_cube(), open = turned_cube();

    (void)state;
    open.polygon_count--;
    assert_true(percent_wrong(&open, &cube, NULL) > 0.5);
    mesh_rig_free(&open);
    mesh_rig_free(&cube);
}

static struct compiled compile_rooms(bool predict)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .predict = predict};
    struct compiled scene;
    struct error err;

    if (!compile_model("sim/scenes/rooms.obj", &options, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}

/* Merged faces count as one there: without that much would be wrong. */
static void the_compiler_predicts_when_asked(void **state)
{
    struct compiled unasked = compile_rooms(false), asked = compile_rooms(true);

    (void)state;
    assert_true(isnan(unasked.report.wrong.percent));
    assert_true(asked.report.mesh.merged > 0);
    assert_true(asked.report.wrong.percent >= 0 && asked.report.wrong.percent < 0.1);
    compiled_free(&asked);
    compiled_free(&unasked);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cube_is_drawn_right),
        cmocka_unit_test(every_run_predicts_the_same),
        cmocka_unit_test(faces_that_swapped_are_noticed),
        cmocka_unit_test(a_face_that_is_missing_is_noticed),
        cmocka_unit_test(the_compiler_predicts_when_asked),
    };

    return cmocka_run_group_tests_name("predict", tests, NULL, NULL);
}
