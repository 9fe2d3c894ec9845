/* SPDX-License-Identifier: MIT
 *
 * Wire logs written by hand, and one written by the driver of every panel: what a listener makes of them is what the
 * glass shows; when a frame ends; whose bytes are whose; and who is held to the chip's waits. */
#include "glass/wire_log.h"
#include "rigs/cmocka_ready.h"
#include "rigs/panels/panel_rig.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct listener listener; /* too large for a stack; every test sets it up afresh */
static struct panel_rig rig;

/* Logs by hand --------------------------------------------------------------------------------- */

#define AWAKE "p dc 0\nb 11\np dc 0\nb 3A\np dc 1\nb 55\np dc 0\nb 29\np backlight 1\n"
#define WINDOW_2X1 "p dc 0\nb 2A\np dc 1\nb 00 00 00 01\np dc 0\nb 2B\np dc 1\nb 00 00 00 00\np dc 0\nb 2C\np dc 1\n"

static void take(const char *text)
{
    struct error err;
    char line[256];
    for (; *text; text += strcspn(text, "\n") + 1) {
        snprintf(line, sizeof line, "%.*s", (int)strcspn(text, "\n"), text);
        if (!wire_log_take(&listener, line, &err)) fail_msg("%s: %s", line, err.text);
    }
}

/* An ST7789 behind two pixels side by side. */
static void start(enum panel_rotation rotation)
{
    struct module_choice choice = {.module = {.w_px = 2, .h_px = 1, .rotation = rotation}};
    assert_true(panel_choice_parse("st7789", NULL, &choice.panel, &(struct error){0}));
    listener_init(&listener, &choice);
}

static void assert_shows(uint16_t first, uint16_t second)
{
    uint8_t rgb[6];
    uint16_t pixels[2];
    listener_read(&listener, rgb, pixels);
    assert_int_equal(pixels[0], first);
    assert_int_equal(pixels[1], second);
}

static void assert_quiet(void)
{
    struct error err;
    if (!emulated_display_is_quiet(&listener.display, &err)) fail_msg("%s", err.text);
}

static void a_frame_is_what_came_until_the_led_changes(void **state)
{
    (void)state;
    start(PANEL_UPRIGHT);
    take("# a board\n\n" AWAKE WINDOW_2X1 "b F8 00 07 E0\n");
    assert_int_equal(listener.frames, 0);
    take("p led 1\n");
    assert_int_equal(listener.frames, 1);
    assert_int_equal(listener.frame_bus_b, 19);
    assert_shows(0xF800, 0x07E0);
    take(WINDOW_2X1 "b 00 1f\nb F8 00\np led 0\n");
    assert_int_equal(listener.frames, 2);
    assert_int_equal(listener.frame_bus_b, 15);
    assert_shows(0x001F, 0xF800);
    assert_quiet();
}

static void a_change_of_the_led_without_pixels_ends_no_frame(void **state)
{
    (void)state;
    start(PANEL_UPRIGHT);
    take("p led 1\n" AWAKE "p led 0\n" WINDOW_2X1 "p led 1\np led 1\n");
    assert_int_equal(listener.frames, 0);
    take("b F8 00\np led 1\n");
    assert_int_equal(listener.frames, 0);
    take("b F8 00\np led 0\np led 1\np led 0\n");
    assert_int_equal(listener.frames, 1);
}

static void bytes_while_cs_is_high_are_somebody_elses(void **state)
{
    (void)state;
    start(PANEL_UPRIGHT);
    take(AWAKE "p cs 0\n" WINDOW_2X1 "b F8 00\np cs 1\nb 40 00 00\np cs 0\nb 07 E0\np led 1\n");
    assert_shows(0xF800, 0x07E0);
    assert_int_equal(listener.other_b, 3);
    assert_int_equal(listener.frame_bus_b, 19);
    assert_quiet();
}

static void a_picture_that_stands_on_its_head_is_read_so(void **state)
{
    (void)state;
    start(PANEL_TURNED_180);
    take(AWAKE WINDOW_2X1 "b F8 00 07 E0\n");
    assert_shows(0x07E0, 0xF800);
}

static void waits_count_once_time_is_told(void **state)
{
    (void)state;
    start(PANEL_UPRIGHT);
    take("p reset 0\np reset 1\nb 11\nb 13\n");
    assert_quiet();
    take("t 1000000\np reset 0\nt 1010000\np reset 1\nt 151010000\nb 11\nt 156010000\nb 13\n");
    assert_quiet();
    take("p reset 0\nt 156020000\np reset 1\nt 161019000\nb 13\n");
    assert_false(emulated_display_is_quiet(&listener.display, &(struct error){0}));
}

static void a_short_reset_is_one_once_time_is_told(void **state)
{
    (void)state;
    start(PANEL_UPRIGHT);
    take("t 1000\np reset 0\nt 10000\np reset 1\n");
    assert_false(emulated_display_is_quiet(&listener.display, &(struct error){0}));
}

static void time_does_not_go_back(void **state)
{
    struct error err;
    (void)state;
    start(PANEL_UPRIGHT);
    take("t 5000\nt 5000\n");
    assert_false(wire_log_take(&listener, "t 3000", &err));
    assert_string_equal(err.text, "time goes back to 3000 ns");
}

static void a_line_may_hold_a_frame(void **state)
{
    static char line[3 * 5000 + 2] = "b";
    (void)state;
    start(PANEL_UPRIGHT);
    for (int i = 0; i < 5000; i++)
        memcpy(line + 1 + 3 * i, " 00", 4);
    assert_true(wire_log_take(&listener, line, &(struct error){0}));
    assert_int_equal(listener.display.port->bus_b, 5000);
}

/* Logs of drivers ------------------------------------------------------------------------------ */

/* Writes down what the driver sends, and sends it. */
static struct tap {
    struct port to;
    FILE *log;
    uint64_t now_us;
} tap;

static int tap_write(void *ctx, const uint8_t *data, size_t n_b)
{
    fputs("b", tap.log);
    for (size_t i = 0; i < n_b; i++)
        fprintf(tap.log, " %02x", data[i]);
    fputs("\n", tap.log);
    return tap.to.bus.write(ctx, data, n_b);
}

static int tap_delay(void *ctx, uint32_t delay_us)
{
    tap.now_us += delay_us;
    fprintf(tap.log, "t %" PRIu64 "000\n", tap.now_us);
    return tap.to.clock.delay(ctx, delay_us);
}

static int tap_level(const char *name, const struct pin *pin, bool high)
{
    fprintf(tap.log, "p %s %d\n", name, high);
    return pin_set(pin, high);
}

static int tap_dc(void *ctx, bool high)
{
    (void)ctx;
    return tap_level("dc", &tap.to.dc, high);
}

static int tap_reset(void *ctx, bool high)
{
    (void)ctx;
    return tap_level("reset", &tap.to.reset, high);
}

static int tap_select(void *ctx, bool high)
{
    (void)ctx;
    return tap_level("select", &tap.to.select, high);
}

static int tap_backlight(void *ctx, bool high)
{
    (void)ctx;
    return tap_level("backlight", &tap.to.backlight, high);
}

static void wire_tap(struct panel_rig *on, struct port *port)
{
    (void)on;
    tap.to = *port;
    port->bus.write = tap_write;
    port->clock.delay = tap_delay;
    port->dc.set = tap_dc;
    port->reset.set = tap_reset;
    port->backlight.set = tap_backlight;
    if (port->select.set) port->select.set = tap_select;
}

static void assert_same_glass(void)
{
    static uint8_t shown[sizeof rig.seen];
    emulated_display_show(&rig.glass, rig.seen);
    emulated_display_show(&listener.display, shown);
    assert_memory_equal(shown, rig.seen, (size_t)3 * rig.glass.w_px * rig.glass.h_px);
    assert_quiet();
}

/* Two cards; with the LED between, and its waits told. */
static void listen_to(const struct panel_choice *panel)
{
    const struct module_choice choice = {.panel = *panel, .module = panel_rig_module(panel, 17, 16)};
    char *text;
    size_t text_b;
    tap = (struct tap){.log = open_memstream(&text, &text_b)};
    assert_true(panel_rig_setup(&rig, panel, &choice.module, wire_tap));
    assert_int_equal(panel_init(rig.display.panel), 0);
    listener_init(&listener, &choice);
    for (rig.seed = 1; rig.seed <= 2; rig.seed++) {
        assert_int_equal(panel_rig_draw(&rig, 480), 0);
        fprintf(tap.log, "p led %u\n", rig.seed % 2);
    }
    fclose(tap.log);
    for (char *rest = NULL, *line = strtok_r(text, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest))
        assert_true(wire_log_take(&listener, line, &(struct error){0}));
    free(text);
    assert_int_equal(listener.frames, 2);
    assert_same_glass();
}

static void every_panel_shows_the_same_to_a_listener(void **state)
{
    struct panel_choice choice;
    (void)state;
    for (size_t i = 0; panel_choice_at(i, &choice); i++)
        for (int format = 0; format < PANEL_FORMATS; format++) {
            choice.format = (enum panel_format)format;
            if (choice.formats >> format & 1) listen_to(&choice);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_frame_is_what_came_until_the_led_changes),
        cmocka_unit_test(a_change_of_the_led_without_pixels_ends_no_frame),
        cmocka_unit_test(bytes_while_cs_is_high_are_somebody_elses),
        cmocka_unit_test(a_picture_that_stands_on_its_head_is_read_so),
        cmocka_unit_test(waits_count_once_time_is_told),
        cmocka_unit_test(a_short_reset_is_one_once_time_is_told),
        cmocka_unit_test(time_does_not_go_back),
        cmocka_unit_test(a_line_may_hold_a_frame),
        cmocka_unit_test(every_panel_shows_the_same_to_a_listener),
    };
    return cmocka_run_group_tests_name("wire log", tests, NULL, NULL);
}
