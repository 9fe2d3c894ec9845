/* SPDX-License-Identifier: MIT
 *
 * The MCP2210's protocol, and a port over it, against an emulated bridge and emulated displays: frames through the real
 * drivers are those of a display at a port of its own; reports are as few as they can be; whatever happens to any one
 * report comes through as an error, nothing hangs, and the next frame is right. */
#include "hid/mcp2210.h"
#include "rigs/cmocka_ready.h"
#include "rigs/panels/bridge_rig.h"

#include <errno.h>
#include <string.h>

static struct bridge_rig rig; /* too large for a stack */
static struct port port;

static void open_port(const char *panel, uint16_t w_px, uint16_t h_px)
{
    bridge_rig_setup(&rig, panel, w_px, h_px);
    const struct bridge_link link = emulated_bridge_link(&rig.bridge);
    const struct bridge_options options = emulated_bridge_options(&rig.bridge);
    if (bridge_port_open(&port, &link, &options)) fail_msg("%s", port.error);
    bridge_rig_connect(&rig, &port);
}

static int close_port_after(void **state)
{
    (void)state;
    port_close(&port);
    return 0;
}

static void assert_text(const char *part)
{
    if (!strstr(port.error, part)) fail_msg("\"%s\" does not say \"%s\"", port.error, part);
    if (strchr(port.error, '\n')) fail_msg("more than a line: %s", port.error);
}

static int send(size_t n_b)
{
    static const uint8_t data[100];
    const int err = bus_write(&port.bus, data, n_b);

    return err ? err : bus_flush(&port.bus);
}

/* Frames ----------------------------------------------------------------------------------- */

static const struct panel_size {
    const char *panel;
    uint16_t w_px, h_px;
} GLASS[] = {{"st7735", 128, 160},    {"ssd1306", 128, 64}, {"st7789", 31, 17},  {"pcd8544", 84, 48},
             {"st7789:rgb444", 9, 7}, {"ssd1327", 64, 48},  {"ssd1351", 50, 30}, {"ls013b7dh03", 128, 128}};
enum { GLASSES = sizeof GLASS / sizeof GLASS[0] };

static void frames_arrive_whole(void **state)
{
    (void)state;
    for (size_t i = 0; i < GLASSES; i++) {
        open_port(GLASS[i].panel, GLASS[i].w_px, GLASS[i].h_px);
        assert_int_equal(panel_init(rig.display.panel), 0);
        for (unsigned picture = 0; picture < 3; picture++) {
            assert_int_equal(bridge_rig_draw(&rig, picture), 0);
            bridge_rig_assert_shown(&rig, picture);
        }
        bridge_rig_assert_quiet(&rig);
        assert_false(rig.glass.port->backlight_low);
        assert_int_equal(rig.bridge.chip.commands[0x60], 0);
        port_close(&port);
    }
}

/* A busy bridge and empty packets cost time alone. */
static void a_bridge_in_a_mood_is_borne_with(void **state)
{
    (void)state;
    for (unsigned every = 2; every < 6; every++) {
        open_port("st7735", 24, 20);
        rig.bridge.chip.busy_every = every;
        rig.bridge.cable.empty_every = every + 1;
        assert_int_equal(bridge_rig_start(&rig, 0), 0);
        bridge_rig_assert_shown(&rig, 0);
        bridge_rig_assert_quiet(&rig);
        port_close(&port);
    }
}

/* Reports ---------------------------------------------------------------------------------- */

static long reports_of_a_frame(const char *panel, uint16_t w_px, uint16_t h_px)
{
    open_port(panel, w_px, h_px);
    assert_int_equal(bridge_rig_start(&rig, 0), 0);
    emulated_cable_arm(&rig.bridge.cable, CABLE_NEVER, CABLE_LOST, 0);
    assert_int_equal(bridge_rig_draw(&rig, 1), 0);
    bridge_rig_assert_shown(&rig, 1);
    port_close(&port);
    return rig.bridge.cable.reports;
}

/* A window: six changes of D/C, six of the length (1, 4, 1, 4, 1, pixels), five transactions of a report and another
 * for their end. */
static void a_frame_takes_as_few_reports_as_it_can(void **state)
{
    enum { WINDOW = 6 + 6 + 5 * 2 };
    (void)state;
    assert_int_equal(reports_of_a_frame("st7735", 128, 160), WINDOW + (128 * 160 * 2 + 59) / 60 + 1);
    assert_int_equal(reports_of_a_frame("st7789", 30, 17), WINDOW + 30 * 17 * 2 / 60 + 1);
    /* Twice D/C and length; an address of two bytes or six, and the pixels. */
    assert_int_equal(reports_of_a_frame("ssd1306", 128, 64), 2 + 2 + 2 + (128 * 64 / 8 + 59) / 60 + 1);
    assert_int_equal(reports_of_a_frame("pcd8544", 84, 48), 2 + 2 + 2 + (84 * 48 / 8 + 59) / 60 + 1);
    /* The same for each page, where it is addressed for itself. */
    assert_int_equal(reports_of_a_frame("st7567", 128, 64), 8 * (2 + 2 + 2 + 3 + 1));
}

/* More than a transaction holds goes in two, and writes of any length share their reports. */
static void long_streams_are_cut_where_reports_are_full(void **state)
{
    enum { STREAM_B = 115200, PART_B = 479 };
    static const uint8_t data[PART_B];
    (void)state;
    open_port("st7789", 31, 17);
    emulated_cable_arm(&rig.bridge.cable, CABLE_NEVER, CABLE_LOST, 0);
    const uint64_t before_b = rig.bridge.chip.bus_b;
    for (unsigned left_b = STREAM_B; left_b;) {
        const unsigned n_b = left_b < PART_B ? left_b : PART_B;
        assert_int_equal(bus_write(&port.bus, data, n_b), 0);
        left_b -= n_b;
    }
    assert_int_equal(bus_flush(&port.bus), 0);
    assert_int_equal(rig.bridge.chip.bus_b - before_b, STREAM_B);
    assert_int_equal(rig.bridge.cable.reports, STREAM_B / 60 + 2 * 2);
    assert_int_equal(rig.bridge.chip.transactions, 2);
    bridge_rig_assert_quiet(&rig);
}

static void a_length_that_is_set_is_not_set_again(void **state)
{
    (void)state;
    open_port("st7735", 24, 20);
    emulated_cable_arm(&rig.bridge.cable, CABLE_NEVER, CABLE_LOST, 0);
    assert_int_equal(send(100), 0);
    assert_int_equal(rig.bridge.cable.reports, 1 + 2 + 1);
    assert_int_equal(send(100), 0);
    assert_int_equal(rig.bridge.cable.reports, 2 * (2 + 1) + 1);
}

/* Also what no flush has sent. */
static void bytes_leave_before_a_pin_changes(void **state)
{
    static const uint8_t byte;
    (void)state;
    open_port("st7735", 24, 20);
    const uint64_t before_b = rig.bridge.chip.bus_b;
    assert_int_equal(bus_write(&port.bus, &byte, 1), 0);
    assert_int_equal(pin_set(&port.dc, true), 0);
    assert_int_equal(rig.bridge.chip.bus_b, before_b + 1);
    bridge_rig_assert_quiet(&rig);
}

/* Errors ----------------------------------------------------------------------------------- */

static int code_of(enum cable_fault fault, int code)
{
    switch (fault) {
    case CABLE_REFUSED:
    case CABLE_UNREAD:
        return code;
    case CABLE_MANGLED:
        return -EPROTO;
    case CABLE_UNPLUGGED:
        return -ENODEV;
    default:
        return -ETIMEDOUT;
    }
}

/* Where the display keeps its power the next frame does without panel_init(), unless that itself broke off. */
static void recover(enum cable_fault fault, bool initialised)
{
    bridge_rig_forgive(&rig);
    if (fault == CABLE_UNPLUGGED) {
        assert_int_equal(bridge_rig_start(&rig, 1), -ENODEV);
        assert_text("unplugged; plug it in again");
        emulated_bridge_replug(&rig.bridge);
    } else if (initialised) {
        assert_int_equal(bridge_rig_draw(&rig, 2), 0);
        bridge_rig_forgive(&rig);
        bridge_rig_assert_shown(&rig, 2);
        assert_false(rig.glass.port->backlight_low);
    }
    assert_int_equal(bus_flush(&port.bus), 0); /* may end a reset pulse that broke off, */
    if (pin_is_wired(&port.select)) assert_int_equal(pin_set(&port.select, false), 0); /* and this a message */
    bridge_rig_forgive(&rig);
    assert_int_equal(bridge_rig_start(&rig, 1), 0);
    bridge_rig_assert_shown(&rig, 1);
    bridge_rig_assert_quiet(&rig);
}

/* Returns whether report n was sent at all, in panel_init() and a frame: glass is small, but no index is left out. */
static bool survives(const char *panel, uint16_t w_px, uint16_t h_px, long n, enum cable_fault fault)
{
    const int code = -7000 - (int)n;

    open_port(panel, w_px, h_px);
    emulated_cable_arm(&rig.bridge.cable, n, fault, code);
    int err = panel_init(rig.display.panel);
    const bool initialised = !err;
    if (!err) err = bridge_rig_draw(&rig, 0);
    const bool faulted = rig.bridge.cable.faulted;
    if (err != (faulted ? code_of(fault, code) : 0))
        fail_msg("%s, fault %d at report %ld: %d, \"%s\"", panel, (int)fault, n, err, port.error);
    if (faulted) {
        assert_text("emulated MCP2210: ");
        emulated_cable_arm(&rig.bridge.cable, CABLE_NEVER, fault, 0);
        recover(fault, initialised);
    }
    port_close(&port);
    return faulted;
}

static void whatever_happens_to_a_report_is_told_and_overcome(void **state)
{
    static const struct panel_size small[] = {{"ssd1306", 24, 16}, {"pcd8544", 17, 16},       {"st7735", 24, 9},
                                              {"st7789", 10, 8},   {"gc9a01:rgb444", 16, 16}, {"ssd1327", 24, 8},
                                              {"ssd1351", 10, 8},  {"ls013b7dh03", 128, 128}};
    long runs = 0;

    (void)state;
    for (int fault = 0; fault < CABLE_FAULTS; fault++)
        for (size_t i = 0; i < sizeof small / sizeof *small; i++) {
            long n = 0;
            while (survives(small[i].panel, small[i].w_px, small[i].h_px, n, (enum cable_fault)fault))
                n++;
            assert_true(n > 15);
            runs += n;
        }
    print_message("# mcp2210: %ld reports met with a fault\n", runs);
}

/* Each report of the opening, too. */
static void an_opening_that_fails_opens_nothing(void **state)
{
    (void)state;
    for (int fault = 0; fault < CABLE_FAULTS; fault++) {
        long n = 0;
        for (bool faulted = true; faulted; n++) {
            bridge_rig_setup(&rig, "st7789", 8, 8);
            emulated_cable_arm(&rig.bridge.cable, n, (enum cable_fault)fault, -7001);
            const struct bridge_link link = emulated_bridge_link(&rig.bridge);
            const struct bridge_options options = emulated_bridge_options(&rig.bridge);
            const int err = bridge_port_open(&port, &link, &options);
            faulted = rig.bridge.cable.faulted;
            assert_int_equal(err, faulted ? code_of((enum cable_fault)fault, -7001) : 0);
            assert_int_equal(!port.close, faulted);
            port_close(&port);
        }
        assert_int_equal(n - 1, 6); /* cancel, status, get and set the chip's settings, levels, directions */
    }
}

static void a_bus_that_another_master_has_is_reported(void **state)
{
    (void)state;
    open_port("st7735", 24, 20);
    assert_int_equal(bridge_rig_start(&rig, 0), 0);
    rig.bridge.chip.bus_taken = true;
    assert_int_equal(bridge_rig_draw(&rig, 1), -EBUSY);
    assert_text("0xf7");
    rig.bridge.chip.bus_taken = false;
    assert_int_equal(bridge_rig_draw(&rig, 2), 0);
    bridge_rig_assert_shown(&rig, 2);
    assert_int_equal(rig.bridge.opened, 1);
    bridge_rig_assert_quiet(&rig);

    port_close(&port);
    rig.bridge.chip.bus_taken = true;
    const struct bridge_link link = emulated_bridge_link(&rig.bridge);
    const struct bridge_options options = emulated_bridge_options(&rig.bridge);
    assert_int_equal(bridge_port_open(&port, &link, &options), -EBUSY);
}

static void a_bridge_busy_for_ever_is_given_up(void **state)
{
    (void)state;
    open_port("st7735", 24, 20);
    rig.bridge.chip.busy_every = 1;
    const uint64_t before_ms = rig.bridge.cable.now_ms;
    assert_int_equal(panel_init(rig.display.panel), -ETIMEDOUT);
    assert_text("0xf8");
    assert_in_range(rig.bridge.cable.now_ms - before_ms, BRIDGE_PATIENCE_MS, BRIDGE_PATIENCE_MS + 50);
    rig.bridge.chip.busy_every = 0;
    assert_int_equal(bridge_rig_start(&rig, 1), 0);
    bridge_rig_assert_shown(&rig, 1);
}

/* What an earlier program left unread is read away. */
static void stale_answers_are_not_taken_for_ours(void **state)
{
    uint8_t stale[MCP2210_REPORT_B] = {0x11, 0x00};
    (void)state;
    bridge_rig_setup(&rig, "st7735", 24, 20);
    emulated_cable_push(&rig.bridge.cable, stale, sizeof stale);
    stale[0] = 0x10;
    stale[3] = 7; /* no such owner of the bus */
    emulated_cable_push(&rig.bridge.cable, stale, sizeof stale);
    const struct bridge_link link = emulated_bridge_link(&rig.bridge);
    const struct bridge_options options = emulated_bridge_options(&rig.bridge);
    assert_int_equal(bridge_port_open(&port, &link, &options), 0);
    bridge_rig_connect(&rig, &port);
    stale[0] = 0x21; /* of a command that comes no more */
    emulated_cable_push(&rig.bridge.cable, stale, sizeof stale);
    assert_int_equal(bridge_rig_start(&rig, 1), 0);
    bridge_rig_assert_shown(&rig, 1);
    bridge_rig_assert_quiet(&rig);
}

/* Answers that no MCP2210 gives: one byte of those to one command is another. */
static struct twist {
    uint8_t command, at, value;
} twist;

static bool answer_twisted(void *chip, const uint8_t *report, uint8_t *answer)
{
    emulated_mcp2210_answer(chip, report, answer);
    if (report[0] == twist.command) answer[twist.at] = twist.value;
    return true;
}

static void answers_of_something_else_are_refused(void **state)
{
    static const struct {
        struct twist twist;
        bool at_opening;
        const char *text;
    } cases[] = {{{0x10, 3, 7}, true, "not that of an MCP2210"},
                 {{0x10, 2, 9}, true, "not that of an MCP2210"},
                 {{0x10, 1, 0xF9}, true, "status 0xf9 to command 0x10"},
                 {{0x21, 1, 0xFB}, true, "status 0xfb to command 0x21"},
                 {{0x40, 1, 0xF9}, false, "status 0xf9 to command 0x40"},
                 {{0x42, 3, 0x55}, false, "unknown state 0x55"},
                 {{0x42, 3, 0x10}, false, "bytes early"}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bridge_rig_setup(&rig, "st7735", 24, 20);
        twist = cases[i].twist;
        rig.bridge.cable.answer = answer_twisted;
        const struct bridge_link link = emulated_bridge_link(&rig.bridge);
        const struct bridge_options options = emulated_bridge_options(&rig.bridge);
        int err = bridge_port_open(&port, &link, &options);
        assert_int_equal(!err, !cases[i].at_opening);
        if (!err) err = send(100);
        assert_int_equal(err, -EPROTO);
        assert_text(cases[i].text);
        port_close(&port);
    }
}

static bool answer_stuck(void *chip, const uint8_t *report, uint8_t *answer)
{
    if (report[0] != 0x42) return emulated_mcp2210_answer(chip, report, answer);
    memset(answer, 0, MCP2210_REPORT_B);
    answer[0] = 0x42;
    answer[3] = 0x30;
    return true;
}

static void a_transfer_without_end_is_given_up(void **state)
{
    (void)state;
    open_port("st7735", 24, 20);
    rig.bridge.cable.answer = answer_stuck;
    assert_int_equal(send(1), -ETIMEDOUT);
    assert_text("does not end");
    rig.bridge.cable.answer = emulated_mcp2210_answer;
    assert_int_equal(send(1), 0);
    bridge_rig_assert_quiet(&rig);
}

/* Options ---------------------------------------------------------------------------------- */

static void pins_that_a_bridge_does_not_have_are_refused(void **state)
{
    static const struct {
        struct bridge_options options;
        const char *text;
    } cases[] = {{{.dc = "GP9"}, "GP9: no such pin"},
                 {{.dc = "GPIO25"}, "GPIO25: no such pin; bridges have GP0 to GP8"},
                 {{.dc = ""}, "no such pin"},
                 {{.dc = "GP1", .reset = "GP1"}, "GP1: named twice"},
                 {{.dc = "GP1", .chip_select = "GP1"}, "GP1: named twice"},
                 {{.dc = "GP1", .mode = 4}, "SPI modes 0 to 3"},
                 {{.dc = "GP1", .bit_rate_hz = 1499}, "from 1500 Hz"}};
    (void)state;
    bridge_rig_setup(&rig, "st7735", 24, 20);
    const struct bridge_link link = emulated_bridge_link(&rig.bridge);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(bridge_port_open(&port, &link, &cases[i].options), -EINVAL);
        assert_text(cases[i].text);
        assert_null(port.close);
    }
    assert_int_equal(rig.bridge.cable.reports, 0);
}

static void settings_reach_the_bridge(void **state)
{
    (void)state;
    bridge_rig_setup(&rig, "st7735", 24, 20);
    rig.bridge.chip.inputs = 0x0FF;
    rig.bridge.chip.functions[8] = 0; /* an output, high, of somebody else's */
    const struct bridge_link link = emulated_bridge_link(&rig.bridge);
    const struct bridge_options options = {
        .dc = "GP0", .reset = "GP1", .select = "GP3", .bit_rate_hz = 1234567, .mode = 3};
    assert_int_equal(bridge_port_open(&port, &link, &options), 0);
    assert_int_equal(send(1), 0);
    const struct emulated_mcp2210 *chip = &rig.bridge.chip;
    assert_int_equal(port.bus.message_b, 2 * 60); /* two reports */
    assert_int_equal(chip->bit_rate_hz, 1234567);
    assert_int_equal(chip->mode, 3);
    assert_int_equal(chip->levels, 0x1FF & ~0x009);
    assert_int_equal(chip->inputs, 0x0FF & ~0x00B);
    assert_int_equal(chip->functions[2], 2);
    assert_int_equal(chip->functions[3], 0);
    assert_false(pin_is_wired(&port.backlight));
    assert_int_equal(pin_set(&port.select, true), 0);
    assert_int_equal(chip->levels, 0x1FF & ~0x001);
    bridge_rig_assert_quiet(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(frames_arrive_whole, close_port_after),
        cmocka_unit_test_teardown(a_bridge_in_a_mood_is_borne_with, close_port_after),
        cmocka_unit_test_teardown(a_frame_takes_as_few_reports_as_it_can, close_port_after),
        cmocka_unit_test_teardown(long_streams_are_cut_where_reports_are_full, close_port_after),
        cmocka_unit_test_teardown(a_length_that_is_set_is_not_set_again, close_port_after),
        cmocka_unit_test_teardown(bytes_leave_before_a_pin_changes, close_port_after),
        cmocka_unit_test_teardown(whatever_happens_to_a_report_is_told_and_overcome, close_port_after),
        cmocka_unit_test_teardown(an_opening_that_fails_opens_nothing, close_port_after),
        cmocka_unit_test_teardown(a_bus_that_another_master_has_is_reported, close_port_after),
        cmocka_unit_test_teardown(a_bridge_busy_for_ever_is_given_up, close_port_after),
        cmocka_unit_test_teardown(stale_answers_are_not_taken_for_ours, close_port_after),
        cmocka_unit_test_teardown(answers_of_something_else_are_refused, close_port_after),
        cmocka_unit_test_teardown(a_transfer_without_end_is_given_up, close_port_after),
        cmocka_unit_test_teardown(pins_that_a_bridge_does_not_have_are_refused, close_port_after),
        cmocka_unit_test_teardown(settings_reach_the_bridge, close_port_after),
    };
    return cmocka_run_group_tests_name("mcp2210", tests, NULL, NULL);
}
