/* SPDX-License-Identifier: MIT
 *
 * Frames in parts: begun, worked at for a while, painted. Whatever is done of which of two frames when, each must be
 * the picture that lim_frame() draws. */
#include "compiler/compile.h"
#include "limner.h"
#include "rigs/closed_stage.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 96, H_PX = 72, SCENES = 6, TURNS = 40, RENDERERS = 2, RUNS = 3000, NEVER = -1, DEVICE_ERROR = -5 };

typedef uint16_t picture[H_PX][W_PX];

/* A panel with a picture, and what it was asked for. */
struct panel {
    picture lines, shown;
    int32_t calls, fail_at; /* lend(), window() and done() together; NEVER */
    uint32_t sent_px;
};

static void *lend(void *ctx, uint16_t y_px)
{
    struct panel *panel = ctx;

    return panel->calls++ == panel->fail_at ? NULL : panel->lines[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct panel *panel = ctx;

    if (panel->calls++ == panel->fail_at) return DEVICE_ERROR;
    assert_true(y_px < H_PX && x_px + n_px <= W_PX);
    memcpy(&panel->shown[y_px][x_px], &panel->lines[y_px][x_px], 2u * n_px);
    panel->sent_px += n_px;
    return 0;
}

static int window(void *ctx, const struct lim_rect *window)
{
    struct panel *panel = ctx;

    (void)window;
    return panel->calls++ == panel->fail_at ? DEVICE_ERROR : 0;
}

static struct lim_target target_of(struct panel *panel, enum lim_method method)
{
    return (struct lim_target){.w_px = W_PX,
                               .h_px = H_PX,
                               .format = LIM_RGB565,
                               .method = method,
                               .ctx = panel,
                               .lend = lend,
                               .done = done,
                               .window = window,
                               .costs = {.window_b = 11, .pixel_bits = 16, .page_px = 1, .x_align_px = 1}};
}

/* Two renderers of one scene that take turns, and a third that draws whole frames. */
struct stage {
    struct closed_stage in;
    struct panel panel; /* of the two */
    struct panel whole; /* of the third */
    struct lim lim[RENDERERS + 1];
    void *mem[RENDERERS + 1], *mover_mem[RENDERERS + 1];
    void *delta_mem, *smooth_mem;
    bool with_movers;
    struct random random;
};

static void stage_init(struct stage *stage, struct random *random, bool is_transparent)
{
    static const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest"};

    memset(stage, 0, sizeof *stage);
    stage->random = *random;
    stage->panel.fail_at = stage->whole.fail_at = NEVER;
    closed_stage_make(&stage->in, random);
    for (size_t i = 0; is_transparent && i < stage->in.closed.model.face_count; i += 3)
        stage->in.closed.model.faces[i].transparency = 120;
    closed_stage_compile(&stage->in, &options, W_PX, H_PX);
}

/* part_q8: of what the scene asks for, above the least. */
static void stage_start(struct stage *stage, enum lim_method method, unsigned part_q8)
{
    const struct lim_scene *scene = &stage->in.scene.scene;

    for (unsigned i = 0; i <= RENDERERS; i++) {
        const struct lim_target target = target_of(i < RENDERERS ? &stage->panel : &stage->whole, method);
        const size_t least_b = lim_mem_min_b(scene, &target), asked_b = lim_mem_b(scene, &target);
        const size_t mem_b = least_b + (asked_b - least_b) * part_q8 / 256;
        free(stage->mem[i]);
        stage->mem[i] = malloc(mem_b);
        assert_int_equal(lim_init(&stage->lim[i], scene, &target, stage->mem[i], mem_b), LIM_OK);
    }
}

static void stage_free(struct stage *stage)
{
    for (unsigned i = 0; i <= RENDERERS; i++) {
        free(stage->mem[i]);
        free(stage->mover_mem[i]);
    }
    free(stage->delta_mem);
    free(stage->smooth_mem);
    closed_stage_close(&stage->in);
}

/* What moves is the scene itself, an eighth as large, in two places. */
struct frame {
    struct lim_camera camera;
    struct lim_instance instances[2];
};

static struct frame frame_of(struct stage *stage)
{
    struct frame frame = {.camera = closed_stage_camera(&stage->in, &stage->random)};

    for (unsigned i = 0; i < 2; i++) {
        struct lim_instance *instance = &frame.instances[i];
        *instance = (struct lim_instance){.object = &stage->in.scene.scene, .finer_bits = 3};
        lim_instance_turn(instance, (uint32_t)random_u64(&stage->random), (uint32_t)random_u64(&stage->random), 0);
        for (unsigned k = 0; k < 3; k++)
            instance->at_q8[k] = (int32_t)(frame.camera.eye_q8[k] + random_in(&stage->random, -1000000, 1000000));
    }
    return frame;
}

static int draw_whole(struct stage *stage, const struct frame *frame)
{
    struct lim *lim = &stage->lim[RENDERERS];

    return stage->with_movers ? lim_movers_frame(lim, &frame->camera, frame->instances, 2)
                              : lim_frame(lim, &frame->camera);
}

static int begin(struct stage *stage, unsigned which, const struct frame *frame)
{
    struct lim *lim = &stage->lim[which];

    return stage->with_movers ? lim_movers_begin(lim, &frame->camera, frame->instances, 2)
                              : lim_frame_begin(lim, &frame->camera);
}

/* Some quanta, of which each reaches a polygon at most. Returns how many. */
static unsigned work(struct stage *stage, unsigned which, unsigned most)
{
    const int32_t calls = stage->panel.calls;
    unsigned n = 0;

    while (n < most && lim_frame_work(&stage->lim[which]))
        n++;
    assert_int_equal(stage->panel.calls, calls);
    return n;
}

static void assert_is_whole_frame(struct stage *stage, unsigned which, const struct frame *frame)
{
    assert_int_equal(lim_frame_paint(&stage->lim[which]), LIM_OK);
    assert_int_equal(draw_whole(stage, frame), LIM_OK);
    assert_memory_equal(stage->panel.shown, stage->whole.shown, sizeof(picture));
}

/* Deltas paint by gaps, each pixel once; the third renderer has none, and may paint a pixel more than once. */
static void assert_counts_are_those_of_whole_frames(const struct stage *stage, unsigned which)
{
    const struct lim_stats *is = lim_stats(&stage->lim[which]), *ought = lim_stats(&stage->lim[RENDERERS]);

    assert_int_equal(is->polygons, ought->polygons);
    assert_int_equal(is->pixels_painted,
                     stage->delta_mem ? W_PX * H_PX - is->pixels_background : ought->pixels_painted);
    assert_int_equal(is->pixels_background, ought->pixels_background);
    assert_int_equal(is->bands, ought->bands);
    assert_int_equal(is->vertices, ought->vertices);
    assert_int_equal(lim_bands(&stage->lim[which]), is->bands);
}

/* At every turn one of the renderers begins a frame, works at it, or paints it. Returns the bands of all frames. */
static uint32_t take_turns(struct stage *stage, unsigned turns)
{
    struct frame frames[RENDERERS];
    bool begun[RENDERERS] = {false, false};
    uint32_t bands = 0;

    for (unsigned t = 0; t < turns; t++) {
        const unsigned which = (unsigned)random_in(&stage->random, 0, RENDERERS - 1);
        const int what = (int)random_in(&stage->random, 0, 4);
        if (!begun[which] || what == 0) {
            frames[which] = frame_of(stage);
            assert_int_equal(begin(stage, which, &frames[which]), LIM_OK);
            begun[which] = true;
        } else if (what < 4) {
            (void)work(stage, which, (unsigned)random_in(&stage->random, 1, what == 1 ? 10000 : 20));
        } else {
            assert_is_whole_frame(stage, which, &frames[which]);
            assert_counts_are_those_of_whole_frames(stage, which);
            bands += lim_bands(&stage->lim[which]);
            begun[which] = false;
        }
    }
    return bands;
}

static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_PAINTER, LIM_DEPTH, LIM_NEWELL};

static void frames_in_parts_are_whole_frames_by_every_method_with_any_memory(void **state)
{
    struct random random = {71};
    uint32_t bands_at_least = 0;

    (void)state;
    for (int s = 0; s < effort(SCENES); s++) {
        for (unsigned m = 0; m < sizeof orders / sizeof orders[0]; m++) {
            struct stage stage;
            stage_init(&stage, &random, false);
            for (unsigned part_q8 = 0; part_q8 <= 256; part_q8 += 64) {
                stage_start(&stage, orders[m], part_q8);
                const uint32_t bands = take_turns(&stage, TURNS);
                if (part_q8 == 0) bands_at_least += bands;
            }
            stage_free(&stage);
        }
    }
    assert_true(bands_at_least > (uint32_t)effort(SCENES));
}

static void so_they_are_where_some_is_transparent(void **state)
{
    struct random random = {72};

    (void)state;
    for (int s = 0; s < effort(SCENES); s++) {
        struct stage stage;
        stage_init(&stage, &random, true);
        assert_true(stage.in.scene.scene.limits.layers > 0);
        for (unsigned part_q8 = 0; part_q8 <= 256; part_q8 += 128) {
            stage_start(&stage, LIM_NEAREST_FIRST, part_q8);
            (void)take_turns(&stage, TURNS);
        }
        stage_free(&stage);
    }
}

static void set_smooth(struct stage *stage)
{
    const size_t mem_b = LIM_ANTIALIAS_MEM_B(W_PX);

    stage->smooth_mem = malloc(2 * mem_b);
    for (unsigned i = 0; i <= RENDERERS; i++) {
        uint8_t *mem = stage->smooth_mem;
        assert_int_equal(lim_set_antialias(&stage->lim[i], mem + (i < RENDERERS ? 0 : mem_b), mem_b), LIM_OK);
    }
}

static void so_they_are_with_smooth_edges_over_one_line_of_sums(void **state)
{
    struct random random = {73};

    (void)state;
    for (unsigned part_q8 = 0; part_q8 <= 256; part_q8 += 64) {
        struct stage stage;
        stage_init(&stage, &random, false);
        stage_start(&stage, LIM_NEAREST_FIRST, part_q8);
        set_smooth(&stage);
        (void)take_turns(&stage, TURNS);
        stage_free(&stage);
    }
}

static void so_they_are_as_outlines(void **state)
{
    struct random random = {74};

    (void)state;
    for (unsigned part_q8 = 0; part_q8 <= 256; part_q8 += 128) {
        struct stage stage;
        stage_init(&stage, &random, false);
        stage_start(&stage, LIM_NEAREST_FIRST, part_q8);
        for (unsigned i = 0; i <= RENDERERS; i++)
            lim_set_wireframe(&stage.lim[i], &(struct lim_wireframe){.on = true});
        (void)take_turns(&stage, TURNS);
        stage_free(&stage);
    }
}

static void set_movers(struct stage *stage)
{
    const struct lim_scene *scene = &stage->in.scene.scene;
    const struct lim_movers_limits limits = {.instances = 2, .depth = scene->limits.depth};
    const size_t mem_b = lim_movers_mem_b(scene, &limits);

    stage->with_movers = true;
    for (unsigned i = 0; i <= RENDERERS; i++) {
        stage->mover_mem[i] = malloc(mem_b);
        assert_int_equal(lim_movers_init(&stage->lim[i], stage->mover_mem[i], mem_b, &limits), LIM_OK);
    }
}

static void so_they_are_with_what_moves(void **state)
{
    struct random random = {75};
    uint32_t seen = 0;

    (void)state;
    for (int s = 0; s < effort(SCENES); s++) {
        struct stage stage;
        stage_init(&stage, &random, false);
        stage_start(&stage, LIM_NEAREST_FIRST, s % 2 ? 256 : 20);
        set_movers(&stage);
        (void)take_turns(&stage, TURNS);
        seen += lim_stats(&stage.lim[RENDERERS])->movers.hidden < 2;
        /* A frame without them has none, though one with them was begun. */
        const struct frame frame = frame_of(&stage);
        assert_int_equal(begin(&stage, 0, &frame), LIM_OK);
        (void)work(&stage, 0, 5);
        stage.with_movers = false;
        assert_int_equal(begin(&stage, 0, &frame), LIM_OK);
        assert_is_whole_frame(&stage, 0, &frame);
        stage_free(&stage);
    }
    if (effort(SCENES) == SCENES) assert_true(seen > 0); /* else too few to count */
}

/* Two renderers that are lent one memory send together what has changed on the panel. */
static void changes_are_sent_in_turns(void **state)
{
    struct random random = {76};

    (void)state;
    for (int s = 0; s < effort(SCENES); s++) {
        struct stage stage;
        stage_init(&stage, &random, false);
        stage_start(&stage, LIM_NEAREST_FIRST, s % 2 ? 256 : 20);
        const size_t mem_b = LIM_DELTA_MEM_B(W_PX, H_PX, RUNS);
        stage.delta_mem = malloc(mem_b);
        for (unsigned i = 0; i < RENDERERS; i++)
            assert_int_equal(lim_set_delta(&stage.lim[i], stage.delta_mem, mem_b), LIM_OK);
        (void)take_turns(&stage, TURNS);
        const struct frame frame = frame_of(&stage);
        for (unsigned i = 0; i < RENDERERS; i++) {
            stage.panel.sent_px = 0;
            assert_int_equal(begin(&stage, i, &frame), LIM_OK);
            assert_is_whole_frame(&stage, i, &frame);
            assert_int_equal(lim_stats(&stage.lim[i])->delta.pixels, stage.panel.sent_px);
        }
        if (s % 2) assert_int_equal(stage.panel.sent_px, 0); /* the other renderer has shown it already */
        stage_free(&stage);
    }
}

static void a_quantum_reaches_one_polygon_at_most(void **state)
{
    struct random random = {77};
    struct stage stage;

    (void)state;
    stage_init(&stage, &random, false);
    stage_start(&stage, LIM_NEAREST_FIRST, 256);
    const struct frame frame = frame_of(&stage);
    const struct lim_stats *stats = lim_stats(&stage.lim[0]);
    assert_int_equal(begin(&stage, 0, &frame), LIM_OK);
    uint32_t polygons = 0;
    while (work(&stage, 0, 1) == 1) {
        assert_true(stats->polygons <= polygons + 1);
        polygons = stats->polygons;
    }
    assert_true(polygons > 10);
    assert_is_whole_frame(&stage, 0, &frame);
    assert_int_equal(stats->polygons, polygons); /* pass one was complete */
    stage_free(&stage);
}

static void a_target_that_fails_ends_the_frame_and_the_next_is_whole(void **state)
{
    struct random random = {78};
    struct stage stage;

    (void)state;
    stage_init(&stage, &random, false);
    stage_start(&stage, LIM_NEAREST_FIRST, 256);
    const struct frame frame = frame_of(&stage);
    for (int32_t n = 0; n < 2 * H_PX; n++) {
        assert_int_equal(begin(&stage, 0, &frame), LIM_OK);
        assert_int_equal(begin(&stage, 1, &frame), LIM_OK);
        (void)work(&stage, 0, (unsigned)n);
        (void)work(&stage, 1, 7);
        stage.panel.calls = 0;
        stage.panel.fail_at = n;
        const int err = lim_frame_paint(&stage.lim[0]);
        assert_true(err == LIM_ERR_TARGET || err == DEVICE_ERROR);
        assert_int_equal(stage.panel.calls, n + 1);
        assert_int_equal(lim_frame_paint(&stage.lim[0]), LIM_ERR_BEGIN);
        stage.panel.fail_at = NEVER;
        assert_is_whole_frame(&stage, 1, &frame);
    }
    stage_free(&stage);
}

static void cameras_out_of_range_begin_nothing(void **state)
{
    struct random random = {79};
    struct stage stage;

    (void)state;
    stage_init(&stage, &random, false);
    stage_start(&stage, LIM_NEAREST_FIRST, 256);
    const struct frame good = frame_of(&stage);
    struct frame bad = good;
    bad.camera.near_q8 = 0;
    assert_int_equal(begin(&stage, 0, &good), LIM_OK);
    assert_int_equal(begin(&stage, 0, &bad), LIM_ERR_CAMERA);
    assert_int_equal(work(&stage, 0, 1), 0);
    assert_int_equal(lim_frame_paint(&stage.lim[0]), LIM_ERR_BEGIN);
    assert_int_equal(stage.panel.calls, 0);
    assert_int_equal(begin(&stage, 0, &good), LIM_OK);
    assert_is_whole_frame(&stage, 0, &good);
    stage_free(&stage);
}

static void assert_nothing_is_begun(struct stage *stage)
{
    assert_int_equal(work(stage, 0, 1), 0);
    assert_int_equal(lim_frame_paint(&stage->lim[0]), LIM_ERR_BEGIN);
}

static void what_was_begun_is_dropped_where_frames_would_change(void **state)
{
    struct random random = {80};
    struct stage stage;

    (void)state;
    stage_init(&stage, &random, false);
    stage_start(&stage, LIM_NEAREST_FIRST, 256);
    assert_nothing_is_begun(&stage);
    const struct frame frame = frame_of(&stage);
    struct lim *lim = &stage.lim[0];
    for (unsigned how = 0; how < 5; how++) {
        assert_int_equal(begin(&stage, 0, &frame), LIM_OK);
        assert_int_equal(work(&stage, 0, 9), 9);
        if (how == 0) assert_int_equal(lim_frame(lim, &frame.camera), LIM_OK);
        if (how == 1) lim_set_wireframe(lim, &(struct lim_wireframe){.on = false});
        if (how == 2) assert_int_equal(lim_set_antialias(lim, NULL, 0), LIM_OK);
        if (how == 3) assert_int_equal(lim_set_delta(lim, NULL, 0), LIM_OK);
        if (how == 4) stage_start(&stage, LIM_NEAREST_FIRST, 256);
        assert_nothing_is_begun(&stage);
    }
    stage_free(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_in_parts_are_whole_frames_by_every_method_with_any_memory),
        cmocka_unit_test(so_they_are_where_some_is_transparent),
        cmocka_unit_test(so_they_are_with_smooth_edges_over_one_line_of_sums),
        cmocka_unit_test(so_they_are_as_outlines),
        cmocka_unit_test(so_they_are_with_what_moves),
        cmocka_unit_test(changes_are_sent_in_turns),
        cmocka_unit_test(a_quantum_reaches_one_polygon_at_most),
        cmocka_unit_test(a_target_that_fails_ends_the_frame_and_the_next_is_whole),
        cmocka_unit_test(cameras_out_of_range_begin_nothing),
        cmocka_unit_test(what_was_begun_is_dropped_where_frames_would_change),
    };

    return cmocka_run_group_tests_name("stream", tests, NULL, NULL);
}
