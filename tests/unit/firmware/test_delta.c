/* SPDX-License-Identifier: MIT
 *
 * Delta output into a panel made of paper, which takes what the target promised and nothing else: windows where they
 * are allowed, pixels in their order. After each frame it shows what a whole frame shows: with any memory, costs,
 * alignment, pages, round glass, pools that run out; after errors at every call; after a refresh. */
#include "rigs/cmocka_ready.h"
#include "rigs/room_stage.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 64, H_PX = 48, RUNS = 3000, FAILURE = -77 };

struct paper {
    struct lim_target target;
    _Alignas(8) uint16_t lines[H_PX][W_PX];
    uint16_t shown[H_PX][W_PX];
    uint16_t page[8][W_PX]; /* with pages: what was taken in */
    struct lim_rect window;
    uint16_t x, y; /* the window's next pixel */
    bool free;     /* lines come in pieces, without a window */
    bool round;
    uint16_t off_px; /* of the round glass to the right, of its middle */
    unsigned long sent_px, windows, calls, fail_at;
};

static bool fails(struct paper *paper)
{
    return paper->calls++ == paper->fail_at;
}

static void *lend(void *ctx, uint16_t y_px)
{
    struct paper *paper = ctx;

    assert_true(y_px < H_PX);
    return fails(paper) ? NULL : paper->lines[y_px];
}

static int window(void *ctx, const struct lim_rect *opened)
{
    struct paper *paper = ctx;
    const uint16_t align = paper->target.costs.x_align_px;

    if (fails(paper)) return FAILURE;
    paper->free = !opened;
    if (!opened) return 0;
    assert_true(opened->x0 < opened->x1 && opened->x1 <= W_PX && opened->y0 < opened->y1 && opened->y1 <= H_PX);
    assert_true(opened->x0 % align == 0 && (opened->x1 % align == 0 || opened->x1 == W_PX));
    assert_int_equal(paper->target.costs.page_px, 1);
    paper->window = *opened;
    paper->x = opened->x0;
    paper->y = opened->y0;
    paper->windows++;
    return 0;
}

static void show(struct paper *paper, uint16_t y, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    memcpy(&paper->shown[y][x_px], &pixels[x_px], 2 * (size_t)n_px);
    paper->sent_px += n_px;
}

/* The last of eight lines sends them all, as far as it reaches. */
static void take_page(struct paper *paper, uint16_t y, uint16_t x_px, uint16_t n_px)
{
    memcpy(&paper->page[y % 8][x_px], &paper->lines[y][x_px], 2 * (size_t)n_px);
    for (uint16_t k = 0; k < 8 && y % 8 == 7; k++)
        show(paper, (uint16_t)(y - 7 + k), paper->page[k], x_px, n_px);
}

static void visible(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    const struct paper *paper = ctx;
    const uint16_t cut = paper->round ? (uint16_t)abs((int)y_px - H_PX / 2) : 0, off_px = paper->off_px;

    *x0_px = (uint16_t)(cut + off_px < W_PX ? cut + off_px : W_PX);
    *x1_px = (uint16_t)(W_PX - cut < *x0_px ? *x0_px : W_PX - cut);
}

/* Pixels that share bytes, of which the last ones may come with the next piece. */
static void take_piece(struct paper *paper, uint16_t y, uint16_t x_px, uint16_t n_px)
{
    const uint16_t align = paper->target.costs.x_align_px;
    const uint16_t from = (uint16_t)(x_px / align * align);
    uint16_t x0, x1, end = (uint16_t)(x_px + n_px);

    visible(paper, y, &x0, &x1);
    if (end < x1) end = (uint16_t)(end / align * align);
    memcpy(&paper->page[0][x_px], &paper->lines[y][x_px], 2 * (size_t)n_px);
    if (n_px > 0 && from < end) show(paper, y, paper->page[0], from, (uint16_t)(end - from));
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct paper *paper = ctx;

    if (fails(paper)) return FAILURE;
    assert_true(y_px < H_PX && x_px + n_px <= W_PX);
    if (paper->target.costs.page_px > 1) {
        take_page(paper, y_px, x_px, n_px);
        return 0;
    }
    if (paper->free) {
        take_piece(paper, y_px, x_px, n_px);
        return 0;
    }
    memset(paper->page[0], 0, sizeof paper->page[0]); /* what shares bytes with pieces is sent between none of them */
    assert_true(y_px == paper->y && x_px == paper->x && x_px + n_px <= paper->window.x1 && y_px < paper->window.y1);
    show(paper, y_px, paper->lines[y_px], x_px, n_px);
    paper->x = (uint16_t)(paper->x + n_px);
    if (paper->x < paper->window.x1) return 0;
    paper->x = paper->window.x0;
    paper->y++;
    return 0;
}

static struct paper *paper_new(enum lim_method method, bool round)
{
    struct paper *paper = calloc(1, sizeof *paper);

    paper->round = round;
    paper->fail_at = ULONG_MAX;
    paper->target = (struct lim_target){.w_px = W_PX,
                                        .h_px = H_PX,
                                        .format = LIM_RGB565,
                                        .method = method,
                                        .ctx = paper,
                                        .lend = lend,
                                        .done = done,
                                        .visible = round ? visible : NULL,
                                        .window = window,
                                        .costs = {.window_b = 11, .pixel_bits = 16, .page_px = 1, .x_align_px = 1}};
    return paper;
}

/* A renderer, its paper, and all that it borrows. */
struct renderer {
    struct lim lim;
    struct paper *paper;
    void *mem, *delta_mem;
};

static void renderer_init(struct renderer *renderer, const struct lim_scene *scene, struct paper *paper, bool least)
{
    const size_t mem_b = least ? lim_mem_min_b(scene, &paper->target) : lim_mem_b(scene, &paper->target);

    *renderer = (struct renderer){.paper = paper, .mem = malloc(mem_b)};
    assert_int_equal(lim_init(&renderer->lim, scene, &paper->target, renderer->mem, mem_b), LIM_OK);
}

static void send_changes(struct renderer *renderer, unsigned runs)
{
    const size_t mem_b = LIM_DELTA_MEM_B(W_PX, H_PX, runs);

    renderer->delta_mem = malloc(mem_b);
    assert_int_equal(lim_set_delta(&renderer->lim, renderer->delta_mem, mem_b), LIM_OK);
}

static void renderer_free(struct renderer *renderer)
{
    free(renderer->mem);
    free(renderer->delta_mem);
    free(renderer->paper);
}

static void assert_same(const struct paper *is, const struct paper *ought)
{
    for (uint16_t y = 0; y < H_PX; y++) {
        uint16_t x0, x1;
        visible((void *)(uintptr_t)is, y, &x0, &x1);
        assert_memory_equal(&is->shown[y][x0], &ought->shown[y][x0], 2 * (size_t)(x1 - x0));
    }
}

/* What a whole frame shows: never in a window, so without delta output none is asked for. */
static void draw_whole(struct renderer *whole, const struct lim_camera *camera)
{
    whole->paper->window = (struct lim_rect){0, 0, W_PX, H_PX};
    whole->paper->x = whole->paper->y = 0;
    whole->paper->free = false;
    assert_int_equal(lim_frame(&whole->lim, camera), LIM_OK);
}

static int set_up(void **state)
{
    return room_stage_set_up(state, 4711);
}

static struct lim_camera view(struct room_stage *stage)
{
    return room_stage_view(stage, W_PX, H_PX);
}

/* Stays, turns a little, or is elsewhere. */
static void move(struct room_stage *f, struct lim_camera *camera)
{
    switch (random_in(&f->random, 0, 5)) {
    case 0:
        return;
    case 1:
        *camera = view(f);
        return;
    default:
        camera->yaw += (uint32_t)random_in(&f->random, -(1 << 24), 1 << 24);
    }
}

static void fly_over(struct room_stage *f, struct paper *paper, bool least, unsigned runs)
{
    struct renderer whole, changes;
    struct lim_camera camera = view(f);
    const struct lim_scene *scene = &f->scene.scene;

    renderer_init(&whole, scene, paper_new(paper->target.method, false), false);
    renderer_init(&changes, scene, paper, least);
    send_changes(&changes, runs);
    for (int i = 0; i < 12; i++) {
        draw_whole(&whole, &camera);
        assert_int_equal(lim_frame(&changes.lim, &camera), LIM_OK);
        assert_same(paper, whole.paper);
        move(f, &camera);
    }
    renderer_free(&whole);
    renderer_free(&changes);
}

static void fly(struct room_stage *f, enum lim_method method, bool round, bool least,
                const struct lim_target_costs *costs, unsigned runs)
{
    struct paper *paper = paper_new(method, round);

    if (costs) paper->target.costs = *costs;
    fly_over(f, paper, least, runs);
}

static void any_memory_shows_whole_frames(void **state)
{
    static const unsigned memories[] = {1, 2, 40, 300, 1000, RUNS};

    for (size_t i = 0; i < sizeof memories / sizeof memories[0]; i++)
        fly(*state, LIM_NEAREST_FIRST, false, false, NULL, memories[i]);
}

static void any_method_shows_whole_frames(void **state)
{
    fly(*state, LIM_PAINTER, false, false, NULL, RUNS);
    fly(*state, LIM_SCANLINE, false, false, NULL, RUNS);
    fly(*state, LIM_SCANLINE, true, true, NULL, RUNS);
    fly(*state, LIM_DEPTH, false, false, NULL, RUNS);
    fly(*state, LIM_NEWELL, false, false, NULL, RUNS);
}

/* Bands of lines, of half lines, of pixels. */
static void frames_in_pieces_are_shown_whole(void **state)
{
    fly(*state, LIM_NEAREST_FIRST, false, true, NULL, RUNS);
    fly(*state, LIM_NEAREST_FIRST, true, true, NULL, RUNS);
    fly(*state, LIM_NEAREST_FIRST, false, true, &(struct lim_target_costs){3, 8, 8, 1}, RUNS);
    fly(*state, LIM_NEAREST_FIRST, true, true, &(struct lim_target_costs){3, 8, 8, 1}, RUNS);
}

/* Where what is seen of a line is all in its last piece, or nothing of it is; other lines' runs are not touched, also
 * where there is no room to spare. */
static void pieces_that_are_not_seen_are_no_lines(void **state)
{
    for (uint16_t off_px = 1; off_px <= W_PX; off_px = (uint16_t)(off_px + 3)) {
        struct paper *paper = paper_new(LIM_NEAREST_FIRST, true);
        paper->off_px = off_px;
        fly_over(*state, paper, true, off_px % 2 ? RUNS : 60u + off_px);
    }
}

/* A window would begin where the target cannot, and what is between two pieces would be lost with the first one. */
static void pieces_that_share_bytes_are_shown_whole(void **state)
{
    static const uint16_t aligns_px[] = {2, 8, W_PX};

    for (size_t i = 0; i < sizeof aligns_px / sizeof aligns_px[0]; i++) {
        fly(*state, LIM_NEAREST_FIRST, false, true, &(struct lim_target_costs){2, 4, 1, aligns_px[i]}, RUNS);
        for (uint16_t off_px = 0; off_px < 24; off_px = (uint16_t)(off_px + 5)) {
            struct paper *paper = paper_new(LIM_NEAREST_FIRST, true);
            paper->target.costs = (struct lim_target_costs){2, 4, 1, aligns_px[i]};
            paper->off_px = off_px;
            fly_over(*state, paper, true, RUNS);
        }
    }
}

static void any_costs_show_whole_frames(void **state)
{
    for (uint16_t window_b = 0; window_b < 2000; window_b = (uint16_t)(window_b * 3 + 1))
        fly(*state, LIM_NEAREST_FIRST, false, false, &(struct lim_target_costs){window_b, 12, 1, 2}, RUNS);
    fly(*state, LIM_NEAREST_FIRST, false, false, &(struct lim_target_costs){2, 1, 1, W_PX}, RUNS);
    fly(*state, LIM_NEAREST_FIRST, false, false, &(struct lim_target_costs){3, 8, 8, 1}, RUNS);
    fly(*state, LIM_NEAREST_FIRST, false, false, &(struct lim_target_costs){3, 8, 8, 1}, 100);
    fly(*state, LIM_PAINTER, false, false, &(struct lim_target_costs){3, 8, 8, 1}, RUNS);
}

static void round_glass_shows_whole_frames(void **state)
{
    fly(*state, LIM_NEAREST_FIRST, true, false, NULL, RUNS);
    fly(*state, LIM_NEAREST_FIRST, true, false, NULL, 200);
    fly(*state, LIM_PAINTER, true, false, NULL, RUNS);
}

static void a_still_view_sends_nothing_and_a_refresh_all(void **state)
{
    struct room_stage *f = *state;
    struct renderer changes;
    const struct lim_camera camera = view(f);

    renderer_init(&changes, &f->scene.scene, paper_new(LIM_NEAREST_FIRST, false), false);
    send_changes(&changes, RUNS);
    struct paper *paper = changes.paper;
    for (int i = 0; i < 2; i++) {
        assert_int_equal(lim_frame(&changes.lim, &camera), LIM_OK);
        assert_int_equal(paper->sent_px, W_PX * H_PX);
        assert_int_equal(paper->windows, 1);
        assert_int_equal(lim_frame(&changes.lim, &camera), LIM_OK);
        assert_int_equal(paper->sent_px, W_PX * H_PX);
        assert_int_equal(lim_stats(&changes.lim)->delta.pixels, 0);
        paper->sent_px = paper->windows = 0;
        lim_refresh(&changes.lim);
    }
    assert_int_equal(lim_set_delta(&changes.lim, NULL, 0), LIM_OK);
    draw_whole(&changes, &camera);
    assert_int_equal(paper->sent_px, W_PX * H_PX);
    assert_int_equal(paper->windows, 0);
    renderer_free(&changes);
}

/* Whichever call fails: its code comes out, no other call follows, and the next frame is whole. */
static void the_frame_after_an_error_is_whole(void **state)
{
    struct room_stage *f = *state;
    struct renderer whole, changes;
    const struct lim_camera first = view(f), second = view(f);

    renderer_init(&whole, &f->scene.scene, paper_new(LIM_NEAREST_FIRST, false), false);
    renderer_init(&changes, &f->scene.scene, paper_new(LIM_NEAREST_FIRST, false), false);
    send_changes(&changes, RUNS);
    struct paper *paper = changes.paper;
    for (unsigned long n = 0;; n++) {
        assert_int_equal(lim_frame(&changes.lim, &first), LIM_OK);
        paper->calls = 0;
        paper->fail_at = n;
        const int err = lim_frame(&changes.lim, &second);
        if (paper->calls <= n) {
            assert_true(n > 50);
            assert_int_equal(err, 0);
            break;
        }
        assert_true(err == FAILURE || err == LIM_ERR_TARGET);
        assert_int_equal(paper->calls, n + 1);
        memset(paper->shown, 0xAA, sizeof paper->shown); /* whatever the panel shows now */
        draw_whole(&whole, &second);
        assert_int_equal(lim_frame(&changes.lim, &second), LIM_OK);
        assert_same(paper, whole.paper);
    }
    renderer_free(&whole);
    renderer_free(&changes);
}

static void what_it_cannot_use_is_refused(void **state)
{
    struct room_stage *f = *state;
    struct renderer renderer;
    _Alignas(8) static uint8_t mem[LIM_DELTA_MEM_B(W_PX, H_PX, 1)];
    struct paper *paper = paper_new(LIM_NEAREST_FIRST, false);

    renderer_init(&renderer, &f->scene.scene, paper, false);
    assert_int_equal(lim_set_delta(&renderer.lim, mem, sizeof mem - 4), LIM_ERR_MEMORY);
    assert_int_equal(lim_set_delta(&renderer.lim, mem, sizeof mem), LIM_OK);
    free(renderer.mem);
    paper->target.window = NULL;
    renderer_init(&renderer, &f->scene.scene, paper, false);
    assert_int_equal(lim_set_delta(&renderer.lim, mem, sizeof mem), LIM_ERR_TARGET);
    free(renderer.mem);
    paper->target.window = window;
    paper->target.costs.page_px = 0;
    renderer_init(&renderer, &f->scene.scene, paper, false);
    assert_int_equal(lim_set_delta(&renderer.lim, mem, sizeof mem), LIM_ERR_TARGET);
    renderer_free(&renderer);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_memory_shows_whole_frames),
        cmocka_unit_test(any_method_shows_whole_frames),
        cmocka_unit_test(frames_in_pieces_are_shown_whole),
        cmocka_unit_test(pieces_that_are_not_seen_are_no_lines),
        cmocka_unit_test(pieces_that_share_bytes_are_shown_whole),
        cmocka_unit_test(any_costs_show_whole_frames),
        cmocka_unit_test(round_glass_shows_whole_frames),
        cmocka_unit_test(a_still_view_sends_nothing_and_a_refresh_all),
        cmocka_unit_test(the_frame_after_an_error_is_whole),
        cmocka_unit_test(what_it_cannot_use_is_refused),
    };
    return cmocka_run_group_tests(tests, set_up, room_stage_tear_down);
}
