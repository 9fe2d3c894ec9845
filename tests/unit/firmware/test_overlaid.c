/* SPDX-License-Identifier: MIT
 *
 * What lies over frames: by every method, on every kind of target, with any memory, each frame is the one without it,
 * on which this test puts the same pixels. With delta output what does not change is not sent; and after errors at
 * every call the next frame is right. */
#include "colour.h"
#include "compiler/compile_mesh.h"
#include "overlay.h"
#include "rigs/cmocka_ready.h"
#include "rigs/convex_rig.h"
#include "rigs/effort.h"
#include "rigs/room_stage.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 64, H_PX = 48, RUNS = 5000, FRAMES = 16, FAILURE = -77, UNITS_PER_M = 8000 };

/* A pattern that changes with its seed; lines y0 <= y < y1 alone have it. */
struct pattern {
    struct lim_overlay overlay;
    uint32_t seed;
    bool on;
};

static bool pattern_at(const struct pattern *pattern, int x, int y, uint16_t *colour)
{
    const uint32_t at = ((uint32_t)(x / 3) * 2654435761u) ^ ((uint32_t)(y / 2) * 40503u) ^ pattern->seed;

    *colour = (uint16_t)(at >> 7);
    return (at >> 24) % 3 == 0;
}

static lim_overlay_draw draw;

static void draw(void *ctx, const struct lim_overlay_line *line)
{
    for (int x = -3; x < W_PX + 3; x++) {
        uint16_t colour;
        if (pattern_at(ctx, x < 0 ? 0 : x, line->y_px, &colour) && x >= 0) lim_overlay_fill(line, x, x + 1, colour);
    }
}

/* A display that takes whatever the renderer offers, and may fail at the n-th call. */
struct glass {
    struct lim_target target;
    _Alignas(8) uint16_t lines[H_PX][W_PX];
    uint16_t shown[H_PX][W_PX], page[8][W_PX];
    bool is_round, has_lines;
    unsigned long calls, fail_at, sent_px;
};

static bool fails(struct glass *glass)
{
    return glass->calls++ == glass->fail_at;
}

static void *lend(void *ctx, uint16_t y_px)
{
    struct glass *glass = ctx;

    return fails(glass) || !glass->has_lines ? NULL : glass->lines[y_px];
}

static int window(void *ctx, const struct lim_rect *opened)
{
    (void)opened;
    return fails(ctx) ? FAILURE : 0;
}

static void visible(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    const struct glass *glass = ctx;
    const uint16_t cut = glass->is_round ? (uint16_t)abs((int)y_px - H_PX / 2) : 0;

    *x0_px = cut;
    *x1_px = (uint16_t)(W_PX - cut);
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct glass *glass = ctx;
    const bool has_pages = glass->target.costs.page_px > 1;

    if (fails(glass)) return FAILURE;
    assert_true(y_px < H_PX && x_px + n_px <= W_PX);
    memcpy(&glass->page[y_px % 8][x_px], &glass->lines[y_px][x_px], 2u * n_px);
    for (int y = has_pages ? y_px / 8 * 8 : y_px; y <= y_px && (!has_pages || y_px % 8 == 7); y++) {
        memcpy(&glass->shown[y][x_px], &glass->page[y % 8][x_px], 2u * n_px);
        glass->sent_px += n_px;
    }
    return 0;
}

static void fill(void *of_look, uint16_t x0_px, uint16_t x1_px)
{
    const struct lim_piece_look *look = of_look;
    struct glass *glass = look->ctx;
    uint16_t x0, x1;

    visible(glass, look->y_px, &x0, &x1);
    assert_true(x0_px < x1_px && x0_px >= x0 && x1_px <= x1);
    for (int x = x0_px; x < x1_px; x++)
        glass->lines[look->y_px][x] = look->colour;
}

static int show(void *ctx)
{
    struct glass *glass = ctx;

    if (fails(glass)) return FAILURE;
    memcpy(glass->shown, glass->lines, sizeof glass->shown);
    return 0;
}

/* How frames come. */
struct way {
    enum lim_method method;
    bool round, least, delta, antialias, wireframe;
    bool framebuffer, fill, show; /* show: with fill */
    uint8_t page_px;              /* 0: none */
    unsigned runs;                /* 0: RUNS */
};

struct renderer {
    struct lim lim;
    struct glass *glass;
    void *mem, *delta_mem, *smooth_mem;
};

static void set_target(struct glass *glass, const struct way *way, bool is_plain)
{
    struct lim_target *target = &glass->target;

    glass->fail_at = ULONG_MAX;
    glass->is_round = way->round;
    glass->has_lines = is_plain || !way->fill || way->show;
    *target = (struct lim_target){
        .w_px = W_PX, .h_px = H_PX, .method = way->method, .ctx = glass, .lend = lend, .done = done, .window = window};
    target->costs = (struct lim_target_costs){.window_b = 11, .pixel_bits = 16, .page_px = 1, .x_align_px = 1};
    if (way->round) target->visible = visible;
    if (is_plain) return;
    if (way->page_px) target->costs.page_px = way->page_px;
    if (way->fill) target->fill = fill;
    if (way->show) target->show = show;
    if (way->framebuffer) target->framebuffer = (struct lim_framebuffer){glass->lines, W_PX};
}

static void renderer_init(struct renderer *renderer, const struct lim_scene *scene, const struct way *way,
                          bool is_plain)
{
    struct glass *glass = renderer->glass = calloc(1, sizeof *glass);

    set_target(glass, way, is_plain);
    const bool least = way->least && !is_plain;
    const size_t mem_b = least ? lim_mem_min_b(scene, &glass->target) : lim_mem_b(scene, &glass->target);
    const size_t delta_b = LIM_DELTA_MEM_B(W_PX, H_PX, way->runs ? way->runs : RUNS);
    renderer->mem = malloc(mem_b);
    renderer->delta_mem = malloc(delta_b);
    renderer->smooth_mem = malloc(LIM_ANTIALIAS_MEM_B(W_PX));
    assert_int_equal(lim_init(&renderer->lim, scene, &glass->target, renderer->mem, mem_b), LIM_OK);
    if (way->wireframe) lim_set_wireframe(&renderer->lim, &(const struct lim_wireframe){.on = true});
    if (way->antialias)
        assert_int_equal(lim_set_antialias(&renderer->lim, renderer->smooth_mem, LIM_ANTIALIAS_MEM_B(W_PX)), LIM_OK);
    if (way->delta && !is_plain) assert_int_equal(lim_set_delta(&renderer->lim, renderer->delta_mem, delta_b), LIM_OK);
}

static void renderer_free(struct renderer *renderer)
{
    free(renderer->mem);
    free(renderer->delta_mem);
    free(renderer->smooth_mem);
    free(renderer->glass);
}

static void assert_shown(struct glass *glass, const struct glass *plain, const struct pattern *pattern)
{
    for (int y = 0; y < H_PX; y++) {
        uint16_t x0, x1;
        visible(glass, (uint16_t)y, &x0, &x1);
        for (int x = x0; x < x1; x++) {
            uint16_t colour, ought = plain->shown[y][x];
            if (pattern->on && y >= pattern->overlay.y0_px && y < pattern->overlay.y1_px &&
                pattern_at(pattern, x, y, &colour))
                ought = lim_memory_colour(colour);
            if (glass->shown[y][x] != ought) fail_msg("%d, %d: %04x, not %04x", x, y, glass->shown[y][x], ought);
        }
    }
}

/* As it is; other pixels; other lines; gone, or there again. */
static void change(struct pattern *pattern, struct random *random)
{
    struct lim_overlay *overlay = &pattern->overlay;

    switch (random_in(random, 0, 5)) {
    case 0:
        pattern->on = !pattern->on;
        return;
    case 1:
        overlay->y0_px = (uint16_t)random_in(random, 0, H_PX);
        overlay->y1_px = (uint16_t)random_in(random, 0, 2 * H_PX);
        return;
    case 2:
    case 3:
        pattern->seed = (uint32_t)random_u64(random);
        return;
    default:
        return;
    }
}

static struct pattern pattern_new(void)
{
    return (struct pattern){.overlay = {.draw = draw, .y0_px = 5, .y1_px = 21}, .seed = 99, .on = true};
}

static void lay(struct renderer *renderer, struct pattern *pattern)
{
    pattern->overlay.ctx = pattern;
    lim_set_overlay(&renderer->lim, pattern->on ? &pattern->overlay : NULL);
}

static void assert_nothing_is_sent(struct renderer *renderer, const struct lim_camera *camera)
{
    const unsigned long sent_px = renderer->glass->sent_px;

    assert_int_equal(lim_frame(&renderer->lim, camera), LIM_OK);
    assert_int_equal(lim_stats(&renderer->lim)->delta.windows, 0);
    assert_int_equal(lim_stats(&renderer->lim)->delta.pixels, 0);
    if (renderer->glass->target.costs.page_px == 1) assert_int_equal(renderer->glass->sent_px, sent_px);
}

static void fly_in(const struct lim_scene *scene, struct room_stage *stage, struct lim_camera (*view)(void *ctx),
                   void *ctx, const struct way *way)
{
    struct renderer plain, laid;
    struct pattern pattern = pattern_new();
    struct lim_camera camera = view(ctx);
    struct random *random = &stage->random;

    renderer_init(&plain, scene, way, true);
    renderer_init(&laid, scene, way, false);
    for (int i = 0; i < effort(FRAMES); i++) {
        lay(&laid, &pattern);
        assert_int_equal(lim_frame(&plain.lim, &camera), LIM_OK);
        assert_int_equal(lim_frame(&laid.lim, &camera), LIM_OK);
        assert_shown(laid.glass, plain.glass, &pattern);
        if (way->delta && !way->runs && !way->least) assert_nothing_is_sent(&laid, &camera);
        change(&pattern, random);
        if (random_in(random, 0, 2) == 0) camera = view(ctx);
    }
    renderer_free(&plain);
    renderer_free(&laid);
}

static int set_up(void **state)
{
    return room_stage_set_up(state, 2209);
}

static struct lim_camera room_view(void *stage)
{
    return room_stage_view(stage, W_PX, H_PX);
}

static void fly(void **state, struct way way)
{
    struct room_stage *stage = *state;

    fly_in(&stage->scene.scene, stage, room_view, stage, &way);
}

static void lines_by_any_method_have_it(void **state)
{
    for (int method = LIM_NEAREST_FIRST; method <= LIM_NEWELL; method++)
        if (method != LIM_CONVEX) fly(state, (struct way){.method = (enum lim_method)method});
}

static void smooth_edges_and_outlines_have_it(void **state)
{
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .antialias = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .antialias = true, .least = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .wireframe = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .wireframe = true, .least = true});
    fly(state, (struct way){.method = LIM_PAINTER, .wireframe = true});
}

static void pieces_of_lines_have_it(void **state)
{
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .least = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .least = true, .round = true});
}

static void round_glass_has_it(void **state)
{
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .round = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .round = true, .antialias = true});
    fly(state, (struct way){.method = LIM_SCANLINE, .round = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .round = true, .framebuffer = true});
}

static void framebuffers_have_it(void **state)
{
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .framebuffer = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .framebuffer = true, .least = true});
    fly(state, (struct way){.method = LIM_PAINTER, .framebuffer = true});
    fly(state, (struct way){.method = LIM_SCANLINE, .framebuffer = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .framebuffer = true, .wireframe = true});
}

static void pictures_that_the_target_keeps_have_it(void **state)
{
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .fill = true, .show = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .fill = true, .show = true, .least = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .fill = true, .show = true, .round = true});
}

static void changes_of_it_are_sent_and_nothing_else(void **state)
{
    static const enum lim_method METHODS[] = {LIM_NEAREST_FIRST, LIM_PAINTER, LIM_SCANLINE, LIM_DEPTH, LIM_NEWELL};

    for (size_t i = 0; i < sizeof METHODS / sizeof *METHODS; i++)
        fly(state, (struct way){.method = METHODS[i], .delta = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .delta = true, .round = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .delta = true, .antialias = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .delta = true, .wireframe = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .delta = true, .page_px = 8});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .delta = true, .framebuffer = true});
    fly(state, (struct way){.method = LIM_NEAREST_FIRST, .delta = true, .fill = true, .show = true});
}

static void changes_are_right_with_any_memory(void **state)
{
    static const unsigned RUN_COUNTS[] = {1, 30, 200, 800, RUNS};

    for (size_t i = 0; i < sizeof RUN_COUNTS / sizeof *RUN_COUNTS; i++)
        for (int page_px = 0; page_px <= 8; page_px += 8)
            fly(state, (struct way){.method = LIM_NEAREST_FIRST,
                                    .delta = true,
                                    .runs = RUN_COUNTS[i],
                                    .least = i % 2,
                                    .page_px = (uint8_t)page_px});
}

/* A box that changes colour before a still scene, and is gone: its pixels, and no others. */
static void draw_box(void *ctx, const struct lim_overlay_line *line)
{
    lim_overlay_box(line, &(const struct lim_overlay_box){10, 8, 20, 6}, *(uint16_t *)ctx);
}

static void what_changed_is_the_size_of_what_is_sent(void **state)
{
    struct room_stage *stage = *state;
    struct renderer laid;
    uint16_t colour = 0xF81F;
    const struct lim_overlay overlay = {.draw = draw_box, .ctx = &colour, .y0_px = 0, .y1_px = H_PX};
    const struct lim_camera camera = room_view(stage);

    renderer_init(&laid, &stage->scene.scene, &(const struct way){.delta = true}, false);
    assert_int_equal(lim_frame(&laid.lim, &camera), LIM_OK);
    for (int i = 0; i < 4; i++, colour ^= 0x1111) {
        const unsigned long sent_px = laid.glass->sent_px;
        lim_set_overlay(&laid.lim, i == 3 ? NULL : &overlay);
        assert_int_equal(lim_frame(&laid.lim, &camera), LIM_OK);
        assert_int_equal(laid.glass->sent_px - sent_px, 20 * 6);
        assert_int_equal(lim_stats(&laid.lim)->delta.windows, 1);
    }
    renderer_free(&laid);
}

static void fail_at_every_call(struct room_stage *stage, struct way way)
{
    struct renderer plain, laid;
    struct pattern pattern = pattern_new();
    const struct lim_camera first = room_view(stage), second = room_view(stage);

    renderer_init(&plain, &stage->scene.scene, &way, true);
    renderer_init(&laid, &stage->scene.scene, &way, false);
    lay(&laid, &pattern);
    assert_int_equal(lim_frame(&plain.lim, &second), LIM_OK);
    for (unsigned long n = 0;; n++) {
        pattern.seed++;
        assert_int_equal(lim_frame(&laid.lim, &first), LIM_OK);
        laid.glass->calls = 0;
        laid.glass->fail_at = n;
        const int err = lim_frame(&laid.lim, &second);
        if (laid.glass->calls <= n) break;
        assert_true(err == FAILURE || err == LIM_ERR_TARGET);
        memset(laid.glass->shown, 0xAA, sizeof laid.glass->shown);
        assert_int_equal(lim_frame(&laid.lim, &second), LIM_OK);
        assert_shown(laid.glass, plain.glass, &pattern);
    }
    renderer_free(&plain);
    renderer_free(&laid);
}

static void the_frame_after_an_error_is_right(void **state)
{
    fail_at_every_call(*state, (struct way){.method = LIM_NEAREST_FIRST});
    fail_at_every_call(*state, (struct way){.method = LIM_PAINTER});
    fail_at_every_call(*state, (struct way){.method = LIM_NEAREST_FIRST, .delta = true});
    fail_at_every_call(*state, (struct way){.method = LIM_NEAREST_FIRST, .delta = true, .page_px = 8});
    fail_at_every_call(*state, (struct way){.method = LIM_NEAREST_FIRST, .fill = true, .show = true});
    fail_at_every_call(*state, (struct way){.method = LIM_NEAREST_FIRST, .framebuffer = true});
}

/* The second one paints into the first one's glass. */
static void join(struct renderer *first, struct renderer *second, const struct lim_scene *scene, const struct way *way)
{
    const struct lim_target *target = &first->glass->target;
    const size_t mem_b = lim_mem_b(scene, target), delta_b = LIM_DELTA_MEM_B(W_PX, H_PX, RUNS);

    assert_int_equal(lim_init(&second->lim, scene, target, second->mem, mem_b), LIM_OK);
    if (way->delta) assert_int_equal(lim_set_delta(&second->lim, first->delta_mem, delta_b), LIM_OK);
}

static void take_turns(struct room_stage *stage, struct way way)
{
    struct renderer plain, laid[2];
    struct pattern pattern = pattern_new();
    struct lim_camera camera[2];

    renderer_init(&plain, &stage->scene.scene, &way, true);
    for (int i = 0; i < 2; i++)
        renderer_init(&laid[i], &stage->scene.scene, &way, false);
    join(&laid[0], &laid[1], &stage->scene.scene, &way);
    camera[0] = room_view(stage);
    assert_int_equal(lim_frame_begin(&laid[0].lim, &camera[0]), LIM_OK);
    for (int i = 0; i < effort(2 * FRAMES); i++) {
        const int now = i % 2, next = 1 - now;
        camera[next] = room_view(stage);
        assert_int_equal(lim_frame_begin(&laid[next].lim, &camera[next]), LIM_OK);
        for (int64_t left = random_in(&stage->random, 0, 60); left && lim_frame_work(&laid[next].lim); left--)
            continue;
        lay(&laid[now], &pattern);
        assert_int_equal(lim_frame_paint(&laid[now].lim), LIM_OK);
        assert_int_equal(lim_frame(&plain.lim, &camera[now]), LIM_OK);
        assert_shown(laid[0].glass, plain.glass, &pattern);
        change(&pattern, &stage->random);
    }
    for (int i = 0; i < 2; i++)
        renderer_free(&laid[i]);
    renderer_free(&plain);
}

static void renderers_in_turns_have_it(void **state)
{
    take_turns(*state, (struct way){.method = LIM_NEAREST_FIRST});
    take_turns(*state, (struct way){.method = LIM_NEAREST_FIRST, .delta = true});
}

/* A convex solid --------------------------------------------------------------------------------------------------- */

struct solid {
    struct random *random;
    const struct compiled *scene;
    struct lens lens;
};

static struct lim_camera solid_view(void *ctx)
{
    const struct solid *solid = ctx;
    struct viewpoint viewpoint = convex_rig_viewpoint(solid->random);
    const struct camera_path path = {"overlaid", &viewpoint, 1};
    struct lim_camera camera;
    struct error err;

    if (!camera_path_to_camera(&path, 0, &solid->lens, &solid->scene->grid, &camera, &err)) fail_msg("%s", err.text);
    return camera;
}

/* By lines; by runs, where there are no lines; by runs of a picture that is kept. */
static void convex_solids_have_it(void **state)
{
    static const struct way WAYS[] = {{.method = LIM_CONVEX},
                                      {.method = LIM_CONVEX, .wireframe = true},
                                      {.method = LIM_CONVEX, .delta = true},
                                      {.method = LIM_CONVEX, .fill = true},
                                      {.method = LIM_CONVEX, .fill = true, .wireframe = true},
                                      {.method = LIM_CONVEX, .fill = true, .show = true}};
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .wireframe = true};
    struct room_stage *stage = *state;
    struct solid solid = {.random = &stage->random};
    struct mesh mesh = mesh_rig(UNITS_PER_M);
    struct compiled scene;
    struct error err;

    convex_rig_add(&mesh, &stage->random, 4);
    for (size_t i = 0; i < mesh.polygon_count; i++)
        mesh.polygons[i].colour = (uint32_t)(random_u64(&stage->random) & 0xFFFFFF);
    if (!compile_mesh(&mesh, &options, &scene, &err) || !lens_init(&solid.lens, 60, 0.1, W_PX, H_PX, &err))
        fail_msg("%s", err.text);
    solid.scene = &scene;
    for (size_t i = 0; i < sizeof WAYS / sizeof *WAYS; i++)
        fly_in(&scene.scene, stage, solid_view, &solid, &WAYS[i]);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_by_any_method_have_it),
        cmocka_unit_test(smooth_edges_and_outlines_have_it),
        cmocka_unit_test(pieces_of_lines_have_it),
        cmocka_unit_test(round_glass_has_it),
        cmocka_unit_test(framebuffers_have_it),
        cmocka_unit_test(pictures_that_the_target_keeps_have_it),
        cmocka_unit_test(changes_of_it_are_sent_and_nothing_else),
        cmocka_unit_test(changes_are_right_with_any_memory),
        cmocka_unit_test(what_changed_is_the_size_of_what_is_sent),
        cmocka_unit_test(the_frame_after_an_error_is_right),
        cmocka_unit_test(renderers_in_turns_have_it),
        cmocka_unit_test(convex_solids_have_it),
    };
    return cmocka_run_group_tests(tests, set_up, room_stage_tear_down);
}
