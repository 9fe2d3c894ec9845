/* SPDX-License-Identifier: MIT
 *
 * The wire by itself: in which order bytes leave, D/C and reset change and time passes, and that whatever fails ends a
 * call with its code, after which the level of D/C is set anew. */
#include "panel.h"
#include "rigs/cmocka_ready.h"
#include "wire.h"

#include <stdio.h>
#include <string.h>

/* Events as text: bytes in hexadecimal with a stop behind each message, f: flush; c, d: D/C low and high; r, R: reset;
 * t: time in us. The one with number fail_at fails. */
static struct {
    char text[256];
    int events, fail_at;
} seen;

static int code_of(int event)
{
    return -100 - event;
}

static int event(const char *text)
{
    strncat(seen.text, text, sizeof seen.text - strlen(seen.text) - 1);
    return seen.events++ == seen.fail_at ? code_of(seen.fail_at) : 0;
}

static int write(void *ctx, const uint8_t *data, size_t n_b)
{
    char text[80] = "";

    (void)ctx;
    for (size_t i = 0; i < n_b; i++)
        snprintf(text + 2 * i, sizeof text - 2 * i, "%02x", data[i]);
    strcat(text, ".");
    return event(text);
}

static int flush(void *ctx)
{
    (void)ctx;
    return event("f");
}

static int set(void *ctx, bool high)
{
    const char *texts = ctx;
    return event(high ? texts + 2 : texts);
}

static int delay(void *ctx, uint32_t delay_us)
{
    char text[16];

    (void)ctx;
    snprintf(text, sizeof text, "t%u", (unsigned)delay_us);
    return event(text);
}

static struct wire wire;
static char dc_texts[] = "c\0d", reset_texts[] = "r\0R";
static const struct pin reset = {reset_texts, set};
static const struct clock passing = {NULL, delay};

static void begin(bool args_low, int fail_at)
{
    wire = (struct wire){.bus = {.write = write, .flush = flush}, .dc = {dc_texts, set}, .args_low = args_low};
    memset(&seen, 0, sizeof seen);
    seen.fail_at = fail_at;
}

static const uint8_t bytes[] = {0x2A, 1, 2, 0x2C, 0, 0x2B, 3, 4, 5, 6};

static int do_begin(void)
{
    return wire_begin(&wire);
}

static int do_command(void)
{
    return wire_command(&wire, bytes, 2);
}

static int do_data(void)
{
    return wire_data(&wire, bytes, 3);
}

static int do_send(void)
{
    return wire_send(&wire, 0x36, bytes, 2);
}

static int do_send_alone(void)
{
    return wire_send(&wire, 0x36, NULL, 0);
}

static int do_list(void)
{
    static const uint8_t list[] = {0x2A, 2, 7, 8, 0x2C, 0, 0x2B, 1, 9};
    return wire_send_list(&wire, list, sizeof list);
}

static int do_no_list(void)
{
    return wire_send_list(&wire, bytes, 0);
}

static int do_reset(void)
{
    return wire_reset(&reset, &passing, 5000);
}

static int do_flush(void)
{
    return wire_flush(&wire);
}

static int do_pixels(void)
{
    wire_open(&wire, 3);
    return wire_pixels(&wire, PANEL_RGB565, bytes, 3);
}

static const struct {
    int (*run)(void);
    bool args_low;
    const char *text; /* what is seen */
} calls[] = {
    {do_begin, false, "f"},
    {do_command, false, "fc2a01.f"},
    {do_data, false, "fd2a0102."},
    {do_send, false, "fc36.ffd2a01.f"},
    {do_send, true, "fc36.f2a01.f"},
    {do_send_alone, false, "fc36.f"},
    {do_list, false, "fc2a.ffd0708.ffc2c.f2b.ffd09.f"},
    {do_no_list, false, ""},
    {do_reset, false, "rt100Rt5000"},
    {do_flush, false, "f"},
    {do_pixels, false, "fd2a01022c002b."},
};

static void everything_comes_in_order(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        begin(calls[i].args_low, -1);
        assert_int_equal(calls[i].run(), 0);
        assert_string_equal(seen.text, calls[i].text);
    }
}

/* Nothing more happens then, and what comes next begins with D/C. */
static void what_fails_ends_the_call_with_its_code(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        begin(calls[i].args_low, -1);
        assert_int_equal(calls[i].run(), 0);
        const int events = seen.events;
        for (int n = 0; n < events; n++) {
            begin(calls[i].args_low, n);
            assert_int_equal(calls[i].run(), code_of(n));
            assert_int_equal(seen.events, n + 1);
            assert_memory_equal(seen.text, calls[i].text, strlen(seen.text));
            assert_int_equal(wire.left_px, 0);
        }
    }
}

static void a_level_that_is_known_is_not_set_again(void **state)
{
    (void)state;
    begin(false, -1);
    assert_int_equal(wire_command(&wire, bytes, 1), 0);
    assert_int_equal(wire_command(&wire, bytes, 1), 0);
    assert_int_equal(wire_data(&wire, bytes, 1), 0);
    assert_int_equal(wire_data(&wire, bytes, 1), 0);
    assert_string_equal(seen.text, "fc2a.f2a.ffd2a.2a.");
    assert_int_equal(wire_begin(&wire), 0);
    assert_int_equal(wire_data(&wire, bytes, 1), 0);
    assert_string_equal(seen.text, "fc2a.f2a.ffd2a.2a.ffd2a.");
}

/* The flush before the change, or the change itself: the pin may be at either level. */
static void a_level_whose_change_failed_is_set_again(void **state)
{
    (void)state;
    for (int n = 4; n < 6; n++) {
        begin(false, n);
        assert_int_equal(wire_command(&wire, bytes, 1), 0);
        assert_int_equal(wire_data(&wire, bytes, 1), code_of(n));
        seen.text[0] = '\0';
        assert_int_equal(wire_command(&wire, bytes, 1), 0);
        assert_string_equal(seen.text, "fc2a.f");
    }
}

static void a_command_that_failed_is_cut_until_one_is_whole(void **state)
{
    (void)state;
    for (int n = 0; n < 8; n++) {
        begin(false, n);
        assert_int_equal(wire_send(&wire, 0x36, bytes, 2), code_of(n));
        assert_true(wire.cut);
        assert_int_equal(wire_send(&wire, 0x36, bytes, 2), 0);
        assert_false(wire.cut);
    }
    assert_int_equal(wire_begin(&wire), 0);
    assert_true(wire.cut);
}

static void a_window_takes_as_many_pixels_as_it_has(void **state)
{
    (void)state;
    begin(false, -1);
    assert_int_equal(wire_pixels(&wire, PANEL_RGB565, bytes, 1), PANEL_ERR_WINDOW);
    assert_string_equal(seen.text, "");
    wire_open(&wire, 3);
    assert_int_equal(wire_pixels(&wire, PANEL_RGB565, bytes, 2), 0);
    assert_int_equal(wire.left_px, 1);
    assert_int_equal(wire_pixels(&wire, PANEL_RGB565, bytes, 2), PANEL_ERR_WINDOW);
    assert_int_equal(wire_pixels(&wire, PANEL_RGB565, bytes, 1), PANEL_ERR_WINDOW); /* closed */
    wire_open(&wire, 1);
    assert_int_equal(wire_pixels(&wire, PANEL_RGB565, bytes, 1), 0);
    assert_int_equal(wire.left_px, 0);
    assert_string_equal(seen.text, "fd2a01022c.2a01.");
    int (*const closing[])(void) = {do_begin, do_send_alone};
    for (size_t i = 0; i < 2; i++) {
        wire_open(&wire, 1);
        assert_int_equal(closing[i](), 0);
        assert_int_equal(wire.left_px, 0);
    }
    wire_open(&wire, 1);
    assert_int_equal(wire_flush(&wire), 0);
    assert_int_equal(wire.left_px, 1);
    seen.fail_at = seen.events;
    assert_int_equal(wire_flush(&wire), code_of(seen.fail_at));
    assert_int_equal(wire.left_px, 0);
}

static void a_pin_that_is_not_wired_is_not_set(void **state)
{
    (void)state;
    begin(false, -1);
    assert_int_equal(wire_set(&(struct pin){0}, true), 0);
    assert_string_equal(seen.text, "");
    assert_int_equal(wire_set(&reset, true), 0);
    assert_int_equal(wire_set(&reset, false), 0);
    assert_string_equal(seen.text, "Rr");
    seen.fail_at = 2;
    assert_int_equal(wire_set(&reset, true), code_of(2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_comes_in_order),
        cmocka_unit_test(what_fails_ends_the_call_with_its_code),
        cmocka_unit_test(a_level_that_is_known_is_not_set_again),
        cmocka_unit_test(a_level_whose_change_failed_is_set_again),
        cmocka_unit_test(a_command_that_failed_is_cut_until_one_is_whole),
        cmocka_unit_test(a_window_takes_as_many_pixels_as_it_has),
        cmocka_unit_test(a_pin_that_is_not_wired_is_not_set),
    };
    return cmocka_run_group_tests_name("wire", tests, NULL, NULL);
}
