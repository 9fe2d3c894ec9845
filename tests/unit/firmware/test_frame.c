/* SPDX-License-Identifier: MIT
 *
 * Whole frames: both orders, any memory, failing targets, bad cameras and bad set-ups. */
#include "compiler/compile.h"
#include "limner.h"
#include "rigs/boxes.h"
#include "rigs/closed_stage.h"
#include "rigs/cmocka_ready.h"
#include "rigs/unpainted.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 120, H_PX = 90, SCENES = 8, FRAMES = 6, RUNS = 3000, NEVER = -1, DEVICE_ERROR = -5 };

/* A target in memory that watches how it is used, and fails when told to. */
struct canvas {
    uint16_t pixels[H_PX][W_PX];
    uint8_t done[H_PX][W_PX]; /* how often each pixel was final */
    int32_t calls, fail_at;   /* lend() and done() together; NEVER */
};

static void *lend(void *ctx, uint16_t y_px)
{
    struct canvas *canvas = ctx;

    assert_true(y_px < H_PX);
    return canvas->calls++ == canvas->fail_at ? NULL : canvas->pixels[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct canvas *canvas = ctx;

    if (canvas->calls++ == canvas->fail_at) return DEVICE_ERROR;
    assert_true(n_px > 0 && x_px + n_px <= W_PX);
    for (uint16_t x = x_px; x < x_px + n_px; x++)
        canvas->done[y_px][x]++;
    return 0;
}

static int window(void *ctx, const struct lim_rect *window)
{
    (void)ctx;
    (void)window;
    return 0;
}

struct stage {
    struct closed_stage in;
    struct canvas canvas;
    struct lim lim;
    void *mem, *delta_mem;
    uint16_t unpainted; /* of this colour no polygon is */
};

static struct lim_target target_of(struct stage *stage, enum lim_method method)
{
    return (struct lim_target){.w_px = W_PX,
                               .h_px = H_PX,
                               .format = LIM_RGB565,
                               .method = method,
                               .ctx = &stage->canvas,
                               .lend = lend,
                               .done = done,
                               .window = window,
                               .costs = {.window_b = 11, .pixel_bits = 16, .page_px = 1, .x_align_px = 1}};
}

static void stage_init(struct stage *stage, struct random *random)
{
    static const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest"};

    memset(stage, 0, sizeof *stage);
    closed_stage_make(&stage->in, random);
    closed_stage_compile(&stage->in, &options, W_PX, H_PX);
    stage->unpainted = unused_colour(&stage->in.scene.scene);
}

static void stage_free(struct stage *stage)
{
    free(stage->mem);
    free(stage->delta_mem);
    closed_stage_close(&stage->in);
}

/* mem_b 0: what the scene asks for. */
static void stage_start(struct stage *stage, enum lim_method method, size_t mem_b)
{
    const struct lim_target target = target_of(stage, method);

    if (!mem_b) mem_b = lim_mem_b(&stage->in.scene.scene, &target);
    free(stage->mem);
    stage->mem = malloc(mem_b);
    assert_int_equal(lim_init(&stage->lim, &stage->in.scene.scene, &target, stage->mem, mem_b), LIM_OK);
}

static void wipe(struct stage *stage)
{
    struct canvas *canvas = &stage->canvas;

    wipe_pixels(&canvas->pixels[0][0], W_PX * H_PX, stage->unpainted);
    memset(canvas->done, 0, sizeof canvas->done);
    canvas->calls = 0;
    canvas->fail_at = NEVER;
}

static void assert_every_pixel_painted_and_done_once(const struct stage *stage)
{
    const struct canvas *canvas = &stage->canvas;

    for (int y = 0; y < H_PX; y++) {
        for (int x = 0; x < W_PX; x++)
            assert_int_equal(canvas->done[y][x], 1);
    }
    assert_int_equal(count_pixels(&canvas->pixels[0][0], W_PX * H_PX, stage->unpainted), 0);
}

static void draw(struct stage *stage, const struct lim_camera *camera)
{
    wipe(stage);
    assert_int_equal(lim_frame(&stage->lim, camera), LIM_OK);
    assert_every_pixel_painted_and_done_once(stage);
}

static void nearest_first_paints_every_pixel_and_leaves_no_background(void **state)
{
    struct random random = {31};

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        struct stage stage;
        stage_init(&stage, &random);
        stage_start(&stage, LIM_NEAREST_FIRST, 0);
        for (int f = 0; f < FRAMES; f++) {
            const struct lim_camera camera = closed_stage_camera(&stage.in, &random);
            draw(&stage, &camera);
            assert_int_equal(lim_stats(&stage.lim)->pixels_background, 0);
        }
        stage_free(&stage);
    }
}

/* Where only changes are sent, lines are painted by gaps: the same picture, and no pixel twice. */
static void painted_by_gaps_each_pixel_is_painted_once(void **state)
{
    const size_t mem_b = LIM_DELTA_MEM_B(W_PX, H_PX, RUNS);
    struct random random = {37};

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        struct stage stage;
        uint16_t flat[H_PX][W_PX];
        stage_init(&stage, &random);
        stage.delta_mem = malloc(mem_b);
        for (int f = 0; f < FRAMES; f++) {
            const struct lim_camera camera = closed_stage_camera(&stage.in, &random);
            stage_start(&stage, LIM_NEAREST_FIRST, 0);
            draw(&stage, &camera);
            memcpy(flat, stage.canvas.pixels, sizeof flat);
            assert_int_equal(lim_set_delta(&stage.lim, stage.delta_mem, mem_b), LIM_OK);
            draw(&stage, &camera);
            assert_memory_equal(flat, stage.canvas.pixels, sizeof flat);
            assert_int_equal(lim_stats(&stage.lim)->pixels_painted, W_PX * H_PX);
            assert_int_equal(lim_stats(&stage.lim)->pixels_background, 0);
        }
        stage_free(&stage);
    }
}

static void the_painter_gives_the_same_picture(void **state)
{
    struct random random = {32};

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        struct stage stage;
        uint16_t nearest[H_PX][W_PX];
        stage_init(&stage, &random);
        for (int f = 0; f < FRAMES; f++) {
            const struct lim_camera camera = closed_stage_camera(&stage.in, &random);
            stage_start(&stage, LIM_NEAREST_FIRST, 0);
            draw(&stage, &camera);
            memcpy(nearest, stage.canvas.pixels, sizeof nearest);
            stage_start(&stage, LIM_PAINTER, 0);
            draw(&stage, &camera);
            assert_memory_equal(nearest, stage.canvas.pixels, sizeof nearest);
        }
        stage_free(&stage);
    }
}

/* From the least that lim_init() takes up to what the scene asks for: bands, but the same pixels. */
static void any_memory_gives_the_same_picture(void **state)
{
    struct random random = {33};
    uint32_t bands_at_least_memory = 0;

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        struct stage stage;
        uint16_t plenty[H_PX][W_PX];
        stage_init(&stage, &random);
        const struct lim_target target = target_of(&stage, LIM_NEAREST_FIRST);
        const size_t least_b = lim_mem_min_b(&stage.in.scene.scene, &target);
        const size_t asked_b = lim_mem_b(&stage.in.scene.scene, &target);
        const struct lim_camera camera = closed_stage_camera(&stage.in, &random);
        stage_start(&stage, LIM_NEAREST_FIRST, 0);
        draw(&stage, &camera);
        memcpy(plenty, stage.canvas.pixels, sizeof plenty);
        for (int part = 0; part <= 4; part++) {
            stage_start(&stage, LIM_NEAREST_FIRST, least_b + (asked_b - least_b) * (size_t)(part * part) / 64);
            draw(&stage, &camera);
            assert_memory_equal(plenty, stage.canvas.pixels, sizeof plenty);
            if (part == 0) bands_at_least_memory += lim_stats(&stage.lim)->bands;
        }
        stage_free(&stage);
    }
    assert_true(bands_at_least_memory > SCENES); /* the case is really there */
}

/* A wall, and before it slats as thin as pixels, on FENCE_LINES lines in the middle of the screen. */
enum { FENCE_LINES = 4, SLATS = 60, SLAT_M = 100 };

static void fence_init(struct stage *stage)
{
    static const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest"};
    struct model *model = &stage->in.closed.model;

    memset(stage, 0, sizeof *stage);
    boxes_add_world(model);
    for (int k = 0; k < SLATS; k++) {
        const double x_m = 2 * SLAT_M * (k - SLATS / 2);
        boxes_add_solid(model, (double[]){x_m, 0, -9800}, (double[]){x_m + SLAT_M, 400, -9700});
    }
    closed_stage_compile(&stage->in, &options, W_PX, H_PX);
    stage->unpainted = unused_colour(&stage->in.scene.scene);
}

/* The least memory holds a polygon or some gaps. Where there is but the wall that is enough for any number of lines,
 * though on those of the fence it was for a few slats. */
static void bands_that_crowded_lines_made_small_grow_again(void **state)
{
    struct viewpoint ahead = {.target_m = {0, 0, -1}, .line = 1};
    const struct camera_path path = {"fence", &ahead, 1};
    struct lim_camera camera;
    struct stage stage;
    struct error err;

    (void)state;
    fence_init(&stage);
    const struct lim_target target = target_of(&stage, LIM_NEAREST_FIRST);
    assert_true(camera_path_to_camera(&path, 0, &stage.in.lens, &stage.in.scene.grid, &camera, &err));
    stage_start(&stage, LIM_NEAREST_FIRST, lim_mem_min_b(&stage.in.scene.scene, &target));
    draw(&stage, &camera);
    print_message("# frame: %d calls, %u bands\n", stage.canvas.calls, lim_stats(&stage.lim)->bands);
    assert_in_range(stage.canvas.calls, 2 * (H_PX - FENCE_LINES + FENCE_LINES * SLATS / 6),
                    2 * (H_PX - FENCE_LINES + (FENCE_LINES + 1) * W_PX));
    stage_free(&stage);
}

static void a_target_that_fails_at_any_call_ends_the_frame_and_the_next_is_whole(void **state)
{
    static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_PAINTER, LIM_SCANLINE};
    struct random random = {34};
    struct stage stage;

    (void)state;
    stage_init(&stage, &random);
    const struct lim_camera camera = closed_stage_camera(&stage.in, &random);
    for (int m = 0; m < 3; m++) {
        uint16_t whole[H_PX][W_PX];
        stage_start(&stage, orders[m], 0);
        draw(&stage, &camera);
        memcpy(whole, stage.canvas.pixels, sizeof whole);
        const int32_t calls = stage.canvas.calls;
        assert_true(calls >= 2 * H_PX);
        for (int32_t n = 0; n < calls; n++) {
            wipe(&stage);
            stage.canvas.fail_at = n;
            const int err = lim_frame(&stage.lim, &camera);
            assert_true(err == LIM_ERR_TARGET || err == DEVICE_ERROR);
            assert_int_equal(stage.canvas.calls, n + 1); /* nothing is asked of it afterwards */
        }
        draw(&stage, &camera);
        assert_memory_equal(whole, stage.canvas.pixels, sizeof whole);
    }
    stage_free(&stage);
}

static void cameras_out_of_range_are_refused(void **state)
{
    struct random random = {35};
    struct stage stage;

    (void)state;
    stage_init(&stage, &random);
    stage_start(&stage, LIM_NEAREST_FIRST, 0);
    const struct lim_camera good = closed_stage_camera(&stage.in, &random);
    struct lim_camera bad[7] = {good, good, good, good, good, good, good};
    bad[0].eye_q8[1] = INT32_C(1) << 28;
    bad[1].eye_q8[2] = -(INT32_C(1) << 28);
    bad[2].tan_x_q28 = LIM_TAN_MAX_Q28 + 1;
    bad[3].tan_y_q28 = LIM_TAN_MIN_Q28 - 1;
    bad[4].near_q8 = 0;
    bad[5].near_q8 = LIM_NEAR_MAX_Q8 + 1;
    bad[6].eye_q8[0] = INT32_MIN;
    for (int i = 0; i < 7; i++) {
        wipe(&stage);
        assert_int_equal(lim_frame(&stage.lim, &bad[i]), LIM_ERR_CAMERA);
        assert_int_equal(stage.canvas.calls, 0);
    }
    draw(&stage, &good);
    stage_free(&stage);
}

static void set_ups_that_cannot_work_are_refused(void **state)
{
    enum { BAD = 8 };
    struct random random = {36};
    struct stage stage;

    (void)state;
    stage_init(&stage, &random);
    struct lim_scene scene = stage.in.scene.scene;
    const struct lim_target good = target_of(&stage, LIM_NEAREST_FIRST);
    const size_t least_b = lim_mem_min_b(&scene, &good);
    void *mem = malloc(least_b);
    struct lim_target bad[BAD];
    for (int i = 0; i < BAD; i++)
        bad[i] = good;
    bad[0].w_px = 0;
    bad[1].h_px = LIM_MAX_SIDE_PX + 1;
    bad[2].lend = NULL;
    bad[3].format = (enum lim_format)77;
    bad[4].w_px = LIM_MAX_SIDE_PX + 1;
    bad[5].h_px = 0;
    bad[6].done = NULL;
    bad[7].method = (enum lim_method)77;
    for (int i = 0; i < BAD; i++)
        assert_int_equal(lim_init(&stage.lim, &scene, &bad[i], mem, least_b), LIM_ERR_TARGET);
    assert_int_equal(lim_init(&stage.lim, &scene, &good, mem, least_b - 1), LIM_ERR_MEMORY);
    assert_int_equal(lim_init(&stage.lim, &scene, &good, mem, least_b), LIM_OK);
    scene.limits.vertices = LIM_MAX_VERTICES + 1;
    assert_int_equal(lim_init(&stage.lim, &scene, &good, mem, least_b), LIM_ERR_SCENE);
    free(mem);
    stage_free(&stage);
}

static int init_with_the_least(struct lim *lim, const struct lim_scene *scene, const struct lim_target *target)
{
    const size_t mem_b = lim_mem_min_b(scene, target) + 4;
    void *mem = malloc(mem_b);

    assert_non_null(mem);
    const int err = lim_init(lim, scene, target, mem, mem_b);
    free(mem);
    return err;
}

/* At each bound, and one beyond. */
static void set_ups_at_the_bounds_work(void **state)
{
    static const uint16_t sides_px[] = {1, LIM_MAX_SIDE_PX};
    static const struct lim_node node = {{LIM_PLANE_X, 5}, LIM_NO_INDEX, LIM_NO_INDEX, 0, LIM_NO_INDEX, LIM_NO_INDEX};
    struct lim_scene scene = {.nodes = &node, .node_count = 1, .limits = {.depth = 1, .vertices = LIM_MAX_VERTICES}};
    static struct stage stage;

    (void)state;
    struct lim_target target = target_of(&stage, LIM_NEAREST_FIRST);
    for (int i = 0; i < 4; i++) {
        target.w_px = sides_px[i & 1];
        target.h_px = sides_px[i >> 1];
        assert_int_equal(init_with_the_least(&stage.lim, &scene, &target), LIM_OK);
    }
    target = target_of(&stage, LIM_NEWELL);
    scene.polygon_count = LIM_SORTED_MAX;
    assert_int_equal(init_with_the_least(&stage.lim, &scene, &target), LIM_OK);
    scene.polygon_count++;
    assert_int_equal(init_with_the_least(&stage.lim, &scene, &target), LIM_ERR_SCENE);
    target.method = LIM_PAINTER;
    assert_int_equal(init_with_the_least(&stage.lim, &scene, &target), LIM_OK);
    target.method = LIM_CONVEX;
    scene.polygon_count = LIM_NONE - 1;
    assert_int_equal(init_with_the_least(&stage.lim, &scene, &target), LIM_OK);
    scene.polygon_count++;
    assert_int_equal(init_with_the_least(&stage.lim, &scene, &target), LIM_ERR_SCENE);
}

/* What is convex has a tree without forks, of as many levels as nodes, each of them a face. */
static void trees_that_are_not_of_something_convex_are_refused(void **state)
{
    static const struct lim_node face = {{LIM_PLANE_X, 5}, 1, LIM_NO_INDEX, LIM_NO_INDEX, LIM_NO_INDEX, LIM_NO_INDEX};
    static const struct lim_node leaf = {{LIM_NO_INDEX, 0}, LIM_NO_INDEX, LIM_NO_INDEX,
                                         LIM_NO_INDEX,      LIM_NO_INDEX, LIM_NO_INDEX};
    struct random random = {418};
    struct stage stage;

    (void)state;
    stage_init(&stage, &random);
    const struct lim_target target = target_of(&stage, LIM_CONVEX);
    for (int kind = 0; kind < 3; kind++) {
        const struct lim_node nodes[2] = {face, kind == 1 ? leaf : face};
        const struct lim_scene scene = {
            .nodes = nodes, .node_count = 2, .limits = {.depth = kind == 2 ? 1 : 2, .vertices = 4, .active = 2}};
        const size_t mem_b = lim_mem_b(&scene, &target);
        void *mem = malloc(mem_b + 4);
        assert_non_null(mem);
        assert_int_equal(lim_init(&stage.lim, &scene, &target, mem, mem_b + 4), kind ? LIM_ERR_SCENE : LIM_OK);
        free(mem);
    }
    stage_free(&stage);
}

/* As on round glass, and nothing of each seventh line. */
static void find_visible(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    const int from_middle = y_px < H_PX / 2 ? H_PX / 2 - y_px : y_px - H_PX / 2;

    (void)ctx;
    *x0_px = (uint16_t)(y_px % 7 ? from_middle : W_PX / 2);
    *x1_px = (uint16_t)(y_px % 7 ? W_PX - from_middle / 2 : W_PX / 2);
}

static int done_or_nothing(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    return n_px ? done(ctx, y_px, x_px, n_px) : 0;
}

static void what_is_not_visible_is_not_painted(void **state)
{
    static uint16_t whole[H_PX][W_PX];
    struct random random = {417};
    struct stage stage;

    (void)state;
    stage_init(&stage, &random);
    struct lim_target target = target_of(&stage, LIM_NEAREST_FIRST);
    const size_t least_b = lim_mem_min_b(&stage.in.scene.scene, &target),
                 most_b = lim_mem_b(&stage.in.scene.scene, &target);
    target.visible = find_visible;
    target.done = done_or_nothing;
    for (int f = 0; f < 2 * FRAMES; f++) {
        const struct lim_camera camera = closed_stage_camera(&stage.in, &random);
        const size_t mem_b = f & 1 ? (size_t)random_in(&random, (int64_t)least_b, (int64_t)most_b) : most_b;
        stage_start(&stage, LIM_NEAREST_FIRST, 0);
        wipe(&stage);
        assert_int_equal(lim_frame(&stage.lim, &camera), LIM_OK);
        memcpy(whole, stage.canvas.pixels, sizeof whole);
        assert_int_equal(lim_init(&stage.lim, &stage.in.scene.scene, &target, stage.mem, mem_b), LIM_OK);
        wipe(&stage);
        assert_int_equal(lim_frame(&stage.lim, &camera), LIM_OK);
        for (uint16_t y = 0; y < H_PX; y++)
            for (uint16_t x = 0; x < W_PX; x++) {
                uint16_t x0, x1;
                find_visible(NULL, y, &x0, &x1);
                const bool is_seen = x >= x0 && x < x1;
                assert_int_equal(stage.canvas.done[y][x], is_seen);
                assert_int_equal(stage.canvas.pixels[y][x], is_seen ? whole[y][x] : stage.unpainted);
            }
    }
    stage_free(&stage);
}

/* Nor for what a target returns of its own, an errno. */
static void errors_are_not_taken_for_others(void **state)
{
    static const int errors[] = {LIM_OK, LIM_ERR_MEMORY, LIM_ERR_SCENE, LIM_ERR_TARGET, LIM_ERR_CAMERA, LIM_ERR_BEGIN};

    (void)state;
    for (int i = 1; i < 6; i++) {
        assert_true(errors[i] < -1000);
        for (int k = 0; k < i; k++)
            assert_int_not_equal(errors[i], errors[k]);
    }
}

/* Of whatever bytes a renderer's memory is made: nothing is on that was not asked for, and nothing has begun. */
static void what_memory_held_before_does_not_matter(void **state)
{
    static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_PAINTER};
    static const int before[] = {0, 1, 0xA5, 0xFF};
    static uint16_t first[H_PX][W_PX];
    struct random random = {416};
    struct stage stage;

    (void)state;
    stage_init(&stage, &random);
    const struct lim_camera camera = closed_stage_camera(&stage.in, &random);
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < 4; k++) {
            memset(&stage.lim, before[k], sizeof stage.lim);
            stage_start(&stage, orders[m], 0);
            assert_int_equal(lim_bands(&stage.lim), 0);
            assert_false(lim_frame_work(&stage.lim));
            assert_int_equal(lim_frame_paint(&stage.lim), LIM_ERR_BEGIN);
            wipe(&stage);
            assert_int_equal(lim_frame(&stage.lim, &camera), LIM_OK);
            assert_every_pixel_painted_and_done_once(&stage);
            if (!m && !k) memcpy(first, stage.canvas.pixels, sizeof first);
            assert_memory_equal(first, stage.canvas.pixels, sizeof first);
        }
    stage_free(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nearest_first_paints_every_pixel_and_leaves_no_background),
        cmocka_unit_test(painted_by_gaps_each_pixel_is_painted_once),
        cmocka_unit_test(the_painter_gives_the_same_picture),
        cmocka_unit_test(any_memory_gives_the_same_picture),
        cmocka_unit_test(bands_that_crowded_lines_made_small_grow_again),
        cmocka_unit_test(a_target_that_fails_at_any_call_ends_the_frame_and_the_next_is_whole),
        cmocka_unit_test(cameras_out_of_range_are_refused),
        cmocka_unit_test(set_ups_that_cannot_work_are_refused),
        cmocka_unit_test(set_ups_at_the_bounds_work),
        cmocka_unit_test(trees_that_are_not_of_something_convex_are_refused),
        cmocka_unit_test(what_is_not_visible_is_not_painted),
        cmocka_unit_test(errors_are_not_taken_for_others),
        cmocka_unit_test(what_memory_held_before_does_not_matter),
    };

    return cmocka_run_group_tests_name("frame", tests, NULL, NULL);
}
