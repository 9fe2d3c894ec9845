/* SPDX-License-Identifier: MIT
 *
 * An oracle of others' making: the renderer and the double-precision reference against OSMesa, face
 * by face, pixel by pixel, over the camera paths of the demo and of the benchmark scenes.
 *
 * No pixel is left out. Where faces lie in one plane, or meet nearer than the depth buffer can tell, OSMesa
 * picks one by its rounding, and the reference the one with the lower number; how little that is, the
 * reference's own agreement tells, which is promised as well. */
#include "accuracy/reference.h"
#include "compiler/compile.h"
#include "readers/model_import.h"
#include "render/ids.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/osmesa.h"
#include "rigs/profiles.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE_PX = 240, PIXELS = SIDE_PX * SIDE_PX, FRAMES = 64, FRAMES_LEAST = 6 };

static const double REFERENCE_PERCENT = 99.997; /* least agreement of the reference: oracle and reference are right */

/* What every profile draws of a scene, and how many of those pixels OSMesa sees otherwise. */
struct contest {
    const char *name;
    struct model model;
    struct camera_path path;
    struct lens lens;
    struct osmesa osmesa;
    struct reference reference;
    const struct core *profiles[PROFILES_MAX];
    size_t profile_count;
    struct compiled scenes[PROFILES_MAX];
    struct ids ids[PROFILES_MAX];
    uint32_t oracle[PIXELS];
    size_t pixels, differ[PROFILES_MAX], reference_differs;
};

/* Least agreement, percent; draft promises nothing. */
static double promised(const struct core *profile)
{
    static const struct {
        const char *name;
        double percent;
    } least[] = {{"fast", 99.94}, {"fine", 99.96}, {"exact", 99.995}};

    for (size_t i = 0; i < sizeof least / sizeof *least; i++)
        if (strcmp(least[i].name, profile->name) == 0) return least[i].percent;
    return 0;
}

static void compile_for(struct contest *contest, size_t k, const char *model_path)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "auto", .keep_faces = true, .unlit = true, .core = contest->profiles[k]};
    const struct simulator_setup setup = {.w_px = SIDE_PX, .h_px = SIDE_PX, .core = contest->profiles[k]};
    struct error err;

    if (!compile_model(model_path, &options, &contest->scenes[k], &err) ||
        !ids_init(&contest->ids[k], &contest->scenes[k], &setup, &err))
        fail_msg("%s", err.text);
}

static void begin(struct contest *contest, const char *name, const char *model_path, const char *camera_path)
{
    struct error err;

    memset(contest, 0, sizeof *contest);
    contest->name = name;
    contest->profile_count = profiles_find(contest->profiles);
    assert_true(contest->profile_count >= 2);
    if (!model_import(model_path, &contest->model, &err) || !camera_path_read(camera_path, &contest->path, &err) ||
        !reference_read(&contest->reference, model_path, &(struct orientation){0}, NULL, SIDE_PX, SIDE_PX, &err) ||
        !osmesa_init(&contest->osmesa, SIDE_PX, SIDE_PX, &err))
        fail_msg("%s", err.text);
    for (size_t k = 0; k < contest->profile_count; k++)
        compile_for(contest, k, model_path);
    /* OSMesa gets the faces as they are in the file: all of them must be fit for it. */
    const struct mesh_counts *counts = &contest->scenes[0].report.mesh;
    assert_int_equal(counts->non_planar + counts->concave, 0);
    assert_true(lens_init(&contest->lens, 60, lens_default_near_m(&contest->scenes[0].grid), SIDE_PX, SIDE_PX, &err));
}

static void end(struct contest *contest)
{
    for (size_t k = 0; k < contest->profile_count; k++) {
        ids_free(&contest->ids[k]);
        compiled_free(&contest->scenes[k]);
    }
    osmesa_free(&contest->osmesa);
    reference_free(&contest->reference);
    camera_path_free(&contest->path);
    model_free(&contest->model);
}

static size_t differing(const uint32_t *a, const uint32_t *b)
{
    size_t count = 0;

    for (size_t i = 0; i < PIXELS; i++)
        count += a[i] != b[i];
    return count;
}

static void draw(struct contest *contest, size_t frame)
{
    const struct viewpoint *viewpoint = &contest->path.frames[frame];
    struct lim_camera camera;
    struct error err;

    osmesa_draw(&contest->osmesa, &contest->model, viewpoint, &contest->lens, contest->oracle);
    reference_draw(&contest->reference, viewpoint, &contest->lens);
    contest->pixels += PIXELS;
    contest->reference_differs += differing(contest->reference.faces, contest->oracle);
    for (size_t k = 0; k < contest->profile_count; k++) {
        if (!camera_path_to_camera(&contest->path, frame, &contest->lens, &contest->scenes[k].grid, &camera, &err) ||
            !ids_frame(&contest->ids[k], &camera, &err))
            fail_msg("%s", err.text);
        contest->differ[k] += differing(contest->ids[k].faces, contest->oracle);
    }
}

static double agreement_percent(const struct contest *contest, size_t differ)
{
    return 100 - 100 * (double)differ / (double)contest->pixels;
}

static void judge(const struct contest *contest, size_t frames)
{
    size_t broken = 0;

    printf("# osmesa %s: %s, %d sub-pixel bits at %d times the resolution, %d depth bits, %zu frames of %dx%d pixels\n",
           contest->name, contest->osmesa.renderer, contest->osmesa.sub_pixel_bits, contest->osmesa.density,
           contest->osmesa.depth_bits, frames, SIDE_PX, SIDE_PX);
    printf("# osmesa %s reference: agreement %.4f %%\n", contest->name,
           agreement_percent(contest, contest->reference_differs));
    for (size_t k = 0; k < contest->profile_count; k++) {
        const double least = promised(contest->profiles[k]), got = agreement_percent(contest, contest->differ[k]);
        printf("# osmesa %s %s: agreement %.4f %%, promised %g %%\n", contest->name, contest->profiles[k]->name, got,
               least);
        broken += !(got >= least);
    }
    assert_true(agreement_percent(contest, contest->reference_differs) >= REFERENCE_PERCENT);
    assert_int_equal(broken, 0);
}

static void agree(const char *name, const char *model_path, const char *camera_path)
{
    static struct contest contest;
    size_t frames = (size_t)(effort(FRAMES) < FRAMES_LEAST ? FRAMES_LEAST : effort(FRAMES));

    begin(&contest, name, model_path, camera_path);
    if (frames > contest.path.count) frames = contest.path.count;
    for (size_t f = 0; f < frames; f++)
        draw(&contest, f * contest.path.count / frames);
    judge(&contest, frames);
    end(&contest);
}

static void osmesa_sees_the_demo_as_we_do(void **state)
{
    const char *build = getenv("BUILD");
    char model_path[512], camera_path[512];

    (void)state;
    assert_non_null(build); /* where the Makefile had the demo made */
    snprintf(model_path, sizeof model_path, "%s/scenes/demo.obj", build);
    snprintf(camera_path, sizeof camera_path, "%s/scenes/demo.cam", build);
    agree("demo", model_path, camera_path);
}

static void osmesa_sees_rooms_as_we_do(void **state)
{
    (void)state;
    agree("rooms", "sim/scenes/rooms.obj", "sim/scenes/rooms.cam");
}

static void osmesa_sees_rooms_tilted_as_we_do(void **state)
{
    (void)state;
    agree("rooms-tilted", "sim/scenes/rooms-tilted.obj", "sim/scenes/rooms-tilted.cam");
}

static void osmesa_sees_the_teapot_as_we_do(void **state)
{
    (void)state;
    agree("teapot", "sim/scenes/teapot.obj", "sim/scenes/teapot.cam");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(osmesa_sees_the_demo_as_we_do),
        cmocka_unit_test(osmesa_sees_rooms_as_we_do),
        cmocka_unit_test(osmesa_sees_rooms_tilted_as_we_do),
        cmocka_unit_test(osmesa_sees_the_teapot_as_we_do),
    };

    return cmocka_run_group_tests_name("osmesa", tests, NULL, NULL);
}
