/* SPDX-License-Identifier: MIT
 *
 * Memory LCDs, beside what test_every_panel.c shows of all panels: the voltage's sign, whole lines, what the glass
 * cannot, and what the emulated glass complains about. */
#include "fakes/fault_port.h"
#include "glass/emulated_sharp.h"
#include "panels.h"
#include "rigs/cmocka_ready.h"
#include "screen.h"

#include <string.h>

static struct rig {
    struct emulated_sharp glass;
    struct sharp_config config;
    struct sharp display;
    struct screen screen;
    uint32_t mem[SCREEN_PAGES_MEM_B(400, 2) / 4];
} rig;

static void rig_setup(const struct sharp_chip *driver, bool by_pin)
{
    emulated_sharp_init(&rig.glass, emulated_sharp_kind_find(driver->name), by_pin);
    rig.glass.port.deferred = true;
    rig.config = (struct sharp_config){.bus = emulated_port_bus(&rig.glass.port),
                                       .select = emulated_port_select(&rig.glass.port),
                                       .shown = emulated_port_backlight(&rig.glass.port),
                                       .clock = emulated_port_clock(&rig.glass.port)};
    if (by_pin) rig.config.alternate = emulated_sharp_alternate(&rig.glass);
}

static void rig_start(const struct sharp_chip *driver)
{
    assert_int_equal(sharp_setup(&rig.display, driver, &rig.config), 0);
    assert_int_equal(screen_init(&rig.screen, &rig.display.panel, LIM_NEAREST_FIRST, rig.mem, sizeof rig.mem), 0);
    assert_int_equal(panel_init(&rig.display.panel), 0);
}

static void assert_quiet(void)
{
    if (rig.glass.complaints) fail_msg("%u complaints, the last: %s", rig.glass.complaints, rig.glass.complaint);
}

/* Lines first..end - 1, white where x + y is a multiple of 3. */
static int draw(uint16_t first, uint16_t end)
{
    const struct lim_target *target = &rig.screen.target;
    int err = screen_begin_frame(&rig.screen);

    for (uint16_t y = first; y < end && !err; y++) {
        uint8_t *line = target->lend(target->ctx, y);
        for (unsigned x = 0; x < target->w_px; x++)
            memset(&line[2 * x], (x + y) % 3 ? 0 : 0xFF, 2);
        err = target->done(target->ctx, y, 0, target->w_px);
    }
    return err ? err : screen_end_frame(&rig.screen);
}

static void assert_drawn(uint16_t first, uint16_t end)
{
    for (unsigned y = 0; y < rig.display.panel.h_px; y++)
        for (unsigned x = 0; x < rig.display.panel.w_px; x++) {
            const bool is_white = y < first || y >= end || (x + y) % 3 == 0;
            if (emulated_sharp_is_white(&rig.glass, x, y) != is_white) fail_msg("pixel %u,%u is wrong", x, y);
        }
}

static void start_leaves_white_glass(void **state)
{
    (void)state;
    for (size_t i = 0; panels_sharp[i]; i++) {
        rig_setup(panels_sharp[i], false);
        rig_start(panels_sharp[i]);
        assert_drawn(0, 0);
        assert_false(rig.glass.port.backlight_low || rig.glass.selected);
        assert_quiet();
    }
}

static void lines_go_where_they_belong_whatever_came_before(void **state)
{
    (void)state;
    for (size_t i = 0; panels_sharp[i]; i++) {
        const uint16_t h_px = panels_sharp[i]->h_px;
        const uint16_t parts[][2] = {{0, 1}, {h_px / 2, h_px / 2 + 3}, {h_px - 1, h_px}, {0, h_px}};
        for (unsigned k = 0; k < 4; k++) {
            rig_setup(panels_sharp[i], false);
            rig_start(panels_sharp[i]);
            assert_int_equal(draw(parts[k][0], parts[k][1]), 0);
            assert_drawn(parts[k][0], parts[k][1]);
            assert_false(rig.glass.selected);
            assert_quiet();
        }
    }
}

/* 2 bytes before each line, 2 after the last. */
static void a_frame_is_one_message(void **state)
{
    (void)state;
    rig_setup(&ls013b7dh03, false);
    rig_start(&ls013b7dh03);
    const uint64_t before_b = rig.glass.port.bus_b;
    assert_int_equal(draw(0, 128), 0);
    assert_int_equal(rig.glass.port.bus_b - before_b, 128 * (2 + 16) + 2);
}

static void every_frame_and_every_keep_changes_the_sign(void **state)
{
    (void)state;
    for (unsigned by_pin = 0; by_pin < 2; by_pin++) {
        rig_setup(&ls013b7dh03, by_pin);
        rig_start(&ls013b7dh03);
        uint32_t signs = rig.glass.signs;
        assert_int_equal(draw(0, 128), 0);
        assert_int_equal(rig.glass.signs, ++signs);
        assert_int_equal(draw(0, 0), 0); /* a frame that has nothing to send */
        assert_int_equal(rig.glass.signs, ++signs);
        for (unsigned k = 0; k < 3; k++) {
            rig.glass.port.now_us += 900000;
            assert_int_equal(panel_keep(&rig.display.panel), 0);
            assert_int_equal(rig.glass.signs, ++signs);
        }
        assert_drawn(0, 128);
        assert_quiet();
        rig.glass.port.now_us += 1100000;
        assert_int_equal(panel_keep(&rig.display.panel), 0);
        assert_int_equal(rig.glass.complaints, 1);
    }
}

/* A frame begins with a pulse: the pin, a wait, the pin. What fails is told, and nothing is tried behind it. */
static void errors_of_the_pulse_come_through(void **state)
{
    struct fault_port fault;

    (void)state;
    rig_setup(&ls013b7dh03, true);
    struct port port = emulated_port_whole(&rig.glass.port);
    port.reset = rig.config.alternate; /* in the place of one that the glass does not have */
    port = fault_port_over(&fault, &port, NULL);
    rig.config.alternate = port.reset;
    rig.config.clock = port.clock;
    rig_start(&ls013b7dh03);
    for (long n = 0; n < 3; n++) {
        fault_port_arm(&fault, n);
        assert_int_equal(panel_begin_frame(&rig.display.panel), fault.code);
        assert_int_equal(fault.calls_late, 0);
        fault_port_arm(&fault, n);
        assert_int_equal(panel_keep(&rig.display.panel), fault.code);
        assert_int_equal(fault.calls_late, 0);
    }
    fault_port_arm(&fault, 3);
    assert_int_equal(panel_begin_frame(&rig.display.panel), 0);
    assert_int_equal(fault.calls, 3);
}

/* A line more than there is, and half a line, end the window where they begin, however much of it is left. */
static void lines_may_come_several_at_once(void **state)
{
    static uint8_t bytes[8 * 400 / 8];

    (void)state;
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)(i * 37 + i / 11 + 1);
    for (size_t i = 0; panels_sharp[i]; i++) {
        const uint16_t w_px = panels_sharp[i]->w_px, line_b = w_px / 8;
        for (uint16_t n = 1; n <= 7; n++)
            for (uint16_t more_px = 0; more_px <= w_px; more_px += w_px / 2) {
                rig_setup(panels_sharp[i], false);
                rig_start(panels_sharp[i]);
                struct panel *panel = &rig.display.panel;
                assert_int_equal(panel_window(panel, 0, 5, w_px, more_px < w_px && more_px ? n + 3 : n), 0);
                assert_int_equal(panel_pixels(panel, bytes, (size_t)n * w_px + more_px),
                                 more_px ? PANEL_ERR_WINDOW : 0);
                assert_int_equal(panel_pixels(panel, bytes, w_px), PANEL_ERR_WINDOW);
                assert_int_equal(panel_flush(panel), 0);
                assert_memory_equal(rig.glass.memory[5], bytes, line_b);
                for (unsigned k = 1; k < n; k++)
                    assert_memory_equal(rig.glass.memory[5 + k], &bytes[k * line_b], line_b);
                assert_true(emulated_sharp_is_white(&rig.glass, 0, 4));
                assert_true(emulated_sharp_is_white(&rig.glass, w_px - 1, 5 + n));
                assert_int_equal(rig.glass.port.stores, n);
                assert_quiet();
            }
    }
}

/* In the middle of a frame as well: the window is closed then. */
static void keep_ends_a_message_under_way(void **state)
{
    (void)state;
    rig_setup(&ls013b7dh03, false);
    rig_start(&ls013b7dh03);
    struct panel *panel = &rig.display.panel;
    assert_int_equal(panel_window(panel, 0, 3, 128, 2), 0);
    memset(rig.mem, 0, 16);
    assert_int_equal(panel_pixels(panel, rig.mem, 128), 0);
    assert_int_equal(panel_keep(panel), 0);
    assert_false(emulated_sharp_is_white(&rig.glass, 0, 3));
    assert_true(emulated_sharp_is_white(&rig.glass, 0, 4));
    assert_int_equal(panel_pixels(panel, rig.mem, 128), PANEL_ERR_WINDOW);
    assert_quiet();
}

static void what_the_glass_cannot_is_refused(void **state)
{
    (void)state;
    rig_setup(&ls013b7dh03, false);
    struct sharp_config bad[3] = {rig.config, rig.config, rig.config};
    bad[0].bus.write = NULL;
    bad[1].select.set = NULL;
    bad[2].clock.delay = NULL;
    for (unsigned k = 0; k < 3; k++)
        assert_int_equal(sharp_setup(&rig.display, &ls013b7dh03, &bad[k]), PANEL_ERR_CONFIG);
    rig.config.shown.set = NULL;
    rig_start(&ls013b7dh03);
    struct panel *panel = &rig.display.panel;
    assert_int_equal(panel_blank(panel, true), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_sleep(panel, true), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_set_inverted(panel, true), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_set_backlight(panel, true), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_set_rotation(panel, PANEL_TURNED_180), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_window(panel, 0, 0, 64, 1), PANEL_ERR_WINDOW);
    assert_int_equal(panel_window(panel, 0, 128, 128, 1), PANEL_ERR_WINDOW);
    assert_int_equal(panel_window(panel, 0, 0, 128, 1), 0);
    assert_int_equal(panel_pixels(panel, rig.mem, 64), PANEL_ERR_WINDOW);
    assert_int_equal(draw(0, 128), 0);
    assert_drawn(0, 128);
    assert_quiet();
}

/* Bytes sent while select is high, after a wait and before another. */
static void send(const uint8_t *bytes, size_t n_b, uint32_t before_us, uint32_t after_us)
{
    assert_int_equal(pin_set(&rig.config.select, true), 0);
    assert_int_equal(clock_delay(&rig.config.clock, before_us), 0);
    assert_int_equal(bus_write(&rig.config.bus, bytes, n_b), 0);
    assert_int_equal(clock_delay(&rig.config.clock, after_us), 0);
    assert_int_equal(pin_set(&rig.config.select, false), 0);
}

static void mistakes_are_complained_about(void **state)
{
    static const struct {
        uint8_t command, number, n_b;
        uint32_t before_us, after_us;
        unsigned complaints;
    } messages[] = {
        {0x80, 0x80, 20, 6, 2, 0}, {0x80, 0x80, 20, 5, 2, 1}, /* select too late */
        {0x80, 0x80, 20, 6, 1, 1},                            /* released too early */
        {0x80, 0x80, 19, 6, 2, 1},                            /* 8 bits behind the line */
        {0x80, 0x00, 20, 6, 2, 1},                            /* line 0 */
        {0x80, 0x81, 20, 6, 2, 1},                            /* line 129 */
        {0xA0, 0x80, 20, 6, 2, 1},                            /* write and clear */
        {0x20, 0x00, 2, 6, 2, 0},  {0x20, 0x00, 1, 6, 2, 1},  {0x20, 0x00, 3, 6, 2, 1}, {0x00, 0x00, 2, 6, 2, 0},
    };
    (void)state;
    for (size_t i = 0; i < sizeof messages / sizeof *messages; i++) {
        const uint8_t bytes[20] = {messages[i].command, messages[i].number};
        rig_setup(&ls013b7dh03, false);
        rig.glass.port.deferred = false;
        send(bytes, messages[i].n_b, messages[i].before_us, messages[i].after_us);
        if (rig.glass.complaints != messages[i].complaints)
            fail_msg("message %zu: %u complaints, the last: %s", i, rig.glass.complaints, rig.glass.complaint);
    }
    rig_setup(&ls013b7dh03, false);
    rig.glass.port.deferred = false;
    assert_int_equal(bus_write(&rig.config.bus, (const uint8_t[]){0}, 1), 0);
    assert_int_equal(rig.glass.complaints, 1); /* without select */
    rig.glass.port.deferred = true;
    assert_int_equal(bus_write(&rig.config.bus, (const uint8_t[]){0}, 1), 0);
    assert_int_equal(pin_set(&rig.config.select, true), 0);
    assert_int_equal(rig.glass.complaints, 2); /* while bytes are on their way */
}

/* The least width of EXTCOMIN is 2 us on the one, 1 us on the other; that of select, low, 6 and 1. */
static void pulses_that_are_too_short_are_complained_about(void **state)
{
    (void)state;
    for (size_t i = 0; panels_sharp[i]; i++)
        for (uint32_t pulse_us = 0; pulse_us < 8; pulse_us++) {
            const bool is_slow = panels_sharp[i] == &ls013b7dh03;
            rig_setup(panels_sharp[i], true);
            assert_int_equal(pin_set(&rig.config.alternate, true), 0);
            assert_int_equal(clock_delay(&rig.config.clock, pulse_us), 0);
            assert_int_equal(pin_set(&rig.config.alternate, false), 0);
            assert_int_equal(rig.glass.complaints, pulse_us < (is_slow ? 2 : 1));
            rig_setup(panels_sharp[i], false);
            rig.glass.port.deferred = false;
            send((const uint8_t[2]){0x20}, 2, 6, 2);
            assert_int_equal(clock_delay(&rig.config.clock, pulse_us), 0);
            send((const uint8_t[2]){0x20}, 2, 6, 2);
            assert_int_equal(rig.glass.complaints, pulse_us < (is_slow ? 6 : 1));
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(start_leaves_white_glass),
        cmocka_unit_test(lines_go_where_they_belong_whatever_came_before),
        cmocka_unit_test(a_frame_is_one_message),
        cmocka_unit_test(every_frame_and_every_keep_changes_the_sign),
        cmocka_unit_test(errors_of_the_pulse_come_through),
        cmocka_unit_test(lines_may_come_several_at_once),
        cmocka_unit_test(keep_ends_a_message_under_way),
        cmocka_unit_test(what_the_glass_cannot_is_refused),
        cmocka_unit_test(mistakes_are_complained_about),
        cmocka_unit_test(pulses_that_are_too_short_are_complained_about),
    };
    return cmocka_run_group_tests_name("sharp", tests, NULL, NULL);
}
