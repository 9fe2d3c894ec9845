/* SPDX-License-Identifier: MIT
 *
 * Transparent polygons: what a layer does to a pixel, that layers come in the painter's order in every order of
 * drawing and with any memory, and that models and files which cannot be right are refused. */
#include "colour.h"
#include "compiler/compile.h"
#include "limner.h"
#include "pixels/blend.h"
#include "pixels/fill.h"
#include "render/simulator.h"
#include "rigs/closed_stage.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "rigs/profiles.h"
#include "rigs/random.h"
#include "scene/compiled.h"
#include "scene/convexity.h"
#include "scene/lim_check.h"
#include "scene/records.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 90, H_PX = 70, SCENES = 10, FRAMES = 5, PANES = 12 };

/* Blending ----------------------------------------------------------------------------------- */

struct rgb {
    double level[3]; /* 0..31, 0..63, 0..31 */
};

static struct rgb levels_of(uint16_t rgb565)
{
    return (struct rgb){{rgb565 >> 11, rgb565 >> 5 & 63, rgb565 & 31}};
}

static uint16_t blended(uint16_t behind, uint16_t colour, uint8_t alpha)
{
    uint16_t line[4] = {0, lim_memory_colour(behind), 0, 0};

    lim_blend(line, 1, 1, lim_memory_colour(colour), alpha);
    assert_true(line[0] == 0 && line[2] == 0);
    return lim_memory_colour(line[1]);
}

static double blend_error(uint16_t behind, uint16_t colour, uint8_t alpha)
{
    const struct rgb b = levels_of(behind), c = levels_of(colour), got = levels_of(blended(behind, colour, alpha));
    double worst = 0;

    for (int i = 0; i < 3; i++) {
        const double want = b.level[i] + (c.level[i] - b.level[i]) * alpha / 255.0;
        worst = fmax(worst, fabs(got.level[i] - want));
    }
    return worst;
}

/* Of runs of equal pixels and lone ones, from any pixel on, each becomes what it does by itself; others stay. */
static void runs_are_mixed_as_their_pixels_are(void **state)
{
    enum { LINES = 2000, LINE_PX = 40 };
    _Alignas(4) uint16_t line[LINE_PX], before[LINE_PX];
    struct random random = {17};

    (void)state;
    for (int i = 0; i < LINES; i++) {
        const uint16_t colour = (uint16_t)random_in(&random, 0, 65535), few = (uint16_t)random_in(&random, 0, 65535);
        const uint8_t alpha = (uint8_t)random_in(&random, 0, 255);
        for (int x = 0; x < LINE_PX; x++)
            line[x] = before[x] = x && random_in(&random, 0, 3) ? line[x - 1]
                                  : random_in(&random, 0, 1)    ? few
                                                                : (uint16_t)random_in(&random, 0, 65535);
        const uint16_t x0 = (uint16_t)random_in(&random, 0, LINE_PX - 1);
        const uint16_t n = (uint16_t)random_in(&random, 0, LINE_PX - x0);
        lim_blend(line, x0, n, lim_memory_colour(colour), alpha);
        for (int x = 0; x < LINE_PX; x++) {
            const bool is_mixed = x >= x0 && x < x0 + n;
            assert_int_equal(line[x], is_mixed ? lim_memory_colour(blended(lim_memory_colour(before[x]), colour, alpha))
                                               : before[x]);
        }
    }
}

/* Each channel alone, and beside others that are as far from it as can be. */
static void a_layer_is_less_than_a_level_off_for_all_values_and_alphas(void **state)
{
    double worst = 0;

    (void)state;
    for (unsigned behind = 0; behind < 64; behind++)
        for (unsigned colour = 0; colour < 64; colour++)
            for (unsigned alpha = 0; alpha < 256; alpha++) {
                const unsigned b5 = behind / 2, c5 = colour / 2;
                const uint16_t from = (uint16_t)(b5 << 11 | behind << 5 | (31 - b5));
                const uint16_t to = (uint16_t)(c5 << 11 | colour << 5 | c5);
                worst = fmax(worst, blend_error(from, to, (uint8_t)alpha));
                worst = fmax(worst, blend_error((uint16_t)~from, to, (uint8_t)alpha));
            }
    print_message("# transparent: a layer is %.3f levels off at most\n", worst);
    assert_true(worst > 0.4 && worst < 0.63);
}

static void the_ends_of_alpha_are_exact(void **state)
{
    (void)state;
    for (unsigned colour = 0; colour < 65536; colour += 7) {
        assert_int_equal(blended((uint16_t)(colour * 31), (uint16_t)colour, 255), colour);
        assert_int_equal(blended((uint16_t)colour, (uint16_t)(colour * 31), 0), colour);
        assert_int_equal(blended((uint16_t)colour, (uint16_t)colour, (uint8_t)colour), colour);
    }
}

/* Scenes ------------------------------------------------------------------------------------- */

/* Panes across the z axis, the first one nearest to an eye at positive z. */
struct panes {
    struct mesh mesh;
    struct compiled scene;
};

static void panes_compile(struct panes *panes, const uint32_t *colours, const uint8_t *alphas, size_t count)
{
    panes->mesh = mesh_rig(3000.0);
    for (size_t i = 0; i < count; i++) {
        const double z = -0.3 * (double)i;
        const double corners[4][3] = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
        struct mesh_polygon *polygon = mesh_rig_add(&panes->mesh, corners, 4);
        polygon->colour = colours[i];
        polygon->transparency = (uint8_t)(255 - alphas[i]);
        polygon->two_sided = true;
    }
    panes->scene = mesh_rig_compile(&panes->mesh, "auto", 0.5);
}

static void panes_free(struct panes *panes)
{
    compiled_free(&panes->scene);
    mesh_rig_free(&panes->mesh);
}

/* The middle of the picture, from z. */
static uint16_t seen_from(const struct compiled *scene, double z, enum lim_method method)
{
    const struct simulator_setup setup = {W_PX, H_PX, method, SIMULATOR_MEMORY, NULL};
    struct viewpoint viewpoint = {{0.05, 0.04, z}, {0.05, 0.04, 0}, 1, false, 0};
    const struct camera_path path = {"pane", &viewpoint, 1};
    struct simulator simulator;
    struct lim_camera camera;
    struct lens lens;
    struct error err;

    assert_true(lens_init(&lens, 60, 0.1, W_PX, H_PX, &err));
    assert_true(camera_path_to_camera(&path, 0, &lens, &scene->grid, &camera, &err));
    assert_true(simulator_init(&simulator, &scene->scene, &setup, &err));
    assert_true(simulator_frame(&simulator, &camera, &err));
    const uint16_t pixel = simulator.pixels[H_PX / 2 * W_PX + W_PX / 2];
    simulator_free(&simulator);
    return pixel;
}

/* Half blue over half red over black, and the other way round. */
static void the_nearer_pane_counts_more(void **state)
{
    const uint32_t colours[2] = {0x0000FF, 0xFF0000};
    const uint8_t alphas[2] = {128, 128};
    struct panes panes;

    (void)state;
    panes_compile(&panes, colours, alphas, 2);
    assert_int_equal(panes.scene.scene.background, 0);
    for (int method = LIM_NEAREST_FIRST; method <= LIM_PAINTER; method++) {
        assert_int_equal(seen_from(&panes.scene, 4, (enum lim_method)method), 8 << 11 | 16);
        assert_int_equal(seen_from(&panes.scene, -4, (enum lim_method)method), 16 << 11 | 8);
    }
    panes_free(&panes);
}

static void a_stack_of_panes_is_a_level_a_layer_off_at_most(void **state)
{
    struct random random = {77};

    (void)state;
    for (int round = 0; round < 20; round++) {
        uint32_t colours[PANES];
        uint8_t alphas[PANES];
        struct rgb want = {{0}};
        struct panes panes;
        for (size_t i = 0; i < PANES; i++) {
            colours[i] = (uint32_t)random_u64(&random) & 0xFFFFFF;
            alphas[i] = (uint8_t)random_in(&random, 1, 200);
        }
        panes_compile(&panes, colours, alphas, PANES);
        for (size_t i = PANES; i-- > 0;)
            for (int k = 0; k < 3; k++) {
                const double level = (colours[i] >> (16 - 8 * k) & 255) * (k == 1 ? 63.0 : 31.0) / 255;
                want.level[k] += (level - want.level[k]) * alphas[i] / 255.0;
            }
        const struct rgb got = levels_of(seen_from(&panes.scene, 4, LIM_NEAREST_FIRST));
        for (int k = 0; k < 3; k++)
            assert_true(fabs(got.level[k] - want.level[k]) <= PANES);
        /* Errors fade under the layers above: in fact there are hardly any. */
        for (int k = 0; k < 3; k++)
            assert_true(fabs(got.level[k] - want.level[k]) <= 3);
        panes_free(&panes);
    }
}

/* Orders and memory -------------------------------------------------------------------------- */

struct canvas {
    uint16_t pixels[H_PX][W_PX];
    uint8_t done[H_PX][W_PX];
    int lent; /* the line that is lent and not done, or -1 */
};

static void *lend(void *ctx, uint16_t y_px)
{
    struct canvas *canvas = ctx;

    assert_int_equal(canvas->lent, -1);
    canvas->lent = y_px;
    return canvas->pixels[y_px];
}

static void *lend_any(void *ctx, uint16_t y_px)
{
    return ((struct canvas *)ctx)->pixels[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct canvas *canvas = ctx;

    for (uint16_t x = x_px; x < x_px + n_px; x++)
        assert_int_equal(canvas->done[y_px][x]++, 0);
    canvas->lent = -1;
    return 0;
}

static void draw(const struct compiled *scene, enum lim_method method, size_t mem_b, const struct lim_camera *camera,
                 struct canvas *canvas, struct lim_stats *stats)
{
    const struct lim_target target = {.w_px = W_PX,
                                      .h_px = H_PX,
                                      .format = LIM_RGB565,
                                      .method = method,
                                      .ctx = canvas,
                                      .lend = method == LIM_PAINTER ? lend_any : lend,
                                      .done = done};
    void *mem = malloc(mem_b ? mem_b : lim_mem_b(&scene->scene, &target));
    struct lim lim;

    memset(canvas, 0xA5, sizeof *canvas);
    memset(canvas->done, 0, sizeof canvas->done);
    canvas->lent = -1;
    assert_int_equal(lim_init(&lim, &scene->scene, &target, mem, mem_b ? mem_b : lim_mem_b(&scene->scene, &target)),
                     LIM_OK);
    assert_int_equal(lim_frame(&lim, camera), LIM_OK);
    for (int y = 0; y < H_PX; y++)
        for (int x = 0; x < W_PX; x++)
            assert_int_equal(canvas->done[y][x], 1);
    *stats = *lim_stats(&lim);
    free(mem);
}

/* Half of the solids' faces of glass, some of them on both sides. */
static void stage_open(struct closed_stage *stage, struct random *random, const struct core *core)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest", .core = core};

    closed_stage_make(stage, random);
    for (size_t i = stage->closed.first_face[0]; i < stage->closed.model.face_count; i++) {
        if (random_in(random, 0, 1)) continue;
        stage->closed.model.faces[i].transparency = (uint8_t)random_in(random, 1, 254);
        stage->closed.model.faces[i].two_sided = random_in(random, 0, 1);
    }
    stage->closed.model.faces[stage->closed.model.face_count - 1].transparency = 100; /* there may be no solids */
    closed_stage_compile(stage, &options, W_PX, H_PX);
    assert_true(stage->scene.scene.limits.layers > 0);
}

static void frame_of(const struct closed_stage *stage, const struct core *core, enum lim_method method,
                     const struct lim_camera *camera, uint16_t *pixels)
{
    const struct simulator_setup setup = {W_PX, H_PX, method, SIMULATOR_MEMORY, core};
    struct simulator simulator;
    struct error err;

    assert_true(simulator_init(&simulator, &stage->scene.scene, &setup, &err));
    assert_true(simulator_frame(&simulator, camera, &err));
    memcpy(pixels, simulator.pixels, W_PX * H_PX * sizeof *pixels);
    simulator_free(&simulator);
}

static void both_orders_paint_the_same_in_every_profile(void **state)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    struct random random = {4711};

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        for (size_t p = 0; p < count; p++) {
            struct closed_stage stage;
            stage_open(&stage, &random, profiles[p]);
            for (int f = 0; f < FRAMES; f++) {
                static uint16_t nearest[W_PX * H_PX], painter[W_PX * H_PX], scanline[W_PX * H_PX];
                const struct lim_camera camera = closed_stage_camera(&stage, &random);
                frame_of(&stage, profiles[p], LIM_NEAREST_FIRST, &camera, nearest);
                frame_of(&stage, profiles[p], LIM_PAINTER, &camera, painter);
                frame_of(&stage, profiles[p], LIM_SCANLINE, &camera, scanline);
                assert_memory_equal(nearest, painter, sizeof nearest);
                assert_memory_equal(nearest, scanline, sizeof nearest);
            }
            closed_stage_close(&stage);
        }
    }
}

/* Anything from the least memory to what the scene asks for. */
static void any_memory_paints_the_same(void **state)
{
    struct random random = {815};
    unsigned banded = 0;

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        struct closed_stage stage;
        stage_open(&stage, &random, NULL);
        const struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = LIM_NEAREST_FIRST};
        const size_t least_b = lim_mem_min_b(&stage.scene.scene, &target);
        const size_t most_b = lim_mem_b(&stage.scene.scene, &target);
        for (int f = 0; f < FRAMES; f++) {
            static struct canvas whole, part;
            const struct lim_camera camera = closed_stage_camera(&stage, &random);
            const size_t mem_b = f ? (size_t)random_in(&random, (int64_t)least_b, (int64_t)most_b) : least_b;
            struct lim_stats stats;
            draw(&stage.scene, LIM_PAINTER, 0, &camera, &whole, &stats);
            draw(&stage.scene, LIM_NEAREST_FIRST, mem_b, &camera, &part, &stats);
            banded += stats.bands > 0;
            assert_memory_equal(whole.pixels, part.pixels, sizeof whole.pixels);
        }
        closed_stage_close(&stage);
    }
    assert_true(banded >= SCENES);
}

/* The stack's own memory alone: everything else is as large as the scene wants it. Most stacks then lie in idle memory;
 * test_layers.c has those that do not fit there either. */
static void a_stack_that_is_too_small_paints_the_same(void **state)
{
    struct random random = {29};
    unsigned beyond = 0;

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        struct closed_stage stage;
        stage_open(&stage, &random, NULL);
        for (int f = 0; f < FRAMES; f++) {
            static struct canvas whole, part;
            const struct lim_camera camera = closed_stage_camera(&stage, &random);
            struct compiled small = stage.scene; /* shares the arrays */
            struct lim_stats stats;
            small.scene.limits.layers = (uint16_t)random_in(&random, 1, 1 + stage.scene.scene.limits.layers / 2);
            draw(&stage.scene, LIM_PAINTER, 0, &camera, &whole, &stats);
            draw(&small, LIM_NEAREST_FIRST, 0, &camera, &part, &stats);
            beyond += stats.layers_max > small.scene.limits.layers;
            assert_memory_equal(whole.pixels, part.pixels, sizeof whole.pixels);
        }
        closed_stage_close(&stage);
    }
    assert_true(beyond >= SCENES);
}

/* What cannot be --------------------------------------------------------------------------------- */

static struct compiled box_of_glass(struct mesh *mesh, uint8_t transparency)
{
    const double centre[3] = {0, 0, 0}, half[3] = {1, 1, 1};

    *mesh = mesh_rig(3000.0);
    mesh_rig_box(mesh, centre, half, 0.3, 0.2);
    mesh->polygons[2].transparency = transparency;
    return mesh_rig_compile(mesh, "auto", 0.5);
}

static void a_transparent_solid_is_not_drawn_as_a_convex_one(void **state)
{
    const struct lim_target target = {.w_px = W_PX,
                                      .h_px = H_PX,
                                      .format = LIM_RGB565,
                                      .method = LIM_CONVEX,
                                      .ctx = NULL,
                                      .lend = lend,
                                      .done = done};
    static uint32_t mem[40000];
    struct mesh mesh;
    struct lim lim;

    (void)state;
    struct compiled opaque = box_of_glass(&mesh, 0);
    assert_true(scene_is_convex(&opaque.scene));
    assert_int_equal(records_with(&opaque.scene, LIM_POLYGON_ALPHA), 0);
    assert_int_equal(opaque.scene.limits.layers, 0);
    assert_int_equal(lim_init(&lim, &opaque.scene, &target, mem, sizeof mem), LIM_OK);
    compiled_free(&opaque);
    mesh_rig_free(&mesh);
    struct compiled glass = box_of_glass(&mesh, 100);
    assert_false(scene_is_convex(&glass.scene));
    assert_int_equal(records_with(&glass.scene, LIM_POLYGON_ALPHA), 1);
    assert_int_equal(lim_init(&lim, &glass.scene, &target, mem, sizeof mem), LIM_ERR_SCENE);
    compiled_free(&glass);
    mesh_rig_free(&mesh);
}

static void assert_refused(const struct compiled *scene, const char *reason)
{
    struct error err = {""};

    assert_false(lim_check(&scene->scene, &err));
    if (!strstr(err.text, reason)) fail_msg("'%s' lacks '%s'", err.text, reason);
}

static void files_whose_alpha_lies_are_refused(void **state)
{
    const uint16_t wrong[] = {0, 255, 256, 0xFFFF};
    lim_index words[256];
    struct mesh mesh;
    struct error err;
    size_t at = 0;

    (void)state;
    struct compiled glass = box_of_glass(&mesh, 100);
    memcpy(words, glass.scene.polygons, glass.scene.polygon_words * sizeof *words);
    glass.scene.polygons = words;
    while (!(words[at] & LIM_POLYGON_ALPHA))
        at += lim_record_words(words[at]);
    lim_index *alpha = &words[at + lim_record_alpha_at(words[at])];
    assert_int_equal(*alpha, 155);
    assert_true(lim_check(&glass.scene, &err));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        *alpha = wrong[i];
        assert_refused(&glass, "its alpha is ");
    }
    *alpha = 254;
    assert_true(lim_check(&glass.scene, &err));
    glass.scene.limits.layers = 0;
    assert_refused(&glass, "the limit of layers is 0");
    compiled_free(&glass);
    mesh_rig_free(&mesh);
}

static void polygons_of_different_opacity_stay_apart(void **state)
{
    const double left[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const double right[4][3] = {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};

    (void)state;
    for (int apart = 0; apart < 2; apart++) {
        struct mesh mesh = mesh_rig(3000.0);
        struct error err;
        mesh_rig_add(&mesh, left, 4)->transparency = 90;
        mesh_rig_add(&mesh, right, 4)->transparency = (uint8_t)(90 + apart);
        mesh.merged_into = calloc(3, sizeof *mesh.merged_into);
        assert_true(mesh_merge(&mesh, &err));
        assert_int_equal(mesh.polygon_count, 1 + apart);
        mesh_free(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_are_mixed_as_their_pixels_are),
        cmocka_unit_test(a_layer_is_less_than_a_level_off_for_all_values_and_alphas),
        cmocka_unit_test(the_ends_of_alpha_are_exact),
        cmocka_unit_test(the_nearer_pane_counts_more),
        cmocka_unit_test(a_stack_of_panes_is_a_level_a_layer_off_at_most),
        cmocka_unit_test(both_orders_paint_the_same_in_every_profile),
        cmocka_unit_test(any_memory_paints_the_same),
        cmocka_unit_test(a_stack_that_is_too_small_paints_the_same),
        cmocka_unit_test(a_transparent_solid_is_not_drawn_as_a_convex_one),
        cmocka_unit_test(files_whose_alpha_lies_are_refused),
        cmocka_unit_test(polygons_of_different_opacity_stay_apart),
    };
    return cmocka_run_group_tests_name("transparent", tests, NULL, NULL);
}
