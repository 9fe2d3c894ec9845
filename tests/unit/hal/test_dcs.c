/* SPDX-License-Identifier: MIT
 *
 * The ST7789 driver against the emulated chip: what is drawn is what the viewer of each module
 * sees, however it is turned, without a complaint about the protocol; and an error of the port at
 * any call comes through unchanged and leaves nothing behind. */
#include "rigs/panels/dcs_rig.h"

/* A picture turned clockwise by r quarters has its first corner at the glass's corner r. */
static void check_rotations(struct dcs_make module)
{
    for (unsigned r = 0; r < 4; r++) {
        rig_setup(module);
        rig.config.rotation = (enum panel_rotation)r;
        rig_start(2);
        assert_int_equal(rig.display.panel.w_px, r % 2 ? module.h_px : module.w_px);
        assert_int_equal(rig.display.panel.h_px, r % 2 ? module.w_px : module.h_px);
        assert_int_equal(draw_frame(&rig.screen), 0);
        assert_corners(seen_rgb[(4 - r) % 4], seen_rgb[(5 - r) % 4], seen_rgb[(6 - r) % 4], seen_rgb[(7 - r) % 4]);
        assert_card_shown(r, false);
        assert_quiet();
    }
}

static void card_is_right_on_240x240_in_all_rotations(void **state)
{
    (void)state;
    check_rotations(module_240x240);
}

static void card_is_right_on_135x240_in_all_rotations(void **state)
{
    (void)state;
    check_rotations(module_135x240);
}

static void card_is_right_on_240x280_in_all_rotations(void **state)
{
    (void)state;
    check_rotations(module_240x280);
}

static void rotation_can_change_at_run_time(void **state)
{
    (void)state;
    for (unsigned r = 0; r < 4; r++) {
        rig_setup(module_135x240);
        rig_start(2);
        assert_int_equal(panel_set_rotation(&rig.display.panel, (enum panel_rotation)r), 0);
        size_t mem_b = SCREEN_MEM_B(rig.display.panel.w_px, 2);
        assert_int_equal(screen_init(&rig.screen, &rig.display.panel, LIM_NEAREST_FIRST, rig.mem, mem_b), 0);
        assert_int_equal(draw_frame(&rig.screen), 0);
        assert_card_shown(r, false);
        assert_quiet();
    }
    assert_int_equal(panel_set_rotation(&rig.display.panel, (enum panel_rotation)4), PANEL_ERR_CONFIG);
}

static void mirror_swaps_left_and_right_of_the_picture_in_all_rotations(void **state)
{
    (void)state;
    for (unsigned r = 0; r < 4; r++) {
        rig_setup(module_135x240);
        rig.config.rotation = (enum panel_rotation)r;
        rig.config.mirror = true;
        rig_start(2);
        assert_int_equal(draw_frame(&rig.screen), 0);
        assert_card_shown(r, true);
        assert_quiet();
    }
    rig_setup(module_135x240);
    rig.config.mirror = true;
    rig_start(2);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_corners(0x00FF00, 0xFF0000, 0x848284, 0x0000FF);
}

static void bgr_suits_bgr_glass_and_swaps_red_and_blue_elsewhere(void **state)
{
    (void)state;
    for (unsigned glass = 0; glass < 2; glass++) {
        for (unsigned config = 0; config < 2; config++) {
            struct dcs_make module = module_small;
            module.bgr = glass;
            rig_setup(module);
            rig.config.bgr = config;
            rig_start(2);
            assert_int_equal(draw_frame(&rig.screen), 0);
            if (glass == config) assert_corners(0xFF0000, 0x00FF00, 0x0000FF, 0x848284);
            if (glass != config) assert_corners(0x0000FF, 0x00FF00, 0xFF0000, 0x848284);
            assert_quiet();
        }
    }
}

static void inversion_suits_ips_glass_and_shows_the_negative_elsewhere(void **state)
{
    (void)state;
    for (unsigned ips = 0; ips < 2; ips++) {
        for (unsigned invert = 0; invert < 2; invert++) {
            struct dcs_make module = module_small;
            module.ips = ips;
            rig_setup(module);
            rig.config.invert = invert;
            rig_start(2);
            assert_int_equal(draw_frame(&rig.screen), 0);
            if (ips == invert) assert_corners(0xFF0000, 0x00FF00, 0x0000FF, 0x848284);
            if (ips != invert) assert_corners(0x00FFFF, 0xFF00FF, 0xFFFF00, 0x7B7D7B);
        }
    }
    assert_int_equal(panel_set_inverted(&rig.display.panel, true), 0);
    assert_corners(0x00FFFF, 0xFF00FF, 0xFFFF00, 0x7B7D7B);
    assert_int_equal(panel_set_inverted(&rig.display.panel, false), 0);
    assert_corners(0xFF0000, 0x00FF00, 0x0000FF, 0x848284);
    assert_quiet();
}

static void blank_sleep_and_backlight_hide_the_picture_and_bring_it_back(void **state)
{
    (void)state;
    int (*const hide[])(struct panel *, bool) = {panel_blank, panel_sleep};
    rig_setup(module_small);
    rig_start(2);
    struct panel *panel = &rig.display.panel;
    assert_int_equal(draw_frame(&rig.screen), 0);
    for (unsigned i = 0; i < 2; i++) {
        assert_int_equal(hide[i](panel, true), 0);
        assert_corners(0, 0, 0, 0);
        assert_int_equal(hide[i](panel, false), 0);
        assert_corners(0xFF0000, 0x00FF00, 0x0000FF, 0x848284);
    }
    assert_int_equal(panel_set_backlight(panel, false), 0);
    assert_corners(0, 0, 0, 0);
    assert_int_equal(panel_set_backlight(panel, true), 0);
    assert_corners(0xFF0000, 0x00FF00, 0x0000FF, 0x848284);
    assert_int_equal(draw_frame(&rig.screen), 0); /* each of them ended the frame write */
    assert_card_shown(0, false);
    assert_quiet();
}

static void blank_puts_out_both_display_and_backlight(void **state)
{
    (void)state;
    rig_setup(module_small);
    rig_start(2);
    assert_int_equal(panel_blank(&rig.display.panel, true), 0);
    assert_true(rig.chip.port.backlight_low && !rig.chip.display_on);
}

static void init_works_in_the_dark_and_keeps_what_was_set(void **state)
{
    (void)state;
    rig_setup(module_135x240);
    rig_start(2);
    struct panel *panel = &rig.display.panel;
    assert_int_equal(panel_set_inverted(panel, true), 0);
    assert_int_equal(panel_set_rotation(panel, PANEL_TURNED_180), 0);
    fault_arm(3);
    assert_int_equal(panel_init(panel), rig.fault.code);
    assert_true(rig.chip.port.backlight_low);
    fault_arm(-1);
    assert_int_equal(panel_init(panel), 0);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_corners(0xFFFF00, 0x7B7D7B, 0x00FFFF, 0xFF00FF);
}

static void init_takes_nothing_for_granted(void **state)
{
    (void)state;
    for (unsigned wired = 0; wired < 2; wired++) {
        rig_setup(module_small);
        if (!wired) rig.config.reset.set = NULL;
        rig.chip.port.deferred = true;
        rig_start(2);
        assert_int_equal(pin_set(&rig.dc, true), 0); /* as after a replugged bridge */
        assert_int_equal(panel_init(&rig.display.panel), 0);
        assert_int_equal(screen_begin_frame(&rig.screen), 0);
        assert_int_equal(draw_lines(&rig.screen, 0, 9, 17), 0);
        assert_int_equal(panel_init(&rig.display.panel), 0); /* while a line is on its way */
        assert_int_equal(draw_frame(&rig.screen), 0);
        assert_card_shown(0, false);
        assert_quiet();
    }
}

static void reset_backlight_and_flush_are_optional(void **state)
{
    (void)state;
    rig_setup(module_small);
    rig.config.reset.set = NULL;
    rig.config.backlight.set = NULL;
    rig.config.bus.flush = NULL;
    rig_start(2);
    assert_int_equal(panel_set_backlight(&rig.display.panel, true), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_blank(&rig.display.panel, true), 0);
    assert_int_equal(panel_blank(&rig.display.panel, false), 0);
    assert_int_equal(panel_init(&rig.display.panel), 0); /* again, from a chip that is awake */
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_card_shown(0, false);
    assert_quiet();
}

static void configurations_that_do_not_fit_the_chip_are_refused(void **state)
{
    (void)state;
    rig_setup(module_240x280);
    const struct dcs_config good = rig.config;
    struct dcs_config bad[12];
    for (unsigned i = 0; i < 12; i++) {
        bad[i] = good;
    }
    bad[0].w_px = 0;
    bad[1].h_px = 0;
    bad[2].w_px = 241;
    bad[3].h_px = 321;
    bad[4].ox_px = 1;
    bad[5].oy_px = 41;
    bad[6].ox_px = 65535;
    bad[7].oy_px = 65535;
    bad[8].rotation = (enum panel_rotation)4;
    bad[9].bus.write = NULL;
    bad[10].dc.set = NULL;
    bad[11].clock.delay = NULL;
    for (unsigned i = 0; i < 12; i++) {
        if (dcs_setup(&rig.display, &st7789, &bad[i]) != PANEL_ERR_CONFIG) fail_msg("configuration %u was taken", i);
    }
    assert_int_equal(dcs_setup(&rig.display, &st7789, &good), 0);
    assert_int_equal(rig.fault.calls, 0);
}

static void windows_and_pixels_outside_the_panel_are_refused(void **state)
{
    (void)state;
    static const uint16_t bad[][4] = {{0, 0, 0, 1},  {0, 0, 1, 0},  {17, 0, 1, 1},        {0, 24, 1, 1},
                                      {1, 0, 17, 1}, {0, 1, 1, 24}, {65535, 0, 65535, 1}, {0, 1, 1, 65535}};
    rig_setup(module_small);
    rig_start(2);
    struct panel *panel = &rig.display.panel;
    uint64_t bus_b = rig.chip.port.bus_b;
    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(panel_window(panel, bad[i][0], bad[i][1], bad[i][2], bad[i][3]), PANEL_ERR_WINDOW);
        assert_int_equal(panel_pixels(panel, rig.mem, 1), PANEL_ERR_WINDOW);
    }
    assert_int_equal(rig.chip.port.bus_b, bus_b);
    assert_int_equal(panel_window(panel, 0, 0, 2, 2), 0);
    assert_int_equal(panel_pixels(panel, rig.mem, 3), 0);
    assert_int_equal(panel_pixels(panel, rig.mem, 2), PANEL_ERR_WINDOW);
    assert_quiet();
}

/* Nobody can be sure where in a window the chip is then. */
static void window_is_closed_by_errors_and_commands(void **state)
{
    (void)state;
    rig_setup(module_small);
    rig_start(2);
    struct panel *panel = &rig.display.panel;
    assert_int_equal(panel_window(panel, 0, 0, 2, 2), 0);
    assert_int_equal(panel_window(panel, 0, 0, 0, 0), PANEL_ERR_WINDOW);
    assert_int_equal(panel_pixels(panel, rig.mem, 1), PANEL_ERR_WINDOW);
    assert_int_equal(panel_window(panel, 0, 0, 2, 2), 0);
    assert_int_equal(panel_set_inverted(panel, false), 0);
    assert_int_equal(panel_pixels(panel, rig.mem, 1), PANEL_ERR_WINDOW);
    assert_int_equal(panel_window(panel, 0, 0, 2, 2), 0);
    fault_arm(0);
    assert_int_equal(panel_pixels(panel, rig.mem, 1), rig.fault.code);
    assert_int_equal(panel_pixels(panel, rig.mem, 1), PANEL_ERR_WINDOW);
    assert_int_equal(panel_window(panel, 0, 0, 2, 2), 0);
    fault_arm(0);
    assert_int_equal(panel_flush(panel), rig.fault.code);
    assert_int_equal(panel_pixels(panel, rig.mem, 1), PANEL_ERR_WINDOW);
}

static void dc_is_set_only_where_it_changes(void **state)
{
    (void)state;
    rig_setup(module_240x240);
    rig_start(2);
    assert_int_equal(draw_frame(&rig.screen), 0);
    fault_arm(-1);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_int_equal(rig.fault.pin_sets, 6); /* CASET, RASET, RAMWR: low, and high again after each */
}

/* Runs init and a frame with call `fail_at` failing. Returns whether it came to that call. */
static bool run_with_fault(long fail_at, enum fault fault)
{
    fault_arm(fail_at);
    rig.fault.fault = fault;
    int err = panel_init(&rig.display.panel);
    if (!err) err = draw_frame(&rig.screen);
    if (!rig.fault.failed) {
        assert_int_equal(err, 0);
        return false;
    }
    assert_int_equal(err, rig.fault.code);
    assert_int_equal(rig.fault.calls_late, 0);
    return true;
}

/* Not the fault but the command or pixel that it cut short may be complained about, when the next one
 * comes; a reset by pin leaves not even that. */
static void assert_only_cut_command(long n, bool reset_wired)
{
    unsigned cut = rig.chip.complaints_of[EMULATED_ARGS_SHORT] + rig.chip.complaints_of[EMULATED_PIXEL_SPLIT];
    if (cut == rig.chip.complaints && cut <= (reset_wired ? 0 : 1)) return;
    fail_msg("call %ld: %u complaints, last: %s", n, rig.chip.complaints, rig.chip.complaint);
}

/* The memory is fouled before the good frame, which so cannot owe anything to the failed one. */
static void check_faults(bool reset_wired, bool deferred, enum fault fault)
{
    long n = 0;
    for (bool failed = true; failed; n++) {
        rig_setup(module_small);
        rig.chip.port.deferred = deferred;
        if (!reset_wired) rig.config.reset.set = NULL;
        rig_open(2);
        failed = run_with_fault(n, fault);
        fault_arm(-1);
        assert_int_equal(panel_init(&rig.display.panel), 0);
        memset(rig.chip.memory, 0x55, sizeof rig.chip.memory);
        assert_int_equal(draw_frame(&rig.screen), 0);
        assert_card_shown(0, false);
        assert_corners(0xFF0000, 0x00FF00, 0x0000FF, 0x848284);
        assert_only_cut_command(n, reset_wired);
    }
    assert_true(n > 60); /* init takes some 40 calls, the frame one a line and more */
}

static void error_at_any_call_comes_through_and_the_next_start_is_right(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 6; i++) {
        check_faults(i & 1, i & 1, (enum fault)(i / 2));
    }
}

static void error_in_a_frame_needs_no_new_init(void **state)
{
    (void)state;
    bool failed = true;
    for (long n = 0; failed; n++) {
        rig_setup(module_small);
        rig_start(2);
        fault_arm(n / 3);
        rig.fault.fault = (enum fault)(n % 3);
        int err = draw_frame(&rig.screen);
        failed = rig.fault.failed;
        assert_int_equal(err, failed ? rig.fault.code : 0);
        fault_arm(-1);
        memset(rig.chip.memory, 0x55, sizeof rig.chip.memory);
        assert_int_equal(draw_frame(&rig.screen), 0);
        assert_card_shown(0, false);
    }
}

static void error_in_a_setting_comes_through_and_leaves_it_as_it_was(void **state)
{
    (void)state;
    rig_setup(module_135x240);
    rig_start(2);
    struct panel *panel = &rig.display.panel;
    fault_arm(0);
    assert_int_equal(panel_set_rotation(panel, PANEL_TURNED_90), rig.fault.code);
    assert_int_equal(panel->w_px, 135);
    fault_arm(0);
    assert_int_equal(panel_set_inverted(panel, true), rig.fault.code);
    fault_arm(0);
    assert_int_equal(panel_set_backlight(panel, false), rig.fault.code);
    fault_arm(0);
    assert_int_equal(panel_blank(panel, true), rig.fault.code);
    fault_arm(0);
    assert_int_equal(panel_blank(panel, false), rig.fault.code);
    fault_arm(0);
    assert_int_equal(panel_sleep(panel, true), rig.fault.code);
    fault_arm(0);
    assert_int_equal(panel_flush(panel), rig.fault.code);
    fault_arm(-1);
    assert_int_equal(panel_init(panel), 0);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_corners(0xFF0000, 0x00FF00, 0x0000FF, 0x848284);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(card_is_right_on_240x240_in_all_rotations),
        cmocka_unit_test(card_is_right_on_135x240_in_all_rotations),
        cmocka_unit_test(card_is_right_on_240x280_in_all_rotations),
        cmocka_unit_test(rotation_can_change_at_run_time),
        cmocka_unit_test(mirror_swaps_left_and_right_of_the_picture_in_all_rotations),
        cmocka_unit_test(bgr_suits_bgr_glass_and_swaps_red_and_blue_elsewhere),
        cmocka_unit_test(inversion_suits_ips_glass_and_shows_the_negative_elsewhere),
        cmocka_unit_test(blank_sleep_and_backlight_hide_the_picture_and_bring_it_back),
        cmocka_unit_test(blank_puts_out_both_display_and_backlight),
        cmocka_unit_test(init_works_in_the_dark_and_keeps_what_was_set),
        cmocka_unit_test(init_takes_nothing_for_granted),
        cmocka_unit_test(reset_backlight_and_flush_are_optional),
        cmocka_unit_test(configurations_that_do_not_fit_the_chip_are_refused),
        cmocka_unit_test(windows_and_pixels_outside_the_panel_are_refused),
        cmocka_unit_test(window_is_closed_by_errors_and_commands),
        cmocka_unit_test(dc_is_set_only_where_it_changes),
        cmocka_unit_test(error_at_any_call_comes_through_and_the_next_start_is_right),
        cmocka_unit_test(error_in_a_frame_needs_no_new_init),
        cmocka_unit_test(error_in_a_setting_comes_through_and_leaves_it_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
