/* SPDX-License-Identifier: MIT
 *
 * Scan lines show what nearest first shows, bit for bit: in every profile, of any scene, in any memory, behind round
 * glass; and so do targets that are given what scan lines cannot paint. */
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "limner.h"
#include "rigs/closed_stage.h"
#include "rigs/cmocka_ready.h"
#include "rigs/convex_rig.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "rigs/room_stage.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 72, H_PX = 54, SCENES = 4, FRAMES = 8, NEVER = -1, DEVICE_ERROR = -5 };

struct canvas {
    _Alignas(8) uint16_t pixels[H_PX][W_PX];
    uint8_t done[H_PX][W_PX]; /* how often each pixel was final */
    bool is_round;
};

static void *lend(void *ctx, uint16_t y_px)
{
    return ((struct canvas *)ctx)->pixels[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct canvas *canvas = ctx;

    for (uint16_t x = x_px; x < x_px + n_px; x++)
        canvas->done[y_px][x]++;
    return 0;
}

static void visible(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    const uint16_t cut = (uint16_t)(((const struct canvas *)ctx)->is_round ? abs((int)y_px - H_PX / 2) : 0);

    *x0_px = cut;
    *x1_px = (uint16_t)(W_PX - cut);
}

static struct lim_target target_of(struct canvas *canvas, enum lim_method method)
{
    return (struct lim_target){.w_px = W_PX,
                               .h_px = H_PX,
                               .format = LIM_RGB565,
                               .method = method,
                               .ctx = canvas,
                               .lend = lend,
                               .done = done,
                               .visible = canvas->is_round ? visible : NULL};
}

static void wipe(struct canvas *canvas)
{
    memset(canvas->pixels, 0, sizeof canvas->pixels);
    memset(canvas->done, 0, sizeof canvas->done);
}

/* Each pixel that the glass shows is final once, and no other is touched. */
static void assert_done_once(struct canvas *canvas)
{
    for (uint16_t y = 0; y < H_PX; y++) {
        uint16_t x0, x1;
        visible(canvas, y, &x0, &x1);
        for (uint16_t x = 0; x < W_PX; x++) {
            assert_int_equal(canvas->done[y][x], x >= x0 && x < x1);
            if (x < x0 || x >= x1) assert_int_equal(canvas->pixels[y][x], 0);
        }
    }
}

/* One frame; mem_b 0: what the scene asks for. */
static struct lim_stats draw(struct canvas *canvas, const struct core *core, const struct lim_scene *scene,
                             enum lim_method method, const struct lim_camera *camera, size_t mem_b)
{
    const struct lim_target target = target_of(canvas, method);
    if (!mem_b) mem_b = core->mem_b(scene, &target);
    void *lim = calloc(1, core->lim_b), *mem = malloc(mem_b);

    wipe(canvas);
    assert_int_equal(core->init(lim, scene, &target, mem, mem_b), LIM_OK);
    assert_int_equal(core->frame(lim, camera), LIM_OK);
    const struct lim_stats stats = *core->stats(lim);
    free(lim);
    free(mem);
    assert_done_once(canvas);
    return stats;
}

/* Both orders in plenty of memory. */
static void assert_same(const struct core *core, const struct lim_scene *scene, const struct lim_camera *camera,
                        bool is_round)
{
    static struct canvas nearest, scanline;

    nearest.is_round = scanline.is_round = is_round;
    (void)draw(&nearest, core, scene, LIM_NEAREST_FIRST, camera, 0);
    const struct lim_stats stats = draw(&scanline, core, scene, LIM_SCANLINE, camera, 0);
    assert_memory_equal(nearest.pixels, scanline.pixels, sizeof nearest.pixels);
    if (stats.bands) return; /* of single lines, perhaps: these are drawn nearest first */
    assert_int_equal(stats.gaps_max, 0);
    if (!is_round) assert_int_equal(stats.pixels_background, W_PX * H_PX);
}

static struct closed_stage make_closed(struct random *random, const struct core *core)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest", .core = core};
    struct closed_stage stage;

    closed_stage_make(&stage, random);
    closed_stage_compile(&stage, &options, W_PX, H_PX);
    return stage;
}

static void rooms_are_the_same_in_every_profile(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_or_sub_bits(found);
    (void)state;
    for (size_t i = 0; i < count; i++) {
        struct random random = {71};
        for (int s = 0; s < SCENES; s++) {
            struct closed_stage stage = make_closed(&random, found[i]);
            for (int f = 0; f < effort(FRAMES); f++) {
                const struct lim_camera camera = closed_stage_camera(&stage, &random);
                assert_same(found[i], &stage.scene.scene, &camera, f % 2);
            }
            closed_stage_close(&stage);
        }
    }
}

/* Of several solids some lie before others; most of the picture is background. */
static struct compiled make_solids(struct random *random, const struct core *core)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest", .core = core};
    struct mesh mesh = mesh_rig(6000.0);
    struct compiled scene;
    struct error err;

    for (unsigned k = 0; k < 3; k++)
        convex_rig_add(&mesh, random, (unsigned)random_in(random, 0, CONVEX_RIG_KINDS - 1));
    for (size_t i = 0; i < mesh.polygon_count; i++)
        mesh.polygons[i].colour = (uint32_t)(random_u64(random) & 0xFFFFFF);
    if (!compile_mesh(&mesh, &options, &scene, &err)) fail_msg("%s", err.text);
    mesh_rig_free(&mesh);
    return scene;
}

static bool view_solids(const struct compiled *scene, struct random *random, struct lim_camera *camera)
{
    struct viewpoint viewpoint = convex_rig_viewpoint(random);
    const struct camera_path path = {"random", &viewpoint, 1};
    struct lens lens;
    struct error err;

    assert_true(lens_init(&lens, 60, 0.02, W_PX, H_PX, &err));
    return camera_path_to_camera(&path, 0, &lens, &scene->grid, camera, &err);
}

static void solids_are_the_same_in_every_profile(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_or_sub_bits(found);
    (void)state;
    for (size_t i = 0; i < count; i++) {
        struct random random = {72};
        int drawn = 0;
        for (int s = 0; s < SCENES; s++) {
            struct compiled scene = make_solids(&random, found[i]);
            struct lim_camera camera;
            for (int f = 0; f < effort(FRAMES); f++) {
                if (!view_solids(&scene, &random, &camera)) continue;
                assert_same(found[i], &scene.scene, &camera, f % 2);
                drawn++;
            }
            compiled_free(&scene);
        }
        assert_true(drawn > 0);
    }
}

/* From the least that lim_init() takes, which is bands of a few pixels, to what is asked for. */
static void any_memory_gives_the_same_picture(void **state)
{
    struct random random = {73};
    uint32_t least_bands = 0;

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        static struct canvas plenty, scarce;
        struct closed_stage stage = make_closed(&random, NULL);
        const struct lim_scene *scene = &stage.scene.scene;
        const struct lim_camera camera = closed_stage_camera(&stage, &random);
        plenty.is_round = scarce.is_round = s % 2;
        const struct lim_target target = target_of(&scarce, LIM_SCANLINE);
        const size_t least_b = lim_mem_min_b(scene, &target), asked_b = lim_mem_b(scene, &target);
        (void)draw(&plenty, &core_fast, scene, LIM_NEAREST_FIRST, &camera, 0);
        for (size_t part = 0; part <= 8; part++) {
            const size_t mem_b = least_b + (asked_b - least_b) * part * part / 64;
            const struct lim_stats stats = draw(&scarce, &core_fast, scene, LIM_SCANLINE, &camera, mem_b);
            assert_memory_equal(plenty.pixels, scarce.pixels, sizeof plenty.pixels);
            if (part == 0) least_bands += stats.bands;
        }
        closed_stage_close(&stage);
    }
    printf("# %u bands in the least memory\n", (unsigned)least_bands);
    assert_true(least_bands >= SCENES * 10); /* 5 halvings lead to a line, 6 more to a pixel */
}

/* A target that fails at any line ends the frame, and the next one is whole. */
struct failing {
    struct canvas canvas;
    int calls, fail_at;
};

static void *lend_or_fail(void *ctx, uint16_t y_px)
{
    struct failing *failing = ctx;

    return failing->calls++ == failing->fail_at ? NULL : failing->canvas.pixels[y_px];
}

static int done_or_fail(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct failing *failing = ctx;

    if (failing->calls++ == failing->fail_at) return DEVICE_ERROR;
    return done(&failing->canvas, y_px, x_px, n_px);
}

static void a_target_that_fails_ends_the_frame_and_the_next_is_whole(void **state)
{
    struct random random = {74};
    struct closed_stage stage = make_closed(&random, NULL);
    const struct lim_camera camera = closed_stage_camera(&stage, &random);
    static struct canvas nearest;
    static struct failing failing;
    struct lim_target target = target_of(&failing.canvas, LIM_SCANLINE);
    struct lim lim;

    (void)state;
    target.lend = lend_or_fail;
    target.done = done_or_fail;
    void *mem = malloc(lim_mem_b(&stage.scene.scene, &target));
    assert_int_equal(lim_init(&lim, &stage.scene.scene, &target, mem, lim_mem_b(&stage.scene.scene, &target)), LIM_OK);
    (void)draw(&nearest, &core_fast, &stage.scene.scene, LIM_NEAREST_FIRST, &camera, 0);
    for (int n = 0; n < 2 * H_PX; n++) {
        failing.fail_at = n;
        failing.calls = 0;
        const int err = lim_frame(&lim, &camera);
        assert_true(err == LIM_ERR_TARGET || err == DEVICE_ERROR);
        assert_int_equal(failing.calls, n + 1);
    }
    failing.fail_at = NEVER;
    wipe(&failing.canvas);
    assert_int_equal(lim_frame(&lim, &camera), LIM_OK);
    assert_memory_equal(nearest.pixels, failing.canvas.pixels, sizeof nearest.pixels);
    free(mem);
    closed_stage_close(&stage);
}

/* Renderers of one scene by both orders, for what is asked for at run time. */
struct pair {
    struct lim_scene scene; /* with pools for scan lines, too */
    struct canvas canvas[2];
    struct lim lim[2];
    void *mem[2];
};

static struct pair *pair_new(const struct lim_scene *scene)
{
    static const enum lim_method orders[2] = {LIM_NEAREST_FIRST, LIM_SCANLINE};
    struct pair *pair = calloc(1, sizeof *pair);

    pair->scene = *scene;
    pair->scene.limits.active = (uint16_t)(2 * scene->limits.active);
    for (int i = 0; i < 2; i++) {
        const struct lim_target target = target_of(&pair->canvas[i], orders[i]);
        const size_t mem_b = lim_mem_b(&pair->scene, &target);
        pair->mem[i] = malloc(mem_b);
        assert_int_equal(lim_init(&pair->lim[i], &pair->scene, &target, pair->mem[i], mem_b), LIM_OK);
    }
    return pair;
}

/* Draws some views by both. `by_scan_lines`: the second one does so, and says it by its background. */
static void assert_pair(struct room_stage *stage, struct pair *pair, bool by_scan_lines)
{
    for (int i = 0; i < effort(FRAMES); i++) {
        const struct lim_camera camera = room_stage_view(stage, W_PX, H_PX);
        for (int k = 0; k < 2; k++) {
            wipe(&pair->canvas[k]);
            assert_int_equal(lim_frame(&pair->lim[k], &camera), LIM_OK);
            assert_done_once(&pair->canvas[k]);
        }
        assert_memory_equal(pair->canvas[0].pixels, pair->canvas[1].pixels, sizeof pair->canvas[0].pixels);
        const struct lim_stats *stats = lim_stats(&pair->lim[1]);
        assert_int_equal(!stats->gaps_max && stats->pixels_background == W_PX * H_PX, by_scan_lines);
    }
}

static void pair_free(struct pair *pair)
{
    free(pair->mem[0]);
    free(pair->mem[1]);
    free(pair);
}

static int set_up(void **state)
{
    return room_stage_set_up(state, 816);
}

static void nothing_asked_for_is_drawn_by_scan_lines(void **state)
{
    struct room_stage *stage = *state;
    struct pair *pair = pair_new(&stage->scene.scene);

    assert_pair(stage, pair, true);
    pair_free(pair);
}

static void outlines_are_drawn_nearest_first_and_polygons_by_scan_lines_again(void **state)
{
    struct room_stage *stage = *state;
    struct pair *pair = pair_new(&stage->scene.scene);

    for (int on = 1; on >= 0; on--) {
        for (int i = 0; i < 2; i++)
            lim_set_wireframe(&pair->lim[i], &(const struct lim_wireframe){.on = on});
        assert_pair(stage, pair, !on);
    }
    pair_free(pair);
}

static void smooth_edges_are_drawn_nearest_first(void **state)
{
    struct room_stage *stage = *state;
    static uint32_t sums[2][LIM_ANTIALIAS_MEM_B(W_PX) / 4 + 1];
    struct pair *pair = pair_new(&stage->scene.scene);

    for (int i = 0; i < 2; i++)
        assert_int_equal(lim_set_antialias(&pair->lim[i], sums[i], sizeof sums[i]), LIM_OK);
    assert_pair(stage, pair, false);
    for (int i = 0; i < 2; i++)
        assert_int_equal(lim_set_antialias(&pair->lim[i], NULL, 0), LIM_OK);
    assert_pair(stage, pair, true);
    pair_free(pair);
}

static void what_moves_is_left_out_and_counted(void **state)
{
    struct room_stage *stage = *state;
    static const struct lim_movers_limits limits = {.instances = 1, .depth = 1};
    static _Alignas(8) uint8_t mem[1 << 15];
    const struct lim_instance instance = {.object = &stage->scene.scene};
    struct pair *pair = pair_new(&stage->scene.scene);
    const struct lim_camera camera = room_stage_view(stage, W_PX, H_PX);

    assert_true(lim_movers_mem_b(&stage->scene.scene, &limits) <= sizeof mem);
    assert_int_equal(lim_movers_init(&pair->lim[1], mem, sizeof mem, &limits), LIM_OK);
    assert_int_equal(lim_frame(&pair->lim[0], &camera), LIM_OK);
    assert_int_equal(lim_movers_frame(&pair->lim[1], &camera, &instance, 1), LIM_OK);
    assert_int_equal(lim_stats(&pair->lim[1])->movers.left_out, 1);
    assert_memory_equal(pair->canvas[0].pixels, pair->canvas[1].pixels, sizeof pair->canvas[0].pixels);
    pair_free(pair);
}

/* A scene that says that some of it is transparent, though nothing is. */
static void transparent_scenes_are_drawn_nearest_first(void **state)
{
    struct room_stage *stage = *state;
    struct lim_scene scene = stage->scene.scene;

    scene.limits.layers = 1;
    struct pair *pair = pair_new(&scene);
    assert_pair(stage, pair, false);
    pair_free(pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rooms_are_the_same_in_every_profile),
        cmocka_unit_test(solids_are_the_same_in_every_profile),
        cmocka_unit_test(any_memory_gives_the_same_picture),
        cmocka_unit_test(a_target_that_fails_ends_the_frame_and_the_next_is_whole),
        cmocka_unit_test_setup_teardown(nothing_asked_for_is_drawn_by_scan_lines, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(outlines_are_drawn_nearest_first_and_polygons_by_scan_lines_again, set_up,
                                        room_stage_tear_down),
        cmocka_unit_test_setup_teardown(smooth_edges_are_drawn_nearest_first, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(what_moves_is_left_out_and_counted, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(transparent_scenes_are_drawn_nearest_first, set_up, room_stage_tear_down),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
