/* SPDX-License-Identifier: MIT
 *
 * No ray gets through a closed scene: 10^8 pixels of random ones against the reference. */
#include "closed_scene.h"
#include "cmocka_ready.h"
#include "compare.h"
#include "compiled.h"
#include "ids.h"

#include <stdio.h>

enum { SIDE_PX = 240, SCENES = 44, FRAMES = 40 };

struct totals {
    struct comparison comparison;
    size_t polygons, splits, folded, bands;
};

static void compile(const struct model *model, struct mesh *mesh, struct compiled *scene)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .keep_faces = true};
    struct error err;

    if (!mesh_clean(model, mesh, &err) || !mesh_insert_t_vertices(mesh, &err) ||
        !compile_mesh(mesh, &options, scene, &err))
        fail_msg("%s", err.text);
}

static void compare_frames(const struct closed_scene *closed, const struct compiled *scene, struct reference *reference,
                           struct random *random, struct totals *totals)
{
    const struct simulator_setup setup = {.w_px = SIDE_PX, .h_px = SIDE_PX};
    struct lens lens;
    struct ids ids;
    struct error err;

    assert_true(lens_init(&lens, 60, 0.1, SIDE_PX, SIDE_PX, &err));
    assert_true(ids_init(&ids, scene, &setup, &err));
    for (int k = 0; k < FRAMES; k++) {
        struct viewpoint viewpoint = closed_scene_viewpoint(closed, random);
        const struct camera_path path = {"random", &viewpoint, 1};
        struct lim_camera camera;
        assert_true(camera_path_to_camera(&path, 0, &lens, &scene->grid, &camera, &err));
        assert_true(ids_frame(&ids, &camera, &err));
        reference_draw(reference, &viewpoint, &lens);
        const struct compare_counts counts = compare_picture(ids.faces, reference, NULL, 1.0 / scene->grid.units_per_m);
        comparison_add(&totals->comparison, &counts);
        totals->folded += simulator_stats(&ids.simulator)->folded;
        totals->bands += simulator_stats(&ids.simulator)->bands;
    }
    ids_free(&ids);
}

static void random_closed_scenes_have_no_holes(void **state)
{
    struct random random = {20262};
    struct totals totals = {0};

    (void)state;
    for (int k = 0; k < SCENES; k++) {
        struct closed_scene closed;
        struct mesh mesh;
        struct compiled scene;
        struct reference reference;
        struct error err;
        closed_scene_make(&closed, &random);
        compile(&closed.model, &mesh, &scene);
        assert_true(reference_init(&reference, &mesh, SIDE_PX, SIDE_PX, &err));
        compare_frames(&closed, &scene, &reference, &random, &totals);
        totals.polygons += scene.report.polygons_out;
        totals.splits += scene.report.splits;
        reference_free(&reference);
        compiled_free(&scene);
        mesh_free(&mesh);
        closed_scene_free(&closed);
    }
    const struct compare_counts *total = &totals.comparison.total;
    printf("# %zu pixels of %d scenes, %zu polygons, %zu splits, %zu folded polygons, %zu bands: wrong %.4f %%, "
           "beyond a pixel %.2f ppm, %zu holes\n",
           total->pixels, SCENES, totals.polygons, totals.splits, totals.folded, totals.bands,
           compare_wrong_percent(total), compare_beyond_ppm(total), total->holes);
    assert_true(total->pixels >= 100000000);
    assert_int_equal(total->holes, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_closed_scenes_have_no_holes)};

    return cmocka_run_group_tests_name("closed scenes", tests, NULL, NULL);
}
