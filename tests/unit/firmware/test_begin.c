/* SPDX-License-Identifier: MIT
 *
 * A display that takes its pixels from a function gets the pictures that a target with all its lines in memory has:
 * each pixel once, from the top down and from left to right, whatever the memory of its lines and pools. */
#include "rigs/cmocka_ready.h"
#include "rigs/plain_lines.h"
#include "rigs/room_stage.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 63, H_PX = 48, POOLS_B = 200000, VIEWS = 12, FAILURE = -77 };

LIM_MEMORY(one_line, W_PX, H_PX, POOLS_B, 0, 1);
LIM_MEMORY(all_lines, W_PX, H_PX, POOLS_B, 1000, H_PX);

/* What arrived. */
struct glass {
    uint16_t picture[H_PX][W_PX];
    unsigned next; /* pixel of the frame */
    unsigned pieces, fails_at;
};

static int put(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    struct glass *glass = ctx;

    if (++glass->pieces == glass->fails_at) return FAILURE;
    assert_int_equal(y_px * W_PX + x_px, glass->next);
    assert_true(x_px + n_px <= W_PX);
    memcpy(&glass->picture[y_px][x_px], pixels, n_px * sizeof *pixels);
    glass->next += n_px;
    return 0;
}

/* The same scene and cameras, on a target of this test's rigs. */
struct reference {
    struct lim lim;
    struct plain_lines lines;
    uint16_t picture[H_PX][W_PX + 1];
    void *pools;
};

static struct reference *reference_new(const struct lim_scene *scene)
{
    struct reference *reference = calloc(1, sizeof *reference);

    reference->lines = (struct plain_lines){reference->picture[0], W_PX + 1};
    const struct lim_target target = plain_lines_target(&reference->lines, W_PX, H_PX, LIM_NEAREST_FIRST);
    const size_t pools_b = lim_mem_b(scene, &target);
    reference->pools = malloc(pools_b);
    assert_int_equal(lim_init(&reference->lim, scene, &target, reference->pools, pools_b), LIM_OK);
    return reference;
}

static void reference_free(struct reference *reference)
{
    free(reference->pools);
    free(reference);
}

static struct glass glass;

static void assert_same_frames(struct room_stage *stage, struct lim *lim)
{
    struct reference *reference = reference_new(&stage->scene.scene);

    for (int i = 0; i < VIEWS; i++) {
        const struct lim_camera camera = room_stage_view(stage, W_PX, H_PX);
        memset(&glass, 0x33, sizeof glass.picture);
        glass.next = 0;
        assert_int_equal(lim_frame(&reference->lim, &camera), LIM_OK);
        assert_int_equal(lim_frame(lim, &camera), LIM_OK);
        assert_int_equal(glass.next, W_PX * H_PX);
        for (int y = 0; y < H_PX; y++)
            assert_memory_equal(glass.picture[y], reference->picture[y], sizeof glass.picture[y]);
    }
    reference_free(reference);
}

static const struct lim_scene *scene_of(void **state)
{
    return &((struct room_stage *)*state)->scene.scene;
}

static void one_line_does_for_all(void **state)
{
    glass.fails_at = 0;
    assert_int_equal(lim_begin(&one_line, scene_of(state), LIM_NEAREST_FIRST, put, &glass), LIM_OK);
    assert_same_frames(*state, one_line.lim);
}

static void all_lines_are_a_framebuffer(void **state)
{
    static const enum lim_method METHODS[] = {LIM_NEAREST_FIRST, LIM_PAINTER, LIM_SCANLINE};

    for (size_t m = 0; m < sizeof METHODS / sizeof *METHODS; m++) {
        assert_int_equal(lim_begin(&all_lines, scene_of(state), METHODS[m], put, &glass), LIM_OK);
        assert_same_frames(*state, all_lines.lim);
    }
}

static void nearest_first_paints_into_it_at_once(void **state)
{
    const struct lim_camera camera = room_stage_view(*state, W_PX, H_PX);

    assert_int_equal(lim_begin(&all_lines, scene_of(state), LIM_NEAREST_FIRST, put, &glass), LIM_OK);
    glass.pieces = glass.next = 0;
    assert_int_equal(lim_frame(all_lines.lim, &camera), LIM_OK);
    assert_int_equal(glass.pieces, H_PX);
    assert_int_equal(lim_stats(all_lines.lim)->retained_cells_max, 0);
}

static void scarce_pools_send_pieces(void **state)
{
    struct lim_memory scarce = one_line;
    struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = LIM_NEAREST_FIRST};

    scarce.pools_b = lim_mem_min_b(scene_of(state), &target);
    assert_int_equal(lim_begin(&scarce, scene_of(state), LIM_NEAREST_FIRST, put, &glass), LIM_OK);
    glass.pieces = 0;
    assert_same_frames(*state, scarce.lim);
    assert_true(glass.pieces > VIEWS * H_PX);
    scarce.pools_b--;
    assert_int_equal(lim_begin(&scarce, scene_of(state), LIM_NEAREST_FIRST, put, &glass), LIM_ERR_MEMORY);
}

static void two_displays_are_apart(void **state)
{
    static struct glass other;
    const struct lim_camera camera = room_stage_view(*state, W_PX, H_PX);

    assert_int_equal(lim_begin(&one_line, scene_of(state), LIM_NEAREST_FIRST, put, &glass), LIM_OK);
    assert_int_equal(lim_begin(&all_lines, scene_of(state), LIM_PAINTER, put, &other), LIM_OK);
    glass.next = other.next = 0;
    assert_int_equal(lim_frame(one_line.lim, &camera), LIM_OK);
    assert_int_equal(lim_frame(all_lines.lim, &camera), LIM_OK);
    assert_memory_equal(glass.picture, other.picture, sizeof glass.picture);
}

static void a_failure_ends_the_frame_and_comes_back(void **state)
{
    const struct lim_camera camera = room_stage_view(*state, W_PX, H_PX);

    assert_int_equal(lim_begin(&one_line, scene_of(state), LIM_NEAREST_FIRST, put, &glass), LIM_OK);
    for (unsigned n = 1; n <= H_PX; n += 7) {
        glass = (struct glass){.fails_at = n};
        assert_int_equal(lim_frame(one_line.lim, &camera), FAILURE);
        assert_int_equal(glass.pieces, n);
    }
    glass.fails_at = 0;
    assert_same_frames(*state, one_line.lim);
}

/* A slanted part of each line, and every fifth line not at all. */
static void seen(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    assert_ptr_equal(((struct lim_sender *)ctx)->ctx, &glass);
    *x0_px = y_px / 2;
    *x1_px = (uint16_t)(y_px % 5 == 0 ? 0 : W_PX - y_px / 3);
}

static int put_seen(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    struct glass *glass_of = ctx;

    if (n_px == 0) return 0;
    assert_true(y_px % 5 != 0 && x_px >= y_px / 2 && x_px + n_px <= W_PX - y_px / 3);
    memcpy(&glass_of->picture[y_px][x_px], pixels, n_px * sizeof *pixels);
    return 0;
}

static void what_is_not_seen_is_not_sent(void **state)
{
    static struct glass whole;
    const struct lim_camera camera = room_stage_view(*state, W_PX, H_PX);

    assert_int_equal(lim_begin(&one_line, scene_of(state), LIM_NEAREST_FIRST, put, &whole), LIM_OK);
    assert_int_equal(lim_frame(one_line.lim, &camera), LIM_OK);
    assert_int_equal(lim_begin(&one_line, scene_of(state), LIM_NEAREST_FIRST, put_seen, &glass), LIM_OK);
    lim_set_visible(one_line.lim, seen);
    memset(glass.picture, 0x33, sizeof glass.picture);
    assert_int_equal(lim_frame(one_line.lim, &camera), LIM_OK);
    for (int y = 0; y < H_PX; y++)
        for (int x = 0; x < W_PX; x++) {
            const bool is_seen = y % 5 != 0 && x >= y / 2 && x < W_PX - y / 3;
            assert_int_equal(glass.picture[y][x], is_seen ? whole.picture[y][x] : 0x3333);
        }
}

static void all_is_seen_again(void **state)
{
    const struct lim_camera camera = room_stage_view(*state, W_PX, H_PX);

    glass.fails_at = 0;
    assert_int_equal(lim_begin(&one_line, scene_of(state), LIM_NEAREST_FIRST, put, &glass), LIM_OK);
    lim_set_visible(one_line.lim, seen);
    assert_int_equal(lim_frame_begin(one_line.lim, &camera), LIM_OK);
    lim_set_visible(one_line.lim, NULL);
    assert_int_equal(lim_frame_paint(one_line.lim), LIM_ERR_BEGIN);
    assert_same_frames(*state, one_line.lim);
}

/* Widths, and how many bytes of the lines are there. */
static void lines_that_are_too_short_are_refused(void **state)
{
    static uint16_t _Alignas(4) lines[8 * 8];
    struct lim_target target;

    (void)state;
    for (uint16_t w_px = 1; w_px <= 8; w_px++) {
        const size_t line_b = (size_t)(w_px + w_px % 2) * 2, all_b = line_b * 3;
        struct lim_sender sender = {put, NULL, lines, line_b, 9};
        assert_int_equal(lim_sender_target(&sender, w_px, 3, LIM_NEAREST_FIRST, &target), LIM_OK);
        assert_ptr_equal(target.lend(target.ctx, 2), lines);
        assert_null(target.framebuffer.pixels);
        assert_int_equal(lim_sender_target(&sender, w_px, 3, LIM_PAINTER, &target), LIM_ERR_MEMORY);
        sender.lines_b--;
        assert_int_equal(lim_sender_target(&sender, w_px, 3, LIM_NEAREST_FIRST, &target), LIM_ERR_MEMORY);
        sender.lines_b = all_b;
        assert_int_equal(lim_sender_target(&sender, w_px, 3, LIM_PAINTER, &target), LIM_OK);
        assert_ptr_equal(target.lend(target.ctx, 2), (uint8_t *)lines + 2 * line_b);
        assert_ptr_equal(target.framebuffer.pixels, lines);
        sender.lines_b = all_b - 1;
        assert_int_equal(lim_sender_target(&sender, w_px, 3, LIM_PAINTER, &target), LIM_ERR_MEMORY);
    }
}

/* The longest sides, whose bytes have more than 16 bits. */
static void large_displays_are_no_small_ones(void **state)
{
    static uint16_t _Alignas(4) line[1024];
    struct lim_sender sender = {put, NULL, line, sizeof line, 0};
    struct lim_target target;

    (void)state;
    assert_int_equal(lim_sender_target(&sender, 1024, 1024, LIM_PAINTER, &target), LIM_ERR_MEMORY);
    assert_int_equal(lim_sender_target(&sender, 1024, 1024, LIM_NEAREST_FIRST, &target), LIM_OK);
    assert_ptr_equal(target.lend(target.ctx, 1023), line);
}

static void a_declaration_has_the_memory_that_it_says(void **state)
{
    (void)state;
    assert_true(one_line.w_px == W_PX && one_line.h_px == H_PX);
    assert_int_equal(one_line.lines_b, 64 * 2);
    assert_int_equal(all_lines.lines_b, 64 * 2 * H_PX);
    assert_true(one_line.pools_b >= POOLS_B && one_line.pools_b < POOLS_B + sizeof(void *));
    assert_int_equal(one_line.movers_b, 0);
    assert_int_equal(all_lines.movers_b, 1000);
    assert_ptr_equal(all_lines.movers, (char *)all_lines.pools + all_lines.pools_b);
    assert_true((char *)all_lines.lines >= (char *)all_lines.movers + 1000);
    assert_int_equal((uintptr_t)all_lines.lines % 4, 0);
    assert_int_equal((uintptr_t)all_lines.pools % sizeof(void *), 0);
}

static int set_up(void **state)
{
    return room_stage_set_up(state, 417);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_line_does_for_all),
        cmocka_unit_test(all_lines_are_a_framebuffer),
        cmocka_unit_test(nearest_first_paints_into_it_at_once),
        cmocka_unit_test(scarce_pools_send_pieces),
        cmocka_unit_test(two_displays_are_apart),
        cmocka_unit_test(a_failure_ends_the_frame_and_comes_back),
        cmocka_unit_test(what_is_not_seen_is_not_sent),
        cmocka_unit_test(all_is_seen_again),
        cmocka_unit_test(lines_that_are_too_short_are_refused),
        cmocka_unit_test(large_displays_are_no_small_ones),
        cmocka_unit_test(a_declaration_has_the_memory_that_it_says),
    };

    return cmocka_run_group_tests_name("begin", tests, set_up, room_stage_tear_down);
}
