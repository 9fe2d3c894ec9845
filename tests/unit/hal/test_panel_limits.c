/* SPDX-License-Identifier: MIT
 *
 * What each chip takes, by numbers of its datasheet that are written here once more: memory, contrast, offsets, first
 * line; at the limit, one less and one more. */
#include "panels.h"
#include "rigs/cmocka_ready.h"

#include <stdbool.h>
#include <string.h>

enum kind { DCS, PAGES, SOLOMON };

struct limits {
    const char *name;
    enum kind kind;
    uint16_t w_px, h_px;
    unsigned contrast_max, contrast;
    uint8_t step_x_px, step_y_px;
    bool turns_by_quarters, is_oled;
    unsigned start_lines;
};

static const struct limits chips[] = {
    {"gc9a01", DCS, 240, 240, 0, 0, 1, 1, true, false, 1},
    {"ili9341", DCS, 240, 320, 0, 0, 1, 1, true, false, 1},
    {"ili9488", DCS, 320, 480, 0, 0, 1, 1, true, false, 1},
    {"st7735", DCS, 132, 162, 0, 0, 1, 1, true, false, 1},
    {"st7789", DCS, 240, 320, 0, 0, 1, 1, true, false, 1},
    {"st7796", DCS, 320, 480, 0, 0, 1, 1, true, false, 1},
    {"pcd8544", PAGES, 84, 48, 127, 63, 1, 8, false, false, 1},
    {"sh1106", PAGES, 132, 64, 255, 128, 1, 8, false, true, 64},
    {"ssd1306", PAGES, 128, 64, 255, 207, 1, 8, false, true, 64},
    {"st7567", PAGES, 132, 64, 63, 36, 1, 8, false, false, 64},
    {"uc1701", PAGES, 132, 64, 63, 39, 1, 8, false, false, 64},
    {"ssd0323", SOLOMON, 128, 80, 127, 50, 2, 1, false, true, 80},
    {"ssd1327", SOLOMON, 128, 128, 255, 128, 2, 1, false, true, 128},
    {"ssd1351", SOLOMON, 128, 128, 15, 15, 1, 1, true, true, 128},
};
enum { CHIPS = sizeof chips / sizeof *chips };

static int write(void *ctx, const uint8_t *data, size_t n_b)
{
    (void)ctx, (void)data, (void)n_b;
    return 0;
}

static int set(void *ctx, bool high)
{
    (void)ctx, (void)high;
    return 0;
}

static int delay(void *ctx, uint32_t delay_us)
{
    (void)ctx, (void)delay_us;
    return 0;
}

struct wish {
    uint16_t w_px, h_px, ox_px, oy_px, mem_w_px, mem_h_px;
    uint8_t contrast, start_line;
    unsigned rotation, format, wiring;
    bool internal_reference;
    bool no_write, no_dc, no_delay;
};

static struct panel panel; /* of the last that was set up */

static const struct dcs_chip *dcs_of(const char *name)
{
    size_t i = 0;
    while (panels_dcs[i] && strcmp(panels_dcs[i]->name, name) != 0)
        i++;
    assert_non_null(panels_dcs[i]);
    return panels_dcs[i];
}

static const struct pages_chip *pages_of(const char *name)
{
    size_t i = 0;
    while (panels_pages[i] && strcmp(panels_pages[i]->name, name) != 0)
        i++;
    assert_non_null(panels_pages[i]);
    return panels_pages[i];
}

static const struct solomon_chip *solomon_of(const char *name)
{
    size_t i = 0;
    while (panels_solomon[i] && strcmp(panels_solomon[i]->name, name) != 0)
        i++;
    assert_non_null(panels_solomon[i]);
    return panels_solomon[i];
}

static int setup(const struct limits *chip, const struct wish *wish)
{
    static struct dcs dcs;
    static struct pages pages;
    static struct solomon solomon;
    const struct bus bus = {.write = wish->no_write ? NULL : write};
    const struct pin dc = {.set = wish->no_dc ? NULL : set};
    const struct clock clock = {.delay = wish->no_delay ? NULL : delay};
    const enum panel_rotation rotation = (enum panel_rotation)wish->rotation;
    int err;

    if (chip->kind == DCS) {
        const struct dcs_config config = {.bus = bus,
                                          .dc = dc,
                                          .clock = clock,
                                          .w_px = wish->w_px,
                                          .h_px = wish->h_px,
                                          .ox_px = wish->ox_px,
                                          .oy_px = wish->oy_px,
                                          .mem_w_px = wish->mem_w_px,
                                          .mem_h_px = wish->mem_h_px,
                                          .rotation = rotation,
                                          .format = (enum panel_format)wish->format};
        err = dcs_setup(&dcs, dcs_of(chip->name), &config);
        panel = dcs.panel;
    } else if (chip->kind == PAGES) {
        const struct pages_config config = {.bus = bus,
                                            .dc = dc,
                                            .clock = clock,
                                            .w_px = wish->w_px,
                                            .h_px = wish->h_px,
                                            .ox_px = wish->ox_px,
                                            .rotation = rotation,
                                            .contrast = wish->contrast,
                                            .start_line = wish->start_line,
                                            .wiring = (enum pages_wiring)wish->wiring,
                                            .internal_reference = wish->internal_reference};
        err = pages_setup(&pages, pages_of(chip->name), &config);
        panel = pages.panel;
    } else {
        const struct solomon_config config = {.bus = bus,
                                              .dc = dc,
                                              .clock = clock,
                                              .w_px = wish->w_px,
                                              .h_px = wish->h_px,
                                              .ox_px = wish->ox_px,
                                              .rotation = rotation,
                                              .contrast = wish->contrast,
                                              .start_line = wish->start_line,
                                              .format = (enum panel_format)wish->format};
        err = solomon_setup(&solomon, solomon_of(chip->name), &config);
        panel = solomon.panel;
    }
    return err;
}

static struct wish whole(const struct limits *chip)
{
    return (struct wish){.w_px = chip->w_px, .h_px = chip->h_px};
}

#define ASSERT_TAKES(chip, wish, takes)                                                                                \
    do                                                                                                                 \
        if (setup(chip, wish) != ((takes) ? 0 : PANEL_ERR_CONFIG))                                                     \
            fail_msg("%s, %ux%u at %u,%u, contrast %u, rotation %u, format %u", (chip)->name, (wish)->w_px,            \
                     (wish)->h_px, (wish)->ox_px, (wish)->oy_px, (wish)->contrast, (wish)->rotation, (wish)->format);  \
    while (0)

static void glass_is_within_the_memory(void **state)
{
    (void)state;
    for (size_t i = 0; i < CHIPS; i++) {
        const struct limits *chip = &chips[i];
        struct wish wish = whole(chip);
        const uint16_t step_x_px = chip->step_x_px, step_y_px = chip->step_y_px;

        ASSERT_TAKES(chip, &wish, true);
        assert_int_equal(panel.w_px, chip->w_px);
        assert_int_equal(panel.h_px, chip->h_px);
        assert_int_equal(panel.step_x_px, step_x_px);
        assert_int_equal(panel.step_y_px, step_y_px);
        assert_int_equal(panel_init(&panel), 0);
        wish.w_px = (uint16_t)(chip->w_px + step_x_px);
        ASSERT_TAKES(chip, &wish, false);
        wish.w_px = 0;
        ASSERT_TAKES(chip, &wish, false);
        for (wish.w_px = 1; wish.w_px <= 4; wish.w_px++)
            ASSERT_TAKES(chip, &wish, wish.w_px % step_x_px == 0);
        wish = whole(chip);
        wish.h_px = (uint16_t)(chip->h_px + step_y_px);
        ASSERT_TAKES(chip, &wish, false);
        wish.h_px = 0;
        ASSERT_TAKES(chip, &wish, false);
        for (wish.h_px = 1; wish.h_px <= 16; wish.h_px++)
            ASSERT_TAKES(chip, &wish, wish.h_px % step_y_px == 0);
        wish = whole(chip);
        wish.ox_px = step_x_px;
        ASSERT_TAKES(chip, &wish, false);
        wish.w_px = (uint16_t)(wish.w_px - step_x_px);
        ASSERT_TAKES(chip, &wish, true);
        wish.ox_px = (uint16_t)(2 * step_x_px);
        ASSERT_TAKES(chip, &wish, false);
        wish.w_px = (uint16_t)(wish.w_px - step_x_px);
        ASSERT_TAKES(chip, &wish, true);
        wish.ox_px = 1;
        ASSERT_TAKES(chip, &wish, step_x_px == 1);
        if (chip->kind != DCS) continue;
        wish = whole(chip);
        wish.oy_px = 1;
        ASSERT_TAKES(chip, &wish, false);
        wish.h_px--;
        ASSERT_TAKES(chip, &wish, true);
    }
}

static void mode_pins_leave_what_the_chip_has_or_less(void **state)
{
    (void)state;
    for (size_t i = 0; i < CHIPS; i++) {
        const struct limits *chip = &chips[i];
        struct wish wish = whole(chip);
        if (chip->kind != DCS) continue;
        wish.mem_w_px = (uint16_t)(chip->w_px + 1);
        ASSERT_TAKES(chip, &wish, false);
        wish.mem_w_px = chip->w_px;
        wish.mem_h_px = (uint16_t)(chip->h_px + 1);
        ASSERT_TAKES(chip, &wish, false);
        wish.mem_h_px = (uint16_t)(chip->h_px - 1);
        ASSERT_TAKES(chip, &wish, false);
        wish.h_px = wish.mem_h_px;
        ASSERT_TAKES(chip, &wish, true);
        wish.mem_w_px = (uint16_t)(chip->w_px - 3);
        ASSERT_TAKES(chip, &wish, false);
        wish.w_px = (uint16_t)(chip->w_px - 4);
        wish.ox_px = 1;
        ASSERT_TAKES(chip, &wish, true);
        wish.oy_px = 1;
        ASSERT_TAKES(chip, &wish, false);
        wish.oy_px = 0;
        wish.ox_px = 2;
        ASSERT_TAKES(chip, &wish, false);
    }
}

static void the_glass_begins_with_a_line_of_memory(void **state)
{
    (void)state;
    for (size_t i = 0; i < CHIPS; i++) {
        const struct limits *chip = &chips[i];
        struct wish wish = whole(chip);
        if (chip->kind == DCS) continue;
        for (unsigned line = 0; line < 256; line++) {
            wish.start_line = (uint8_t)line;
            ASSERT_TAKES(chip, &wish, line < chip->start_lines);
        }
    }
}

static void only_an_oled_of_pages_is_told_its_wiring_and_reference(void **state)
{
    (void)state;
    for (size_t i = 0; i < CHIPS; i++) {
        const struct limits *chip = &chips[i];
        struct wish wish = whole(chip);
        if (chip->kind != PAGES) continue;
        for (wish.wiring = 0; wish.wiring < 4; wish.wiring++)
            ASSERT_TAKES(chip, &wish, wish.wiring == 0 || (chip->is_oled && wish.wiring < 3));
        wish.wiring = 0;
        wish.internal_reference = true;
        ASSERT_TAKES(chip, &wish, chip->is_oled);
    }
}

static void contrast_is_up_to_the_chip_s_most(void **state)
{
    (void)state;
    for (size_t i = 0; i < CHIPS; i++) {
        const struct limits *chip = &chips[i];
        struct wish wish = whole(chip);
        if (chip->kind == DCS) continue;
        for (unsigned contrast = 0; contrast < 256; contrast++) {
            wish.contrast = (uint8_t)contrast;
            ASSERT_TAKES(chip, &wish, contrast <= chip->contrast_max);
        }
        const unsigned usual = chip->kind == PAGES ? pages_of(chip->name)->contrast : solomon_of(chip->name)->contrast;
        assert_int_equal(usual, chip->contrast);
    }
}

/* Half a turn is everybody's, but for one whose glass cannot be flipped. */
static void chips_turn_by_quarters_or_halves(void **state)
{
    (void)state;
    for (size_t i = 0; i < CHIPS; i++) {
        const struct limits *chip = &chips[i];
        struct wish wish = whole(chip);
        for (wish.rotation = 0; wish.rotation < 6; wish.rotation++) {
            const bool takes = wish.rotation == 0 || (wish.rotation < 4 && chip->turns_by_quarters) ||
                               (wish.rotation == 2 && strcmp(chip->name, "pcd8544") != 0);
            ASSERT_TAKES(chip, &wish, takes);
        }
    }
}

static void what_a_driver_needs_must_be_there(void **state)
{
    (void)state;
    for (size_t i = 0; i < CHIPS; i++) {
        struct wish wish = whole(&chips[i]);
        wish.no_write = true;
        ASSERT_TAKES(&chips[i], &wish, false);
        wish = whole(&chips[i]);
        wish.no_dc = true;
        ASSERT_TAKES(&chips[i], &wish, false);
        wish = whole(&chips[i]);
        wish.no_delay = true;
        ASSERT_TAKES(&chips[i], &wish, false);
    }
}

static void every_chip_is_here(void **state)
{
    size_t n = 0;

    (void)state;
    for (size_t i = 0; panels_dcs[i]; i++)
        n++;
    for (size_t i = 0; panels_pages[i]; i++)
        n++;
    for (size_t i = 0; panels_solomon[i]; i++)
        n++;
    assert_int_equal(n, CHIPS);
    assert_string_equal(panels_sharp[0]->name, "ls013b7dh03");
    assert_int_equal(panels_sharp[0]->w_px, 128);
    assert_int_equal(panels_sharp[0]->h_px, 128);
    assert_string_equal(panels_sharp[1]->name, "ls027b7dh01");
    assert_int_equal(panels_sharp[1]->w_px, 400);
    assert_int_equal(panels_sharp[1]->h_px, 240);
    assert_null(panels_sharp[2]);
}

/* MIPI DCS 1.01, 5.1. */
static void commands_are_as_the_standard_has_them(void **state)
{
    (void)state;
    assert_int_equal(DCS_SWRESET, 0x01);
    assert_int_equal(DCS_SLPIN, 0x10);
    assert_int_equal(DCS_SLPOUT, 0x11);
    assert_int_equal(DCS_NORON, 0x13);
    assert_int_equal(DCS_INVOFF, 0x20);
    assert_int_equal(DCS_INVON, 0x21);
    assert_int_equal(DCS_DISPOFF, 0x28);
    assert_int_equal(DCS_DISPON, 0x29);
    assert_int_equal(DCS_CASET, 0x2A);
    assert_int_equal(DCS_RASET, 0x2B);
    assert_int_equal(DCS_RAMWR, 0x2C);
    assert_int_equal(DCS_TEON, 0x35);
    assert_int_equal(DCS_MADCTL, 0x36);
    assert_int_equal(DCS_COLMOD, 0x3A);
}

static void what_a_driver_does_not_have_is_unsupported(void **state)
{
    static const struct panel_ops none = {0};
    struct panel bare = {.ops = &none};

    (void)state;
    assert_int_equal(panel_begin_frame(&bare), 0);
    assert_int_equal(panel_keep(&bare), 0);
    assert_int_equal(panel_sleep(&bare, true), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_blank(&bare, true), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_darken(&bare), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_set_rotation(&bare, PANEL_UPRIGHT), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_set_inverted(&bare, true), PANEL_ERR_UNSUPPORTED);
    assert_int_equal(panel_set_backlight(&bare, true), PANEL_ERR_UNSUPPORTED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(glass_is_within_the_memory),
        cmocka_unit_test(mode_pins_leave_what_the_chip_has_or_less),
        cmocka_unit_test(the_glass_begins_with_a_line_of_memory),
        cmocka_unit_test(only_an_oled_of_pages_is_told_its_wiring_and_reference),
        cmocka_unit_test(contrast_is_up_to_the_chip_s_most),
        cmocka_unit_test(chips_turn_by_quarters_or_halves),
        cmocka_unit_test(what_a_driver_needs_must_be_there),
        cmocka_unit_test(every_chip_is_here),
        cmocka_unit_test(commands_are_as_the_standard_has_them),
        cmocka_unit_test(what_a_driver_does_not_have_is_unsupported),
    };
    return cmocka_run_group_tests_name("panel_limits", tests, NULL, NULL);
}
