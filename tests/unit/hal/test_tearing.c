/* SPDX-License-Identifier: MIT
 *
 * The tearing-effect output: frames begin with the glass's refresh and run with it, a bounded time is waited, and a
 * refresh that does not tell its start is no error but is counted. */
#include "rigs/panels/dcs_rig.h"

enum { REFRESH_US = 20000 };

static void start(enum panel_rotation rotation, bool mirror)
{
    rig_setup(module_135x240);
    rig.chip.refresh_us = REFRESH_US;
    rig.fault.tearing = emulated_port_tearing(&rig.chip.port);
    rig.config.tearing = fault_port_tearing(&rig.fault);
    rig.config.rotation = rotation;
    rig.config.mirror = mirror;
    rig_start(2);
}

static void every_frame_begins_with_a_refresh(void **state)
{
    (void)state;
    for (size_t i = 0; panels_dcs[i]; i++) {
        rig_setup((struct dcs_make){.chip = panels_dcs[i]->name, .w_px = 30, .h_px = 20});
        rig.chip.refresh_us = REFRESH_US;
        rig.config.tearing = emulated_port_tearing(&rig.chip.port);
        rig.config.format = panels_dcs[i]->format;
        rig_start(2);
        for (unsigned frame = 0; frame < 3; frame++) {
            rig.chip.port.now_us += 7777;
            const uint64_t before_us = rig.chip.port.now_us;
            assert_int_equal(screen_begin_frame(&rig.screen), 0);
            assert_int_equal(rig.chip.port.now_us % REFRESH_US, 0);
            assert_in_range(rig.chip.port.now_us - before_us, 1, REFRESH_US);
            assert_int_equal(draw_lines(&rig.screen, 0, 20, 30), 0);
            assert_int_equal(screen_end_frame(&rig.screen), 0);
        }
        assert_int_equal(rig.display.panel.missed_edges, 0);
        assert_quiet();
    }
}

/* Upright and on its head, as set up and as changed later; not across the refresh. */
static void lines_run_with_the_refresh_where_they_can(void **state)
{
    (void)state;
    for (unsigned turns = 0; turns < 4; turns++)
        for (unsigned mirrored = 0; mirrored < 2; mirrored++) {
            start((enum panel_rotation)turns, mirrored);
            assert_int_equal(draw_frame(&rig.screen), 0);
            assert_card_shown(turns, mirrored);
            if (turns % 2 == 0) assert_true(emulated_dcs_follows_refresh(&rig.chip));
            assert_quiet();
        }
    start(PANEL_UPRIGHT, false);
    assert_int_equal(panel_set_rotation(&rig.display.panel, PANEL_TURNED_180), 0);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_true(emulated_dcs_follows_refresh(&rig.chip));
    rig_setup(module_135x240); /* without the output nothing is turned for it */
    rig.config.rotation = PANEL_TURNED_180;
    rig_start(2);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_false(emulated_dcs_follows_refresh(&rig.chip));
}

static void a_refresh_that_is_not_told_is_counted_and_no_error(void **state)
{
    (void)state;
    start(PANEL_UPRIGHT, false);
    rig.chip.refresh_us = 1000000;
    for (unsigned frame = 1; frame <= 3; frame++) {
        const uint64_t before_us = rig.chip.port.now_us;
        assert_int_equal(draw_frame(&rig.screen), 0);
        assert_card_shown(0, false);
        assert_int_equal(rig.display.panel.missed_edges, frame);
        assert_int_equal(rig.chip.port.now_us - before_us, 72000);
    }
    assert_quiet();
}

static void an_error_of_the_wait_ends_the_frame(void **state)
{
    (void)state;
    start(PANEL_UPRIGHT, false);
    fault_arm(0);
    assert_int_equal(draw_frame(&rig.screen), rig.fault.code);
    assert_int_equal(rig.fault.calls, 1);
    assert_int_equal(rig.display.panel.missed_edges, 0);
    fault_arm(-1);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_card_shown(0, false);
}

static void waiting_without_teon_is_complained_about(void **state)
{
    (void)state;
    start(PANEL_UPRIGHT, false);
    assert_int_equal(wire_send(&rig.display.wire, 0x34, NULL, 0), 0);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_complaint(EMULATED_TEARING);
    assert_int_equal(rig.display.panel.missed_edges, 1);
    start(PANEL_UPRIGHT, false);
    const uint8_t mode = 1;
    assert_int_equal(wire_send(&rig.display.wire, 0x35, &mode, 1), 0);
    assert_complaint(EMULATED_ARGS_VALUE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_frame_begins_with_a_refresh),
        cmocka_unit_test(lines_run_with_the_refresh_where_they_can),
        cmocka_unit_test(a_refresh_that_is_not_told_is_counted_and_no_error),
        cmocka_unit_test(an_error_of_the_wait_ends_the_frame),
        cmocka_unit_test(waiting_without_teon_is_complained_about),
    };
    return cmocka_run_group_tests_name("tearing", tests, NULL, NULL);
}
