/* SPDX-License-Identifier: MIT
 *
 * Lines of QEMU's trace, by hand: how each idiom of registers sets a wire, and which lines and addresses are not meant.
 */
#include "glass/qemu_trace.h"
#include "rigs/cmocka_ready.h"

#include <stdio.h>
#include <string.h>

static struct listener listener; /* too large for a stack; every test sets it up afresh */

static const struct qemu_map MAP = {
    .registers = {{.idiom = QEMU_SPI, .address = 0x4001300C},
                  {.idiom = QEMU_BSRR, .address = 0x40010810, .pin = LISTENER_DC, .bit = 2},
                  {.idiom = QEMU_CLEAR, .address = 0x40010814, .pin = LISTENER_DC, .bit = 2},
                  {.idiom = QEMU_MASKED, .address = 0x40006000, .pin = LISTENER_CS, .bit = 7},
                  {.idiom = QEMU_OUTPUT, .address = 0x1001200C, .pin = LISTENER_LED, .bit = 31}},
    .count = 5,
};

static int start(void **state)
{
    struct module_choice choice = {.module = {.w_px = 2, .h_px = 1}};
    (void)state;
    assert_true(panel_choice_parse("st7789", NULL, &choice.panel, &(struct error){0}));
    listener_init(&listener, &choice);
    return 0;
}

static void write_register(uint64_t address, uint32_t value)
{
    struct error err;
    char line[128];
    snprintf(line, sizeof line, "memory_region_ops_write cpu 0 mr 0x55d4 addr 0x%llx value 0x%x size 4 name 'port'",
             (unsigned long long)address, value);
    assert_true(qemu_trace_is(line));
    if (!qemu_trace_take(&MAP, &listener, line, &err)) fail_msg("%s", err.text);
}

static void assert_level_after(enum listener_pin pin, uint64_t address, uint32_t value, bool high)
{
    write_register(address, value);
    assert_int_equal(listener.is_high[pin], high);
}

static void bsrr_sets_by_the_lower_half_and_resets_by_the_upper(void **state)
{
    (void)state;
    assert_level_after(LISTENER_DC, 0x40010810, 0x00000004, true);
    assert_level_after(LISTENER_DC, 0x40010810, 0x0000FFFB, true);
    assert_level_after(LISTENER_DC, 0x40010810, 0x00040000, false);
    assert_level_after(LISTENER_DC, 0x40010810, 0x00040004, true);
    assert_level_after(LISTENER_DC, 0x40010810, 0xFFFBFFFB, true);
    assert_level_after(LISTENER_DC, 0x40010818, 0x00040000, true);
}

static void clear_resets_where_there_are_ones(void **state)
{
    (void)state;
    assert_level_after(LISTENER_DC, 0x40010810, 0x00000004, true);
    assert_level_after(LISTENER_DC, 0x40010814, 0x0000FFFB, true);
    assert_level_after(LISTENER_DC, 0x40010814, 0x00000004, false);
}

static void masked_changes_what_the_address_says(void **state)
{
    (void)state;
    assert_level_after(LISTENER_CS, 0x40006200, 0x80, true);
    assert_level_after(LISTENER_CS, 0x400061FC, 0x00, true);
    assert_level_after(LISTENER_CS, 0x40006200, 0x7F, false);
    assert_level_after(LISTENER_CS, 0x400063FC, 0xFF, true);
    assert_level_after(LISTENER_CS, 0x40006000, 0x00, true);
    assert_level_after(LISTENER_CS, 0x40006400, 0x00, true);
}

static void output_is_all_the_levels(void **state)
{
    (void)state;
    assert_level_after(LISTENER_LED, 0x1001200C, 0x80000000, true);
    assert_level_after(LISTENER_LED, 0x1001200C, 0x7FFFFFFF, false);
    assert_level_after(LISTENER_LED, 0x10012010, 0x80000000, false);
}

static void the_data_register_sends_a_byte_of_any_write(void **state)
{
    (void)state;
    write_register(0x4001300C, 0x01);
    write_register(0x4001300C, 0xFFFFFF01);
    write_register(0x40013008, 0x01);
    assert_int_equal(listener.display.port->bus_b, 2);
    assert_true(emulated_display_is_quiet(&listener.display, &(struct error){0}));
}

static void a_frame_of_registers_ends_like_any(void **state)
{
    static const uint8_t commands[] = {0x11, 0x29, 0x2C}, pixel[] = {0xF8, 0, 0xF8};
    (void)state;
    for (size_t i = 0; i < sizeof commands; i++)
        write_register(0x4001300C, commands[i]);
    write_register(0x40010810, 4);
    for (size_t i = 0; i < sizeof pixel; i++)
        write_register(0x4001300C, pixel[i]);
    write_register(0x1001200C, 0x80000000);
    assert_int_equal(listener.frames, 1);
    assert_int_equal(listener.frame_bus_b, 6);
}

static void only_writes_are_of_a_trace(void **state)
{
    (void)state;
    assert_true(qemu_trace_is("77@1700000000.125:memory_region_ops_write cpu 0 mr 0x1 addr 0x1 value 0x1 size 4"));
    assert_false(qemu_trace_is("memory_region_ops_read cpu 0 mr 0x1 addr 0x1 value 0x1 size 4"));
    assert_false(qemu_trace_is("77 frames"));
    assert_false(qemu_trace_is("77@home: memory_region_ops_write"));
    assert_false(qemu_trace_is(""));
}

static void a_torn_line_is_an_error(void **state)
{
    static const char *const lines[] = {
        "memory_region_ops_write ",
        "memory_region_ops_write cpu 0 mr 0x1 addr 0x4001300c value",
        "memory_region_ops_write cpu 0 mr 0x1 addr 0x value 0x2c size 1",
        "memory_region_ops_write cpu 0 mr 0x1 addr 0x4001300c value 0x2cmemory_region_ops_write cpu 0",
    };
    struct error err;
    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        assert_false(qemu_trace_take(&MAP, &listener, lines[i], &err));
        assert_non_null(strstr(err.text, "without addr or value"));
    }
    assert_int_equal(listener.display.port->bus_b, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(bsrr_sets_by_the_lower_half_and_resets_by_the_upper, start),
        cmocka_unit_test_setup(clear_resets_where_there_are_ones, start),
        cmocka_unit_test_setup(masked_changes_what_the_address_says, start),
        cmocka_unit_test_setup(output_is_all_the_levels, start),
        cmocka_unit_test_setup(the_data_register_sends_a_byte_of_any_write, start),
        cmocka_unit_test_setup(a_frame_of_registers_ends_like_any, start),
        cmocka_unit_test_setup(only_writes_are_of_a_trace, start),
        cmocka_unit_test_setup(a_torn_line_is_an_error, start),
    };
    return cmocka_run_group_tests_name("QEMU's trace", tests, NULL, NULL);
}
