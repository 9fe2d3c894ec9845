/* SPDX-License-Identifier: MIT
 *
 * The CH347T's protocol, as far as programs of others show it, against an emulated one and emulated displays: frames
 * arrive whole, and errors at any report come through and are overcome. Whether a real one agrees nobody has tried. */
#include "fakes/fake_hidapi.h"
#include "hid/ch347.h"
#include "hid/hid_port.h"
#include "rigs/bridge_rig.h"
#include "rigs/cmocka_ready.h"

#include <errno.h>
#include <string.h>

static struct bridge_rig rig;
static struct port port;

static int open_port(const char *panel, uint16_t w_px, uint16_t h_px, uint32_t bit_rate_hz, uint8_t mode)
{
    bridge_rig_setup(&rig, panel, w_px, h_px);
    emulated_bridge_init_ch347(&rig.bridge, rig.glass.port);
    const struct bridge_link link = emulated_bridge_link(&rig.bridge);
    struct bridge_options options = emulated_bridge_options(&rig.bridge);
    options.bit_rate_hz = bit_rate_hz;
    options.mode = mode;
    const int err = bridge_port_open(&port, &link, &options);
    if (!err) bridge_rig_connect(&rig, &port);
    return err;
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
}

static void frames_arrive_whole(void **state)
{
    static const char *const panels[] = {"st7735", "ssd1306", "st7789:rgb444"};
    (void)state;
    for (size_t i = 0; i < sizeof panels / sizeof *panels; i++) {
        assert_int_equal(open_port(panels[i], 96, 64, 0, 0), 0);
        rig.bridge.cable.empty_every = 3;
        for (unsigned picture = 0; picture < 3; picture++) {
            assert_int_equal(picture ? bridge_rig_draw(&rig, picture) : bridge_rig_start(&rig, 0), 0);
            bridge_rig_assert_shown(&rig, picture);
        }
        bridge_rig_assert_quiet(&rig);
        port_close(&port);
    }
}

static void clock_and_mode_are_set(void **state)
{
    static const struct {
        uint32_t hz;
        uint8_t clock;
    } cases[] = {{0, 0}, {60000000, 0}, {59999999, 1}, {27000000, 2}, {937500, 6}, {468750, 7}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(open_port("st7735", 24, 9, cases[i].hz, (uint8_t)(i % 4)), 0);
        assert_int_equal(rig.bridge.ch347.clock, cases[i].clock);
        assert_int_equal(rig.bridge.ch347.mode, i % 4);
        port_close(&port);
    }
    assert_int_equal(open_port("st7735", 24, 9, 468749, 0), -EINVAL);
    assert_int_equal(open_port("st7735", 24, 9, 0, 4), -EINVAL);
    assert_text("outputs GP3 to GP7");
    const struct bridge_link link = emulated_bridge_link(&rig.bridge);
    assert_int_equal(bridge_port_open(&port, &link, &(struct bridge_options){.dc = "GP1"}), -EINVAL);
    assert_int_equal(bridge_port_open(&port, &link, &(struct bridge_options){.dc = "GP3", .chip_select = "GP4"}),
                     -EINVAL);
}

/* Returns whether report n was sent at all. */
static bool survives(long n, enum cable_fault fault)
{
    const int code = -7000 - (int)n;
    const int expected = fault == CABLE_UNPLUGGED ? -ENODEV : fault <= CABLE_UNREAD ? code : -ETIMEDOUT;

    assert_int_equal(open_port("st7735", 24, 9, 0, 0), 0);
    emulated_cable_arm(&rig.bridge.cable, n, fault, code);
    const int err = bridge_rig_start(&rig, 0);
    const bool faulted = rig.bridge.cable.faulted;
    if (err != (faulted ? expected : 0)) fail_msg("fault %d at report %ld: %d", (int)fault, n, err);
    if (faulted) {
        assert_text("emulated CH347T: ");
        emulated_cable_arm(&rig.bridge.cable, CABLE_NEVER, fault, 0);
        if (fault == CABLE_UNPLUGGED) emulated_bridge_replug(&rig.bridge);
        assert_int_equal(bus_flush(&port.bus), 0);
        bridge_rig_forgive(&rig);
        assert_int_equal(bridge_rig_start(&rig, 1), 0);
        bridge_rig_assert_shown(&rig, 1);
        bridge_rig_assert_quiet(&rig);
    }
    port_close(&port);
    return faulted;
}

static void whatever_happens_to_a_report_is_told_and_overcome(void **state)
{
    static const enum cable_fault faults[] = {CABLE_REFUSED, CABLE_UNREAD, CABLE_LOST,
                                              CABLE_LATE,    CABLE_CUT,    CABLE_UNPLUGGED};
    (void)state;
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        long n = 0;
        while (survives(n, faults[i]))
            n++;
        assert_true(n > 40);
    }
}

/* Also what no flush has sent. */
static void bytes_leave_before_a_pin_changes(void **state)
{
    static const uint8_t byte;
    (void)state;
    assert_int_equal(open_port("st7735", 24, 9, 0, 0), 0);
    assert_int_equal(bus_write(&port.bus, &byte, 1), 0);
    assert_int_equal(pin_set(&port.dc, true), 0);
    assert_int_equal(rig.bridge.ch347.bus_b, 1);
    bridge_rig_assert_quiet(&rig);
}

/* Where the display keeps its power. */
static void pins_keep_their_levels_after_an_error(void **state)
{
    (void)state;
    assert_int_equal(open_port("st7735", 24, 9, 0, 0), 0);
    assert_int_equal(bridge_rig_start(&rig, 0), 0);
    emulated_cable_arm(&rig.bridge.cable, 8, CABLE_LOST, 0);
    assert_int_equal(bridge_rig_draw(&rig, 1), -ETIMEDOUT);
    assert_int_equal(bridge_rig_draw(&rig, 2), 0);
    bridge_rig_forgive(&rig);
    bridge_rig_assert_shown(&rig, 2);
}

/* A pin that stays what it is, settings that are refused. */
static bool answer_wrongly(void *chip, const uint8_t *report, uint8_t *answer)
{
    const bool answered = emulated_ch347_answer(chip, report, answer);

    answer[5] ^= report[2] == 0xC0;
    answer[5 + 3] ^= report[2] == 0xCC ? 0x40 : 0;
    return answered;
}

static void a_bridge_that_does_not_follow_is_told(void **state)
{
    (void)state;
    assert_int_equal(open_port("st7735", 24, 9, 0, 0), 0);
    rig.bridge.cable.answer = answer_wrongly;
    assert_int_equal(pin_set(&port.dc, true), -EPROTO);
    assert_text("GP3 does not follow");
    assert_int_equal(bus_flush(&port.bus), -EPROTO);
    assert_text("refuses its SPI settings with 0x01");
    rig.bridge.cable.answer = emulated_ch347_answer;
    assert_int_equal(bridge_rig_start(&rig, 2), 0);
    bridge_rig_forgive(&rig);
    bridge_rig_assert_shown(&rig, 2);
}

/* Of its interfaces one is SPI; the other looks alike. */
static void hidapi_finds_it_by_its_interface(void **state)
{
    static struct emulated_cable serial_port;
    (void)state;
    bridge_rig_setup(&rig, "st7735", 24, 9);
    emulated_bridge_init_ch347(&rig.bridge, rig.glass.port);
    serial_port = rig.bridge.cable;
    fake_hidapi = (struct fake_hidapi){
        .places = {{.cable = &serial_port, .path = "/dev/hidraw0", .serial = L"7"},
                   {.cable = &rig.bridge.cable, .path = "/dev/hidraw1", .serial = L"7", .interface = 1}}};
    const struct bridge_options options = emulated_bridge_options(&rig.bridge);
    assert_int_equal(hid_port_open(&port, "7", &options), 0);
    port.clock = emulated_port_clock(rig.glass.port);
    bridge_rig_connect(&rig, &port);
    assert_int_equal(bridge_rig_start(&rig, 1), 0);
    bridge_rig_assert_shown(&rig, 1);
    rig.bridge.cable.unplugged = true;
    assert_int_equal(bus_flush(&port.bus), 0);
    assert_int_equal(bridge_rig_draw(&rig, 0), -ENODEV);
    assert_text("CH347T 7: unplugged");
    assert_int_equal(serial_port.reports, 0);
}

static void what_the_notes_do_not_have_is_complained_about(void **state)
{
    static const uint8_t mistakes[][12] = {{3, 0, 0x99},
                                           {4, 0, 0xC4, 0, 0},         /* lengths differ */
                                           {29, 0, 0xC0, 26, 0, 1},    /* bytes of settings */
                                           {13, 0, 0xC1, 10, 0, 0x40}, /* no such state */
                                           {4, 0, 0xC4, 1, 0, 0x55},   /* not set up, not selected */
                                           {11, 0, 0xCC, 8, 0, 0xF0}}; /* a pin of SPI's */
    (void)state;
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++) {
        uint8_t report[EMULATED_CH347_REPORT_B] = {0}, answer[EMULATED_CH347_REPORT_B];
        struct emulated_ch347 chip;
        emulated_ch347_init(&chip);
        memcpy(report, mistakes[i], sizeof mistakes[i]);
        emulated_ch347_answer(&chip, report, answer);
        if (!chip.complaints) fail_msg("mistake %zu went unnoticed", i);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(frames_arrive_whole, close_port_after),
        cmocka_unit_test_teardown(clock_and_mode_are_set, close_port_after),
        cmocka_unit_test_teardown(whatever_happens_to_a_report_is_told_and_overcome, close_port_after),
        cmocka_unit_test_teardown(bytes_leave_before_a_pin_changes, close_port_after),
        cmocka_unit_test_teardown(pins_keep_their_levels_after_an_error, close_port_after),
        cmocka_unit_test_teardown(a_bridge_that_does_not_follow_is_told, close_port_after),
        cmocka_unit_test_teardown(hidapi_finds_it_by_its_interface, close_port_after),
        cmocka_unit_test(what_the_notes_do_not_have_is_complained_about),
    };
    return cmocka_run_group_tests_name("ch347", tests, NULL, NULL);
}
