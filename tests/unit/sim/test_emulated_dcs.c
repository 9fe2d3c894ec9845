/* SPDX-License-Identifier: MIT
 *
 * An emulated chip itself, an ST7789, fed by hand: each violation of the protocol is noticed, once, and
 * called by its name; formats, windows and resets do what the datasheet says. */
#include "rigs/panels/dcs_rig.h"

/* The chip below the driver: bytes by hand. */
static void chip_start(bool awake)
{
    power_chip(module_240x240);
    rig.bus = emulated_port_bus(&rig.chip.port);
    rig.dc = emulated_port_dc(&rig.chip.port);
    rig.reset = emulated_port_reset(&rig.chip.port);
    rig.clock = emulated_port_clock(&rig.chip.port);
    assert_int_equal(clock_delay(&rig.clock, 120000), 0);
    if (!awake) return;
    uint8_t slpout = 0x11;
    assert_int_equal(pin_set(&rig.dc, false), 0);
    assert_int_equal(bus_write(&rig.bus, &slpout, 1), 0);
    assert_int_equal(clock_delay(&rig.clock, 120000), 0);
}

static void chip_send(uint8_t command, const uint8_t *args, size_t n_b)
{
    assert_int_equal(pin_set(&rig.dc, false), 0);
    assert_int_equal(bus_write(&rig.bus, &command, 1), 0);
    assert_int_equal(pin_set(&rig.dc, true), 0);
    assert_int_equal(bus_write(&rig.bus, args, n_b), 0);
}

#define SEND(command, ...) chip_send(command, (const uint8_t[]){__VA_ARGS__}, sizeof((const uint8_t[]){__VA_ARGS__}))

static void chip_command(uint8_t command)
{
    chip_send(command, NULL, 0);
}

static void unknown_command_is_noticed_and_its_data_ignored(void **state)
{
    (void)state;
    chip_start(true);
    SEND(0xD9, 1, 2, 3);
    assert_complaint(EMULATED_UNKNOWN_COMMAND);
}

static void command_with_too_few_arguments_is_noticed(void **state)
{
    (void)state;
    chip_start(true);
    SEND(0x2A, 0, 0, 0);
    assert_quiet();
    chip_command(0x00);
    assert_complaint(EMULATED_ARGS_SHORT);
}

static void command_with_too_many_arguments_is_noticed_once(void **state)
{
    (void)state;
    chip_start(true);
    SEND(0x2A, 0, 0, 0, 1, 9, 9, 9);
    assert_complaint(EMULATED_ARGS_EXTRA);
}

static void pixels_without_ramwr_are_noticed(void **state)
{
    (void)state;
    chip_start(true);
    SEND(0x00, 0xF8, 0x00);
    assert_complaint(EMULATED_ARGS_EXTRA);
    chip_start(false);
    uint8_t pixel[] = {0xF8, 0x00};
    assert_int_equal(pin_set(&rig.dc, true), 0);
    assert_int_equal(bus_write(&rig.bus, pixel, 2), 0);
    assert_complaint(EMULATED_ARGS_EXTRA);
}

static void undefined_argument_values_are_noticed(void **state)
{
    (void)state;
    chip_start(true);
    SEND(0x3A, 0x54);
    assert_complaint(EMULATED_ARGS_VALUE);
    chip_start(true);
    SEND(0x36, 0x01);
    assert_complaint(EMULATED_ARGS_VALUE);
}

static void ranges_beyond_memory_or_backwards_are_noticed(void **state)
{
    (void)state;
    static const struct {
        uint8_t madctl, command, args[4];
        bool bad;
    } ranges[] = {
        {0x00, 0x2A, {0, 0, 0, 239}, false}, {0x00, 0x2A, {0, 0, 0, 240}, true}, {0x00, 0x2B, {0, 0, 1, 63}, false},
        {0x00, 0x2B, {0, 0, 1, 64}, true},   {0x00, 0x2A, {0, 5, 0, 4}, true},   {0x00, 0x2A, {0, 5, 0, 5}, false},
        {0x20, 0x2A, {0, 0, 1, 63}, false},  {0x20, 0x2A, {0, 0, 1, 64}, true},  {0x20, 0x2B, {0, 0, 0, 239}, false},
        {0x20, 0x2B, {0, 0, 0, 240}, true},  {0x20, 0x2B, {1, 0, 0, 239}, true},
    };
    for (unsigned i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        chip_start(true);
        chip_send(0x36, &ranges[i].madctl, 1);
        chip_send(ranges[i].command, ranges[i].args, 4);
        if (ranges[i].bad) assert_complaint(EMULATED_RANGE);
        if (!ranges[i].bad) assert_quiet();
    }
}

static void pixels_past_the_window_are_noticed_and_wrap_to_its_start(void **state)
{
    (void)state;
    chip_start(true);
    SEND(0x3A, 0x55);
    SEND(0x2A, 0, 7, 0, 8);
    SEND(0x2B, 0, 3, 0, 3);
    SEND(0x2C, 0, 1, 0, 2);
    assert_quiet();
    SEND(0x2C, 0, 1, 0, 2, 0, 3, 0, 4);
    assert_complaint(EMULATED_PIXELS_OUTSIDE);
    assert_int_equal(rig.chip.memory[3][7].raw, 3);
    assert_int_equal(rig.chip.memory[3][8].raw, 4);
}

static void window_that_an_exchange_of_axes_made_invalid_is_noticed(void **state)
{
    (void)state;
    chip_start(true);
    SEND(0x2B, 0, 0, 1, 0x3F);
    SEND(0x36, 0x20);
    SEND(0x2C, 0, 0, 0);
    assert_complaint(EMULATED_PIXELS_OUTSIDE);
}

static void ramwrc_continues_where_ramwr_stopped_and_needs_one(void **state)
{
    (void)state;
    chip_start(true);
    SEND(0x3A, 0x55);
    SEND(0x2A, 0, 7, 0, 8);
    SEND(0x2B, 0, 3, 0, 4);
    SEND(0x2C, 0, 1, 0, 2, 0, 3);
    SEND(0x3C, 0, 4);
    assert_quiet();
    assert_int_equal(rig.chip.memory[4][7].raw, 3);
    assert_int_equal(rig.chip.memory[4][8].raw, 4);
    SEND(0x2C, 0, 9); /* starts again */
    assert_int_equal(rig.chip.memory[3][7].raw, 9);
    chip_start(true);
    SEND(0x3C, 0, 4);
    assert_complaint(EMULATED_PIXELS_OUTSIDE);
}

static void pixel_cut_by_a_command_is_noticed(void **state)
{
    (void)state;
    static const uint8_t pixels[] = {1, 2, 3, 4, 5};
    static const struct {
        uint8_t colmod;
        size_t n_b;
        bool bad;
    } cuts[] = {{0x55, 4, false}, {0x55, 5, true},  {0x66, 3, false}, {0x66, 4, true},
                {0x66, 5, true},  {0x03, 3, false}, {0x03, 4, true},  {0x03, 5, false}};
    for (unsigned i = 0; i < sizeof cuts / sizeof cuts[0]; i++) {
        chip_start(true);
        chip_send(0x3A, &cuts[i].colmod, 1);
        chip_send(0x2C, pixels, cuts[i].n_b);
        chip_command(0x00);
        if (cuts[i].bad) assert_complaint(EMULATED_PIXEL_SPLIT);
        if (!cuts[i].bad) assert_quiet();
    }
}

static void display_on_and_pixels_before_sleep_is_left_are_noticed(void **state)
{
    (void)state;
    chip_start(false);
    chip_command(0x29);
    assert_complaint(EMULATED_ASLEEP);
    chip_start(false);
    chip_command(0x2C);
    assert_complaint(EMULATED_ASLEEP);
}

/* After `first` and a wait, is `second` too soon? Limits are the datasheet's. */
static void check_wait(bool awake, uint8_t first, uint32_t limit_us, uint8_t second)
{
    for (uint32_t early = 0; early < 2; early++) {
        chip_start(awake);
        chip_command(first);
        assert_int_equal(clock_delay(&rig.clock, limit_us - early), 0);
        chip_command(second);
        if (early) assert_complaint(EMULATED_TOO_SOON);
        if (!early) assert_quiet();
    }
}

static void commands_too_soon_after_reset_or_sleep_are_noticed(void **state)
{
    (void)state;
    check_wait(true, 0x01, 5000, 0x00);    /* SWRESET: 5 ms to anything, */
    check_wait(true, 0x01, 120000, 0x11);  /* 120 ms to SLPOUT */
    check_wait(false, 0x11, 5000, 0x00);   /* SLPOUT: 5 ms to anything, */
    check_wait(false, 0x11, 120000, 0x10); /* 120 ms to SLPIN */
    check_wait(false, 0x11, 120000, 0x01); /* or SWRESET */
    check_wait(true, 0x10, 5000, 0x00);    /* SLPIN: the same */
    check_wait(true, 0x10, 120000, 0x11);
}

static void short_reset_pulse_and_bytes_during_reset_are_noticed(void **state)
{
    (void)state;
    chip_start(true);
    assert_int_equal(pin_set(&rig.reset, false), 0);
    assert_int_equal(clock_delay(&rig.clock, 9), 0);
    assert_int_equal(pin_set(&rig.reset, true), 0);
    assert_complaint(EMULATED_RESET);

    chip_start(true);
    assert_int_equal(pin_set(&rig.reset, false), 0);
    chip_command(0x00);
    assert_complaint(EMULATED_RESET);

    chip_start(true);
    chip_command(0x29);
    assert_int_equal(pin_set(&rig.reset, false), 0);
    assert_int_equal(clock_delay(&rig.clock, 10), 0);
    assert_int_equal(pin_set(&rig.reset, true), 0);
    assert_true(rig.chip.asleep && !rig.chip.display_on);
    assert_quiet();
    chip_command(0x00);
    assert_complaint(EMULATED_TOO_SOON);
}

static void count_call(void *ctx, const char *text)
{
    unsigned *calls = ctx;
    *calls += text[0] != '\0';
}

static void complaints_are_reported_to_a_callback(void **state)
{
    (void)state;
    unsigned calls = 0;
    chip_start(true);
    rig.chip.on_complaint = count_call;
    rig.chip.on_complaint_ctx = &calls;
    chip_command(0xFF);
    chip_command(0xFF);
    assert_int_equal(calls, 2);
    assert_int_equal(rig.chip.complaints, 2);
}

static void all_pixel_formats_are_decoded(void **state)
{
    (void)state;
    static const struct {
        uint8_t colmod, bytes[6];
        size_t n_b;
        struct emulated_pixel first, second;
    } formats[] = {
        {0x03, {0xF0, 0x80, 0xF8}, 3, {0xF08, {255, 0, 136}}, {0x0F8, {0, 255, 136}}},
        {0x55, {0xF8, 0x10, 0x07, 0xE1}, 4, {0xF810, {255, 0, 132}}, {0x07E1, {0, 255, 8}}},
        {0x66, {0xFC, 0x00, 0x80, 0x00, 0xFC, 0x04}, 6, {0xFC0080, {255, 0, 130}}, {0x00FC04, {0, 255, 4}}},
    };
    for (unsigned i = 0; i < 3; i++) {
        chip_start(true);
        chip_send(0x3A, &formats[i].colmod, 1);
        chip_send(0x2C, formats[i].bytes, formats[i].n_b);
        chip_command(0x00);
        assert_memory_equal(&rig.chip.memory[0][0], &formats[i].first, 7);
        assert_memory_equal(&rig.chip.memory[0][1], &formats[i].second, 7);
        assert_quiet();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unknown_command_is_noticed_and_its_data_ignored),
        cmocka_unit_test(command_with_too_few_arguments_is_noticed),
        cmocka_unit_test(command_with_too_many_arguments_is_noticed_once),
        cmocka_unit_test(pixels_without_ramwr_are_noticed),
        cmocka_unit_test(undefined_argument_values_are_noticed),
        cmocka_unit_test(ranges_beyond_memory_or_backwards_are_noticed),
        cmocka_unit_test(pixels_past_the_window_are_noticed_and_wrap_to_its_start),
        cmocka_unit_test(window_that_an_exchange_of_axes_made_invalid_is_noticed),
        cmocka_unit_test(ramwrc_continues_where_ramwr_stopped_and_needs_one),
        cmocka_unit_test(pixel_cut_by_a_command_is_noticed),
        cmocka_unit_test(display_on_and_pixels_before_sleep_is_left_are_noticed),
        cmocka_unit_test(commands_too_soon_after_reset_or_sleep_are_noticed),
        cmocka_unit_test(short_reset_pulse_and_bytes_during_reset_are_noticed),
        cmocka_unit_test(complaints_are_reported_to_a_callback),
        cmocka_unit_test(all_pixel_formats_are_decoded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
