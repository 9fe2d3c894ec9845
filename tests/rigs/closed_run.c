/* SPDX-License-Identifier: MIT
 *
 * Scenes one after the other; within a scene the reference draws each frame once for all profiles. */
#include "closed_run.h"

#include "base/progress.h"
#include "closed_scene.h"
#include "cmocka_ready.h"
#include "compiler/compile_mesh.h"
#include "render/ids.h"

#include <stdio.h>
#include <string.h>

/* One scene, ready to be drawn in every profile. */
struct run_stage {
    struct closed_scene closed;
    struct mesh mesh;
    struct reference reference;
    struct lens lens;
    struct compiled scenes[PROFILES_MAX];
    struct ids ids[PROFILES_MAX];
};

static void compile_for(struct run_stage *stage, size_t k, struct closed_run_sum *sum, unsigned side_px)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "auto", .keep_faces = true, .core = sum->profile};
    const struct simulator_setup setup = {.w_px = side_px, .h_px = side_px, .core = sum->profile};
    struct error err;

    if (!compile_mesh(&stage->mesh, &options, &stage->scenes[k], &err) ||
        !ids_init(&stage->ids[k], &stage->scenes[k], &setup, &err))
        fail_msg("%s", err.text);
    sum->splits += stage->scenes[k].report.splits;
}

static void stage_open(struct run_stage *stage, struct random *random, struct closed_run_sum *sums, size_t count,
                       unsigned side_px)
{
    struct error err;

    closed_scene_make(&stage->closed, random);
    if (!mesh_clean(&stage->closed.model, &stage->mesh, &err) ||
        !reference_init(&stage->reference, &stage->mesh, side_px, side_px, &err) ||
        !mesh_insert_t_vertices(&stage->mesh, &err) || !lens_init(&stage->lens, 60, 0.1, side_px, side_px, &err))
        fail_msg("%s", err.text);
    for (size_t k = 0; k < count; k++)
        compile_for(stage, k, &sums[k], side_px);
}

static void stage_close(struct run_stage *stage, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        ids_free(&stage->ids[k]);
        compiled_free(&stage->scenes[k]);
    }
    reference_free(&stage->reference);
    mesh_free(&stage->mesh);
    closed_scene_free(&stage->closed);
}

static size_t difference(size_t a, size_t b)
{
    return a > b ? a - b : b - a;
}

static size_t count_background(const uint32_t *faces, size_t pixels)
{
    size_t count = 0;

    for (size_t i = 0; i < pixels; i++)
        count += faces[i] == 0;
    return count;
}

static void draw(struct run_stage *stage, size_t k, struct closed_run_sum *sum, const struct viewpoint *viewpoint)
{
    struct viewpoint only = *viewpoint;
    const struct camera_path path = {"random", &only, 1};
    const struct grid *grid = &stage->scenes[k].grid;
    struct ids *ids = &stage->ids[k];
    struct lim_camera camera;
    struct error err;

    if (!camera_path_to_camera(&path, 0, &stage->lens, grid, &camera, &err) || !ids_frame(ids, &camera, &err))
        fail_msg("%s", err.text);
    const struct lim_stats *stats = simulator_stats(&ids->simulator);
    const size_t pixels = simulator_pixel_count(&ids->simulator), background = count_background(ids->faces, pixels);
    sum->overdrawn += stats->pixels_painted - (pixels - background);
    sum->miscounted += difference(stats->pixels_background, background);
    sum->non_monotone += stats->non_monotone;
    sum->bands += stats->bands;
    holes_add(&sum->holes, sum->profile, ids->faces, &stage->reference, 1 / grid->units_per_m);
}

size_t closed_run(const struct closed_run_plan *plan, struct closed_run_sum sums[PROFILES_MAX])
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    struct random random = {plan->seed};

    memset(sums, 0, PROFILES_MAX * sizeof *sums);
    for (size_t k = 0; k < count; k++)
        sums[k].profile = profiles[k];
    for (int s = 0; s < plan->scenes; s++) {
        static struct run_stage stage;
        progress("closed scenes: %d of %d, %zu million pixels a profile", s, plan->scenes,
                 sums[0].holes.pixels / 1000000);
        stage_open(&stage, &random, sums, count, plan->side_px);
        for (int f = 0; f < plan->frames; f++) {
            const struct viewpoint viewpoint = closed_scene_viewpoint(&stage.closed, &random);
            reference_draw(&stage.reference, &viewpoint, &stage.lens);
            for (size_t k = 0; k < count; k++)
                draw(&stage, k, &sums[k], &viewpoint);
        }
        stage_close(&stage, count);
    }
    progress_end();
    return count;
}

void closed_run_judge(const struct closed_run_sum *sums, size_t count, size_t pixels)
{
    size_t failed = 0;

    for (size_t k = 0; k < count; k++) {
        const struct closed_run_sum *sum = &sums[k];
        printf("# closed-scenes %s: %zu pixels, %zu holes, %zu miscounted, %zu painted over; %.4f %% wrong, "
               "%zu misplaced, %zu splits, %zu non-monotone polygons, %zu bands\n",
               sum->profile->name, sum->holes.pixels, sum->holes.holes, sum->miscounted, sum->overdrawn,
               holes_wrong_percent(&sum->holes), sum->holes.misplaced, sum->splits, sum->non_monotone, sum->bands);
        failed += sum->holes.holes || sum->miscounted || sum->holes.pixels < pixels ||
                  10 * sum->overdrawn > sum->holes.pixels;
    }
    assert_true(count > 0);
    assert_int_equal(failed, 0);
}
