/* SPDX-License-Identifier: MIT
 *
 * Which texels frames show, by two ways: painted with textures that say where they are, and by what the renderer says
 * of its places; and what of the error of a line of texels is due to its straightness. */
#include "accuracy/painted_texels.h"
#include "accuracy/straight_run.h"
#include "core/core.h"
#include "render/ids.h"
#include "rigs/cmocka_ready.h"
#include "rigs/profiles.h"
#include "rigs/texture_rig.h"
#include "scene/records.h"

#include <math.h>
#include <stdlib.h>

enum { W_PX = 64, H_PX = 48, CAMERAS = 10 };

struct comparing {
    const struct ids *ids;
    const struct painted_texels *painted;
    const struct lim_texture *texture;
    size_t number, pixels, wrong, levels, most;
};

static void compare(void *ctx, const struct core_texel_at *at)
{
    struct comparing *work = ctx;
    const size_t pixel = (size_t)at->y_px * W_PX + at->x_px;
    const struct painted_texel *shown = &work->painted->pixels[pixel];
    if (work->ids->numbers[pixel] != work->number) return;
    const double w = ldexp(1, work->texture->w_bits - (int)at->level),
                 h = ldexp(1, work->texture->h_bits - (int)at->level);
    const double x = floor(at->uv[0] * w), y = floor(at->uv[1] * h);
    work->pixels++;
    work->levels |= (size_t)1 << at->level;
    work->most = shown->x > work->most ? shown->x : work->most;
    work->wrong += shown->level != at->level || shown->x != x || shown->y != y;
}

static void compare_frame(struct comparing *work, const struct compiled *scene, const struct core *core,
                          struct simulator *places, struct simulator_setup *setup, const struct lim_camera *camera)
{
    struct ids ids;
    struct error err;
    if (!ids_init(&ids, scene, setup, &err) || !ids_frame(&ids, camera, &err)) fail_msg("%s", err.text);
    if (!simulator_frame(places, camera, &err)) fail_msg("%s", err.text);
    work->ids = &ids;
    work->number = 0;
    for (size_t word = 0; word < scene->scene.polygon_words; word += record_at(&scene->scene, word).words) {
        const lim_index *end = &scene->scene.polygons[word + record_at(&scene->scene, word).words];
        work->number++;
        work->texture = &scene->scene.textures[end[-2]];
        core->texels(places->lim, (lim_index)word, compare, work);
    }
    ids_free(&ids);
}

/* What inspection rounds to 2^-16 of a picture may be the next texel where a place lies between two. */
static void painted_texels_are_those_of_the_places(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = {{64, 32}, {512, 1024}};
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    for (size_t i = 0; i < count * 2; i++) {
        struct random random = {41};
        struct model model = {0};
        struct mesh mesh;
        struct error err;
        const struct core *core = profiles[i / 2];
        texture_rig_room(&model, texture_rig_picture(&model, sizes[i % 2][0], sizes[i % 2][1], &random), 1);
        struct compiled scene = texture_rig_compile(&model, &mesh, core);
        struct simulator_setup setup = {
            .w_px = W_PX, .h_px = H_PX, .method = LIM_NEAREST_FIRST, .panel = SIMULATOR_MEMORY, .core = core};
        struct painted_texels painted = {.pixels = NULL};
        struct simulator places;
        struct comparing work = {.painted = &painted};
        if (!painted_texels_init(&painted, &scene, &setup, &err) ||
            !simulator_init(&places, &scene.scene, &setup, &err))
            fail_msg("%s", err.text);
        for (uint32_t k = 0; k < CAMERAS; k++) {
            const struct lim_camera camera = {.yaw = k * 0x17654321,
                                              .pitch = k * 0x02456789,
                                              .tan_x_q28 = 1 << (28 - k % 4),
                                              .tan_y_q28 = 3 << (26 - k % 4),
                                              .near_q8 = 256};
            if (!painted_texels_frame(&painted, &camera, &err)) fail_msg("%s", err.text);
            compare_frame(&work, &scene, core, &places, &setup, &camera);
        }
        print_message("# %s: %zu pixels, %zu otherwise, levels 0x%zx\n", core->name, work.pixels, work.wrong,
                      work.levels);
        assert_true(work.pixels > CAMERAS * W_PX * H_PX * 9 / 10);
        assert_true(work.wrong <= work.pixels / 500);
        assert_true((work.levels & (work.levels - 1)) != 0);
        assert_true(i % 2 == 0 || work.most >= 256); /* more than 8 bits tell */
        simulator_free(&places);
        painted_texels_free(&painted);
        compiled_free(&scene);
        mesh_free(&mesh);
        model_free(&model);
    }
}

/* Straight pieces ------------------------------------------------------------------------------ */

static struct straight_pixel pixel_at(uint16_t x, double texels, double way)
{
    return (struct straight_pixel){
        .x_px = x, .y_px = 3, .level = 1, .texels = {texels, 5}, .way = {way, 0}, .sides = {64, 64}};
}

static void what_a_straight_line_explains_is_none_of_its(void **state)
{
    (void)state;
    struct straight_run run = {.count = 0};
    double left = 0;
    for (uint16_t x = 0; x < 20; x++) {
        const struct straight_pixel pixel = pixel_at((uint16_t)(100 + x), fmod(60 + 0.5 * x, 64), 0.3 - 0.02 * x);
        left += straight_run_add(&run, &pixel);
    }
    left += straight_run_end(&run);
    assert_true(fabs(left) < 1e-12);
}

/* Of c x^2 over n pixels c^2 n (n^2 - 1) (n^2 - 4) / 180 remain, by discrete Legendre polynomials. */
static void a_curve_leaves_what_no_line_spares(void **state)
{
    (void)state;
    for (int n = 3; n < 40; n++) {
        struct straight_run run = {.count = 0};
        double left = 0;
        for (int x = 0; x < n; x++) {
            const struct straight_pixel pixel = pixel_at((uint16_t)x, 0.25 * x, 0.001 * x * x - 0.01 * x + 0.5);
            left += straight_run_add(&run, &pixel);
        }
        assert_true(left == 0);
        left = straight_run_end(&run);
        const double square = n * (double)n, wanted = 1e-6 * n * (square - 1) * (square - 4) / 180;
        assert_true(fabs(left - wanted) < 1e-9 * (1 + wanted));
    }
}

/* Another step, line or level, or a gap, is another piece: two lines of different slopes leave nothing then. */
static void pieces_end_where_steps_change(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        struct straight_run run = {.count = 0};
        double left = 0;
        for (int x = 0; x < 20; x++) {
            const bool second = x >= 10;
            struct straight_pixel pixel = pixel_at((uint16_t)x, 0.25 * x, second ? 0.5 - 0.03 * x : 0.03 * x);
            if (kind == 0 && second) pixel.texels[0] += 0.2 * (x - 10);
            if (kind == 1 && second) pixel.y_px++;
            if (kind == 2 && second) pixel.level++;
            if (kind == 3 && second) pixel.x_px = (uint16_t)(pixel.x_px + 2);
            left += straight_run_add(&run, &pixel);
        }
        left += straight_run_end(&run);
        assert_true(fabs(left) < 1e-12 || (kind == 0 && fabs(left) < 0.01));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(painted_texels_are_those_of_the_places),
        cmocka_unit_test(what_a_straight_line_explains_is_none_of_its),
        cmocka_unit_test(a_curve_leaves_what_no_line_spares),
        cmocka_unit_test(pieces_end_where_steps_change),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
