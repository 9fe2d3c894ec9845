/* SPDX-License-Identifier: MIT
 *
 * The screen between renderer and panel: whole frames in one window, pieces where they belong,
 * and no line touched while it may still be on its way. */
#include "rigs/panels/dcs_rig.h"

/* What a frame costs on the bus: CASET 5, RASET 5, RAMWR 1 and the pixels. */
static void whole_frame_travels_in_one_window(void **state)
{
    (void)state;
    for (unsigned n_lines = 1; n_lines <= 3; n_lines++) {
        rig_setup(module_240x240);
        rig_start(n_lines);
        uint64_t bus_b = rig.chip.port.bus_b;
        for (uint32_t frame = 1; frame <= 2; frame++) {
            assert_int_equal(draw_frame(&rig.screen), 0);
            assert_int_equal(rig.chip.frame_writes, frame);
        }
        assert_int_equal(rig.chip.port.bus_b - bus_b, 2 * (11 + 240 * 240 * 2));
        assert_card_shown(0, false);
        assert_quiet();
    }
}

static void painter_sends_its_framebuffer_in_one_window(void **state)
{
    (void)state;
    rig_setup(module_135x240);
    rig_start(1);
    struct panel *panel = &rig.display.panel;
    size_t frame_b = SCREEN_MEM_B(135, 240);
    assert_int_equal(screen_init(&rig.screen, panel, LIM_PAINTER, rig.mem, frame_b - 1), LIM_ERR_MEMORY);
    assert_int_equal(screen_init(&rig.screen, panel, LIM_PAINTER, rig.mem, frame_b), 0);
    const struct lim_target *target = &rig.screen.target;
    for (unsigned y = 0; y < 240; y++) {
        uint8_t *line = target->lend(target->ctx, (uint16_t)y);
        assert_ptr_equal(line, (uint8_t *)rig.mem + 272 * y);
    }
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_int_equal(rig.chip.frame_writes, 1);
    assert_card_shown(0, false);
    assert_quiet();
}

/* With whatever order paints into it; where lines take more room than their pixels, each has that before it. */
static void a_framebuffer_is_the_memory_of_all_lines(void **state)
{
    (void)state;
    rig_setup(module_135x240);
    rig_start(1);
    struct panel *panel = &rig.display.panel;
    const size_t frame_b = SCREEN_MEM_B(135, 240);
    assert_int_equal(screen_init_framebuffer(&rig.screen, panel, LIM_NEAREST_FIRST, rig.mem, frame_b - 1),
                     LIM_ERR_MEMORY);
    assert_int_equal(screen_init_framebuffer(&rig.screen, panel, LIM_NEAREST_FIRST, rig.mem, frame_b), 0);
    const struct lim_target *target = &rig.screen.target;
    assert_ptr_equal(target->framebuffer.pixels, rig.mem);
    assert_int_equal(target->framebuffer.stride_px, 136);
    for (unsigned y = 0; y < 240; y++)
        assert_ptr_equal(target->lend(target->ctx, (uint16_t)y), (uint8_t *)rig.mem + 272 * y);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_int_equal(rig.chip.frame_writes, 1);
    assert_card_shown(0, false);
    assert_quiet();
}

static void pieces_from_left_to_right_stay_in_one_window(void **state)
{
    (void)state;
    rig_setup(module_240x240);
    rig_start(2);
    assert_int_equal(screen_begin_frame(&rig.screen), 0);
    assert_int_equal(draw_lines(&rig.screen, 0, 240, 70), 0);
    assert_int_equal(screen_end_frame(&rig.screen), 0);
    assert_int_equal(rig.chip.frame_writes, 1);
    assert_card_shown(0, false);
    assert_quiet();
}

static void pieces_elsewhere_open_their_own_windows(void **state)
{
    (void)state;
    rig_setup(module_240x240);
    rig_start(2);
    assert_int_equal(draw_frame(&rig.screen), 0);
    const struct lim_target *target = &rig.screen.target;
    static const struct {
        uint16_t y, x, n;
        uint32_t windows; /* opened since the last whole frame, with this piece */
    } pieces[] = {{5, 10, 20, 1}, {5, 30, 210, 1}, {6, 10, 20, 2},   {5, 0, 240, 3},   {6, 0, 100, 3}, {6, 200, 40, 4},
                  {7, 0, 240, 5}, {8, 0, 240, 5},  {100, 0, 240, 6}, {239, 239, 1, 7}, {0, 0, 0, 7}};
    assert_int_equal(screen_begin_frame(&rig.screen), 0);
    for (unsigned i = 0; i < sizeof pieces / sizeof pieces[0]; i++) {
        uint8_t *line = target->lend(target->ctx, pieces[i].y);
        memset(line, (int)(0x11 + i), 480);
        assert_int_equal(target->done(target->ctx, pieces[i].y, pieces[i].x, pieces[i].n), 0);
        assert_int_equal(rig.chip.frame_writes, 1 + pieces[i].windows);
        emulated_dcs_show(&rig.chip, 0, NULL, rig.raw);
        for (unsigned k = 0; k < pieces[i].n; k++) {
            assert_int_equal(rig.raw[pieces[i].y * 240u + pieces[i].x + k], (0x11 + i) * 0x101);
        }
    }
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_card_shown(0, false);
    assert_quiet();
}

static void abandoned_frame_does_not_shift_the_next(void **state)
{
    (void)state;
    rig_setup(module_240x240);
    rig_start(2);
    assert_int_equal(screen_begin_frame(&rig.screen), 0);
    assert_int_equal(draw_lines(&rig.screen, 0, 100, 240), 0);
    assert_int_equal(panel_set_inverted(&rig.display.panel, false), 0); /* ends the chip's frame write */
    assert_int_equal(screen_begin_frame(&rig.screen), 0);
    assert_int_equal(draw_lines(&rig.screen, 100, 240, 240), 0);
    assert_int_equal(screen_end_frame(&rig.screen), 0);
    assert_card_shown(0, false);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_card_shown(0, false);
    assert_quiet();
}

static void screen_refuses_memory_without_a_line_and_lines_without_a_place(void **state)
{
    (void)state;
    rig_setup(module_135x240);
    rig_open(1);
    struct panel *panel = &rig.display.panel;
    assert_int_equal(SCREEN_LINE_B(135), 272);
    assert_int_equal(screen_init(&rig.screen, panel, LIM_NEAREST_FIRST, rig.mem, 271), LIM_ERR_MEMORY);
    assert_int_equal(screen_init(&rig.screen, panel, LIM_NEAREST_FIRST, rig.mem, 272), 0);
    assert_null(rig.screen.target.lend(rig.screen.target.ctx, 240));
    assert_non_null(rig.screen.target.lend(rig.screen.target.ctx, 239));
}

static void piece_that_failed_can_be_sent_again(void **state)
{
    (void)state;
    rig_setup(module_240x240);
    rig_start(2);
    assert_int_equal(screen_begin_frame(&rig.screen), 0);
    assert_int_equal(draw_lines(&rig.screen, 0, 100, 240), 0);
    fault_arm(0);
    assert_int_equal(draw_lines(&rig.screen, 100, 101, 240), rig.fault.code);
    fault_arm(-1);
    assert_int_equal(draw_lines(&rig.screen, 100, 240, 240), 0);
    assert_int_equal(screen_end_frame(&rig.screen), 0);
    assert_card_shown(0, false);
    assert_quiet();
}

static void line_lent_again_unsent_is_the_same_memory(void **state)
{
    (void)state;
    rig_setup(module_240x240);
    rig_start(2);
    const struct lim_target *target = &rig.screen.target;
    void *first = target->lend(target->ctx, 0);
    assert_int_equal(target->done(target->ctx, 0, 0, 240), 0);
    void *second = target->lend(target->ctx, 1);
    assert_ptr_not_equal(second, first);
    assert_ptr_equal(target->lend(target->ctx, 1), second);
    assert_ptr_equal(target->lend(target->ctx, 2), second);
}

/* The emulated bus reads data as late as it may: a buffer reused too early, or D/C changed too
 * early, spoils the picture. */
static void bus_that_works_alone_gets_every_byte_as_it_was(void **state)
{
    (void)state;
    for (unsigned n_lines = 1; n_lines <= 2; n_lines++) {
        rig_setup(module_240x240);
        rig.chip.port.deferred = true;
        rig_start(n_lines);
        assert_int_equal(draw_frame(&rig.screen), 0);
        assert_int_equal(draw_frame(&rig.screen), 0);
        assert_card_shown(0, false);
        assert_quiet();
    }
}

/* The renderer's window ends there, and is not taken for one of the screen's own, which pieces share. */
static void pieces_without_a_window_open_their_own(void **state)
{
    (void)state;
    rig_setup(module_240x240);
    rig_start(2);
    const struct lim_target *target = &rig.screen.target;
    const struct lim_rect given = {10, 5, 20, 9};
    assert_int_equal(screen_begin_frame(&rig.screen), 0);
    assert_int_equal(target->window(target->ctx, &given), 0);
    assert_non_null(target->lend(target->ctx, 5));
    assert_int_equal(target->done(target->ctx, 5, 10, 10), 0);
    assert_int_equal(rig.chip.frame_writes, 1);
    for (uint16_t x_px = 10; x_px < 240; x_px = (uint16_t)(x_px + 115)) {
        memset(target->lend(target->ctx, 6), 0x55, 480);
        assert_int_equal(target->window(target->ctx, NULL), 0);
        assert_int_equal(target->done(target->ctx, 6, x_px, 115), 0);
        assert_int_equal(rig.chip.frame_writes, 2);
    }
    assert_int_equal(screen_end_frame(&rig.screen), 0);
    emulated_dcs_show(&rig.chip, 0, NULL, rig.raw);
    for (unsigned x = 10; x < 240; x++)
        assert_int_equal(rig.raw[6 * 240u + x], 0x5555);
    assert_quiet();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_frame_travels_in_one_window),
        cmocka_unit_test(painter_sends_its_framebuffer_in_one_window),
        cmocka_unit_test(a_framebuffer_is_the_memory_of_all_lines),
        cmocka_unit_test(pieces_from_left_to_right_stay_in_one_window),
        cmocka_unit_test(pieces_elsewhere_open_their_own_windows),
        cmocka_unit_test(abandoned_frame_does_not_shift_the_next),
        cmocka_unit_test(screen_refuses_memory_without_a_line_and_lines_without_a_place),
        cmocka_unit_test(piece_that_failed_can_be_sent_again),
        cmocka_unit_test(line_lent_again_unsent_is_the_same_memory),
        cmocka_unit_test(bus_that_works_alone_gets_every_byte_as_it_was),
        cmocka_unit_test(pieces_without_a_window_open_their_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
