/* SPDX-License-Identifier: MIT
 *
 * What the compiler measures on sampled cameras: eyes in free space, pools that suffice for them,
 * the share of wrong pixels. */
#include "closed_scene.h"
#include "cmocka_ready.h"
#include "mesh_rig.h"
#include "pools.h"
#include "predict.h"
#include "sample.h"
#include "simulator.h"

#include <math.h>
#include <string.h>

enum { SIDE_PX = 120, EYES = 200 };

static void compile(const struct model *model, struct compiled *scene, struct reference *reference)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "fewest", .keep_faces = true, .w_px = SIDE_PX, .h_px = SIDE_PX};
    struct mesh mesh;
    struct error err;

    if (!mesh_clean(model, &mesh, &err) || !reference_init(reference, &mesh, PREDICT_SIDE_PX, PREDICT_SIDE_PX, &err) ||
        !mesh_insert_t_vertices(&mesh, &err) || !compile_mesh(&mesh, &options, scene, &err))
        fail_msg("%s", err.text);
    mesh_free(&mesh);
}

/* Walls seen from behind are seen through, so an eye outside of the building would see all of it. */
static void eyes_sampled_in_a_building_are_inside_of_it(void **state)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest"};
    struct compiled scene;
    struct sampler sampler;
    struct error err;

    (void)state;
    assert_true(compile_model("sim/scenes/rooms.obj", &options, &scene, &err));
    sampler_init(&sampler, &scene);
    for (int k = 0; k < EYES; k++) {
        const struct viewpoint viewpoint = sampler_next(&sampler);
        const double *eye = viewpoint.eye_m;
        assert_true(eye[0] > -1.91 && eye[0] < 21.91 && eye[1] > -0.01 && eye[1] < 3.01 && eye[2] > -1.91 &&
                    eye[2] < 21.91);
    }
    compiled_free(&scene);
}

static void eyes_sampled_around_an_object_are_outside_of_it(void **state)
{
    const double half_m[3] = {1, 2, 0.5}, centre_m[3] = {3, 4, 5};
    struct mesh mesh = mesh_rig(1000);
    struct sampler sampler;

    (void)state;
    mesh_rig_box(&mesh, centre_m, half_m, 0, 0);
    struct compiled scene = mesh_rig_compile(&mesh, "fewest", 0.5);
    sampler_init(&sampler, &scene);
    for (int k = 0; k < EYES; k++) {
        const struct viewpoint viewpoint = sampler_next(&sampler);
        bool outside = false;
        for (int i = 0; i < 3; i++)
            outside |= fabs(viewpoint.eye_m[i] - centre_m[i]) > half_m[i] - 0.002;
        assert_true(outside);
    }
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static uint32_t bands_over_sampled_cameras(const struct compiled *scene)
{
    const struct simulator_setup setup = {.w_px = SIDE_PX, .h_px = SIDE_PX, .panel = SIMULATOR_MEMORY};
    struct simulator simulator;
    struct sampler sampler;
    struct lens lens;
    struct error err;
    uint32_t bands = 0;

    assert_true(simulator_init(&simulator, &scene->scene, &setup, &err));
    assert_true(lens_init(&lens, 60, 0.1, SIDE_PX, SIDE_PX, &err));
    sampler_init(&sampler, scene);
    for (int k = 0; k < 256; k++) {
        struct viewpoint viewpoint = sampler_next(&sampler);
        const struct camera_path path = {"sampled", &viewpoint, 1};
        struct lim_camera camera;
        assert_true(camera_path_to_camera(&path, 0, &lens, &scene->grid, &camera, &err));
        assert_true(simulator_frame(&simulator, &camera, &err));
        bands += simulator_stats(&simulator)->bands > 0;
    }
    simulator_free(&simulator);
    return bands;
}

static void measured_pools_suffice_for_the_cameras_they_were_measured_on(void **state)
{
    struct random random = {52};
    struct closed_scene closed;
    struct compiled scene;
    struct reference reference;

    (void)state;
    closed_scene_make(&closed, &random);
    compile(&closed.model, &scene, &reference);
    assert_true(bands_over_sampled_cameras(&scene) <= 3); /* one is left out of each of three pools */
    assert_true(pools_mcu_mem_b(&scene) > pools_mcu_mem_min_b(&scene));
    scene.scene.limits.retained_cells = 20; /* with too little there are bands: the check can fail */
    assert_true(bands_over_sampled_cameras(&scene) > 100);
    reference_free(&reference);
    compiled_free(&scene);
    closed_scene_free(&closed);
}

static void prediction_is_small_for_few_edges_and_the_same_each_time(void **state)
{
    struct random random = {53};
    struct closed_scene closed;
    struct compiled scene;
    struct reference reference;
    struct error err;
    double first, second, fine;

    (void)state;
    closed_scene_make(&closed, &random);
    compile(&closed.model, &scene, &reference);
    assert_true(isnan(scene.report.wrong_percent)); /* not asked for */
    assert_true(predict_wrong_percent(&scene, NULL, &reference, NULL, &first, &err));
    assert_true(predict_wrong_percent(&scene, &core_fast, &reference, NULL, &second, &err));
    assert_true(predict_wrong_percent(&scene, &core_fine, &reference, NULL, &fine, &err));
    assert_true(first == second);
    assert_true(first > 0 && first < 0.1);
    assert_true(fine < first);
    reference_free(&reference);
    compiled_free(&scene);
    closed_scene_free(&closed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eyes_sampled_in_a_building_are_inside_of_it),
        cmocka_unit_test(eyes_sampled_around_an_object_are_outside_of_it),
        cmocka_unit_test(measured_pools_suffice_for_the_cameras_they_were_measured_on),
        cmocka_unit_test(prediction_is_small_for_few_edges_and_the_same_each_time),
    };

    return cmocka_run_group_tests_name("pools", tests, NULL, NULL);
}
