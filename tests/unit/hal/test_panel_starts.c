/* SPDX-License-Identifier: MIT
 *
 * Everything that a panel is sent at its start, for its usual modules: each command, argument, pin and delay is as in
 * tests/unit/hal/panel_starts.expected. Much of it no emulated chip can judge: voltages, gamma curves, registers that
 * have no public description. They were looked up once and must not change unseen; PANEL_STARTS=write writes the file
 * anew. */
#include "panels.h"
#include "rigs/cmocka_ready.h"
#include "rigs/panels/panel_rig.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPECTED "tests/unit/hal/panel_starts.expected"

enum { TEXT_B = 1 << 20, LINE_B = 1 << 14 };

static struct panel_rig rig;
static char *text;
static size_t used;

static void put(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    const int n = vsnprintf(text + used, TEXT_B - used, format, arguments);
    va_end(arguments);
    assert_true(n >= 0 && (size_t)n < TEXT_B - used);
    used += (size_t)n;
}

/* The port notes what it is asked for, and asks nobody. */
static int note_bytes(void *ctx, const uint8_t *data, size_t n_b)
{
    (void)ctx;
    for (size_t i = 0; i < n_b; i++)
        put(" %02X", data[i]);
    return 0;
}

static int note_pin(void *ctx, bool high)
{
    put(" %s%c", (const char *)ctx, high ? '+' : '-');
    return 0;
}

static int note_delay(void *ctx, uint32_t delay_us)
{
    (void)ctx;
    put(" wait=%lu", (unsigned long)delay_us);
    return 0;
}

static unsigned message_b; /* what a message costs the port */

static void note(struct panel_rig *on, struct port *port)
{
    static char dc[] = "dc", reset[] = "reset", light[] = "light", select_[] = "select";

    port->bus = (struct bus){.write = note_bytes, .message_b = (uint16_t)message_b};
    port->dc = (struct pin){dc, note_pin};
    port->reset = (struct pin){reset, note_pin};
    port->backlight = (struct pin){light, note_pin};
    if (on->choice.family->selects) port->select = (struct pin){select_, note_pin};
    port->clock = (struct clock){.delay = note_delay};
}

/* Behind what the port was asked for. */
static void put_result(int err)
{
    put(" =%d", err);
}

/* The last piece of the picture, a pixel more than it holds, and a window outside. */
static void put_corner(struct panel *panel)
{
    static const uint8_t zeros[3 * 480];
    const uint16_t w_px = panel->w_px, h_px = panel->h_px, x_step_px = panel->step_x_px, y_step_px = panel->step_y_px;

    put(" %ux%u", w_px, h_px);
    put_result(panel_window(panel, w_px - x_step_px, h_px - y_step_px, x_step_px, y_step_px));
    put_result(panel_pixels(panel, zeros, (size_t)x_step_px * y_step_px));
    put_result(panel_pixels(panel, zeros, (size_t)x_step_px * y_step_px));
    put_result(panel_window(panel, w_px, 0, x_step_px, y_step_px));
    put_result(panel_pixels(panel, zeros, x_step_px));
    put_result(panel_flush(panel));
}

/* Everything else that a panel does. */
static void put_rest(struct panel *panel)
{
    put(" | blank");
    put_result(panel_blank(panel, true));
    put_result(panel_set_inverted(panel, true));
    put_result(panel_set_inverted(panel, false));
    put_result(panel_blank(panel, false));
    put(" | light");
    put_result(panel_set_backlight(panel, false));
    put_result(panel_set_backlight(panel, true));
    put(" | frame");
    put_result(panel_begin_frame(panel));
    for (unsigned turns = 0; turns < 5; turns++) {
        put(" | turn %u", turns);
        put_result(panel_set_rotation(panel, (enum panel_rotation)turns));
        put_corner(panel);
    }
    put(" | a window costs %u", panel->window_b);
}

static void put_start(const struct panel_choice *choice, const struct display_module *module, const char *what)
{
    put("%s %ux%u %s turn %u:", choice->name, module->w_px, module->h_px, what, (unsigned)module->rotation);
    if (!panel_rig_setup(&rig, choice, module, note)) {
        put(" refused\n");
        return;
    }
    struct panel *panel = rig.display.panel;
    assert_int_equal(panel_init(panel), 0);
    put(" | window");
    assert_int_equal(panel_window(panel, 0, 0, panel->w_px, panel->step_y_px), 0);
    static const uint8_t zeros[3 * 480];
    assert_int_equal(panel_pixels(panel, zeros, panel->step_x_px), 0);
    assert_int_equal(panel_flush(panel), 0);
    put(" | off");
    (void)!panel_set_inverted(panel, true);
    (void)!panel_set_inverted(panel, false);
    (void)!panel_sleep(panel, true);
    (void)!panel_sleep(panel, false);
    (void)!panel_darken(panel);
    (void)!panel_keep(panel);
    put_rest(panel);
    put("\n");
}

/* What some chips are told of their glass. */
static void put_told(const struct panel_choice *choice, struct display_module module)
{
    module.contrast = choice->contrast_max;
    module.start_line = choice->start_lines ? 5 : 0;
    if (module.contrast || module.start_line) put_start(choice, &module, "most contrast, line 5");
    module.internal_reference = choice->has_wiring;
    for (unsigned wiring = 1; choice->has_wiring && wiring < 3; wiring++) {
        module.wiring = (enum pages_wiring)wiring;
        put_start(choice, &module, wiring == 1 ? "reference, wired in sequence" : "reference, wired in turn");
    }
}

static void put_panel(const struct panel_choice *choice)
{
    struct display_module module = panel_rig_module(choice, 480, 480);

    put_start(choice, &module, "whole");
    module = panel_rig_module(choice, 128, 32);
    for (unsigned turns = 0; turns < 4; turns++) {
        module.rotation = (enum panel_rotation)turns;
        put_start(choice, &module, "small");
    }
    module.rotation = PANEL_UPRIGHT;
    module.bgr = module.invert = true;
    module.converter = choice->has_converter;
    put_start(choice, &module, "bgr inverted converter");
    module.mirror = true;
    put_start(choice, &module, "mirrored");
    module.mirror = false;
    module.flip_columns = true;
    put_start(choice, &module, "columns mirrored");
    module.flip_rows = true;
    put_start(choice, &module, "both mirrored");
    module.flip_columns = module.flip_rows = false;
    put_told(choice, module);
    message_b = 7;
    put_start(choice, &module, "of messages");
    message_b = 0;
    module = panel_rig_module(choice, 480, 480);
    for (int format = 0; format < PANEL_FORMATS; format++) {
        struct panel_choice other = *choice;
        char what[16];
        other.format = (enum panel_format)format;
        snprintf(what, sizeof what, "format %d", format);
        if (choice->formats >> format & 1 && other.format != choice->format) put_start(&other, &module, what);
    }
}

static void write_expected(void)
{
    FILE *file = fopen(EXPECTED, "w");

    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, used, file), used);
    assert_int_equal(fclose(file), 0);
}

static void every_panel_starts_as_it_always_did(void **state)
{
    static char line[LINE_B];
    struct panel_choice choice;
    const char *asked = getenv("PANEL_STARTS"), *at;

    (void)state;
    text = malloc(TEXT_B);
    assert_non_null(text);
    used = 0;
    for (size_t i = 0; panel_choice_at(i, &choice); i++)
        put_panel(&choice);
    if (asked && strcmp(asked, "write") == 0) write_expected();
    FILE *file = fopen(EXPECTED, "r");
    assert_non_null(file);
    for (at = text; fgets(line, sizeof line, file); at += strlen(line))
        if (strncmp(at, line, strlen(line)) != 0)
            fail_msg("expected: %sbut it is: %.*s", line, (int)strcspn(at, "\n"), at);
    assert_int_equal(*at, 0);
    fclose(file);
    free(text);
}

/* Bytes of a start, for a contrast of the caller's. */
static uint8_t sent[1024];
static size_t sent_b;

static int keep_bytes(void *ctx, const uint8_t *data, size_t n_b)
{
    (void)ctx;
    assert_true(n_b <= sizeof sent - sent_b);
    memcpy(sent + sent_b, data, n_b);
    sent_b += n_b;
    return 0;
}

static int take_level(void *ctx, bool high)
{
    (void)ctx, (void)high;
    return 0;
}

static int take_delay(void *ctx, uint32_t delay_us)
{
    (void)ctx, (void)delay_us;
    return 0;
}

/* PANEL_ERR_CONFIG: it does not take that one. */
static int start_pages(size_t i, uint8_t contrast)
{
    const struct pages_chip *chip = panels_pages[i];
    const struct pages_config config = {.bus = {.write = keep_bytes},
                                        .dc = {NULL, take_level},
                                        .clock = {NULL, take_delay},
                                        .w_px = chip->mem_w_px,
                                        .h_px = (uint16_t)(chip->mem_h_px / 8 * 8),
                                        .contrast = contrast};
    struct pages pages;

    sent_b = 0;
    const int err = pages_setup(&pages, chip, &config);
    return err ? err : panel_init(&pages.panel);
}

static int start_solomon(size_t i, uint8_t contrast)
{
    const struct solomon_chip *chip = panels_solomon[i];
    const struct solomon_config config = {.bus = {.write = keep_bytes},
                                          .dc = {NULL, take_level},
                                          .clock = {NULL, take_delay},
                                          .w_px = chip->mem_w_px,
                                          .h_px = chip->mem_h_px,
                                          .format = PANEL_USUAL,
                                          .contrast = contrast};
    struct solomon solomon;

    sent_b = 0;
    const int err = solomon_setup(&solomon, chip, &config);
    return err ? err : panel_init(&solomon.panel);
}

/* Of a start one byte is the contrast, whatever it is: the usual one unless another is given, up to the chip's most. */
static void assert_contrast(int (*start)(size_t i, uint8_t contrast), size_t i, uint8_t usual, uint8_t most)
{
    static uint8_t first[sizeof sent];
    const uint8_t given = most / 2 + 1 == usual ? most / 2 : most / 2 + 1;
    size_t differ = 0, at = 0;

    assert_int_equal(start(i, 0), 0);
    memcpy(first, sent, sent_b);
    const size_t first_b = sent_b;
    assert_int_equal(start(i, given), 0);
    assert_int_equal(sent_b, first_b);
    for (size_t k = 0; k < sent_b; k++)
        if (sent[k] != first[k]) {
            at = k;
            differ++;
        }
    assert_int_equal(differ, 1);
    assert_int_equal((uint8_t)(sent[at] - first[at]), (uint8_t)(given - usual));
    assert_int_equal(start(i, most), 0);
    assert_int_equal((uint8_t)(sent[at] - first[at]), (uint8_t)(most - usual));
    if (most < UINT8_MAX) assert_int_equal(start(i, (uint8_t)(most + 1)), PANEL_ERR_CONFIG);
}

static void contrast_is_as_given_or_as_usual(void **state)
{
    (void)state;
    for (size_t i = 0; panels_pages[i]; i++)
        assert_contrast(start_pages, i, panels_pages[i]->contrast, panels_pages[i]->contrast_max);
    for (size_t i = 0; panels_solomon[i]; i++)
        assert_contrast(start_solomon, i, panels_solomon[i]->contrast, panels_solomon[i]->contrast_max);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_panel_starts_as_it_always_did),
                                       cmocka_unit_test(contrast_is_as_given_or_as_usual)};

    return cmocka_run_group_tests_name("panel_starts", tests, NULL, NULL);
}
