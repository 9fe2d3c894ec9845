/* SPDX-License-Identifier: MIT
 *
 * How emulated chips scan their outputs, by what drivers of others send to modules that the table does not have: each
 * pair of settings, upright and turned by half, shows the same glass, from the one end and from the other. Of the
 * modules only the size and the first output are taken from there. */
#include "glass/emulated_dcs.h"
#include "glass/emulated_pages.h"
#include "glass/emulated_solomon.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

enum { MOST_B = 8 };

/* Registers, with D/C low: arguments too. */
struct settings {
    uint8_t bytes[MOST_B], n_b;
};

static void send(struct emulated_port *port, const struct settings *settings)
{
    const struct bus bus = emulated_port_bus(port);

    port->now_us += 1000000;
    assert_int_equal(bus_write(&bus, settings->bytes, settings->n_b), 0);
}

/* Greys ------------------------------------------------------------------------------------------------------------ */

static struct emulated_solomon greys;

/* Memory's rows from 0 on are seen from the top down, or from the bottom up. */
static void check_greys(uint16_t h_px, bool turned)
{
    uint8_t rgb[3];

    for (unsigned row = 0; row < h_px; row++) {
        memset(greys.memory, 0, sizeof greys.memory);
        greys.memory[row][40] = 15;
        for (unsigned y = 0; y < h_px; y++) {
            emulated_solomon_see(&greys, 40, y, rgb);
            if ((rgb[0] != 0) != (y == (turned ? h_px - 1u - row : row)))
                fail_msg("%s with %u lines: memory's row %u, line %u of the glass", greys.glass.chip, h_px, row, y);
        }
    }
}

static void windows_of_greys_meet_the_same_glass_from_both_ends(void **state)
{
    static const struct {
        const char *chip;
        uint16_t h_px, line; /* the output that drives the top line */
        struct settings upright, turned;
    } modules[] = {
        /* u8g2, u8x8_d_ssd1325.c: OS128064 */
        {"ssd0323", 64, 63, {{0xA8, 0x3F, 0xA0, 0x52, 0xA2, 0x40}, 6}, {{0xA8, 0x3F, 0xA0, 0x41, 0xA2, 0x50}, 6}},
        /* u8g2, u8x8_d_ssd1327.c: 96 lines of Seeed's module; Seeed's own driver has what is called turned here */
        {"ssd1327", 96, 127, {{0xA8, 0x5F, 0xA2, 0x20, 0xA0, 0x51}, 6}, {{0xA8, 0x5F, 0xA2, 0x60, 0xA0, 0x42}, 6}},
        {"ssd1327", 128, 127, {{0xA8, 0x7F, 0xA2, 0x00, 0xA0, 0x51}, 6}, {{0xA8, 0x7F, 0xA2, 0x00, 0xA0, 0x42}, 6}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof modules / sizeof *modules; i++)
        for (unsigned turned = 0; turned < 2; turned++) {
            struct glass glass = *glass_find(modules[i].chip, 0, 0);
            glass.h_px = modules[i].h_px;
            glass.line = modules[i].line;
            glass.column = 0; /* so that it does not matter here how columns are exchanged */
            glass.columns_back = false;
            emulated_solomon_init(&greys, &glass);
            greys.port.deferred = false;
            send(&greys.port, turned ? &modules[i].turned : &modules[i].upright);
            send(&greys.port, &(const struct settings){{0xA4, 0xAF}, 2});
            check_greys(modules[i].h_px, turned);
            assert_int_equal(greys.complaints, 0);
        }
}

static void outputs_that_are_not_scanned_are_dark(void **state)
{
    uint8_t rgb[3];

    (void)state;
    emulated_solomon_init(&greys, glass_find("ssd1327", 128, 128));
    greys.port.deferred = false;
    greys.port.foreign = true;
    send(&greys.port, &(const struct settings){{0xA8, 0x5F, 0xA0, 0x51, 0xA4, 0xAF}, 6});
    for (unsigned i = 0; i < 128 * 128; i++)
        greys.memory[i / 128][i % 128] = 15;
    for (unsigned y = 0; y < 128; y++) { /* counted back from output 95 */
        emulated_solomon_see(&greys, 5, y, rgb);
        assert_int_equal(rgb[0], y < 32 ? 0 : 255);
    }
}

/* Pages ------------------------------------------------------------------------------------------------------------ */

static struct emulated_pages pages;

static void check_pages(uint16_t h_px, bool turned)
{
    for (unsigned row = 0; row < h_px; row++) {
        memset(pages.memory, 0, sizeof pages.memory);
        pages.memory[row / 8][40] = (uint8_t)(1u << row % 8);
        for (unsigned y = 0; y < h_px; y++)
            if (emulated_pages_is_bright(&pages, 40, y) != (y == (turned ? h_px - 1u - row : row)))
                fail_msg("%s with %u lines: memory's row %u, line %u of the glass", pages.glass.chip, h_px, row, y);
    }
}

static void pages_meet_the_same_glass_from_both_ends(void **state)
{
    static const struct {
        const char *chip;
        uint16_t h_px, line;
        bool lines_back;
        struct settings upright, turned;
    } modules[] = {
        /* u8g2, u8x8_d_st7567.c: 122x32, on the outputs from 32 on */
        {"st7567", 32, 32, false, {{0x60, 0xC0}, 2}, {{0x40, 0xC8}, 2}},
        {"st7567", 64, 0, false, {{0x40, 0xC0}, 2}, {{0x40, 0xC8}, 2}},
        /* u8g2, u8x8_d_ssd1306_128x32.c: Visionox, and luma's, which scans a line more. Neither says how it is turned:
         * the outputs are those from 16 to 47 as well. */
        {"sh1106",
         32,
         47,
         true,
         {{0xA8, 0x1F, 0xD3, 0x10, 0xDA, 0x12, 0xC8}, 7},
         {{0xA8, 0x1F, 0xD3, 0x30, 0xDA, 0x12, 0xC0}, 7}},
        {"sh1106",
         32,
         47,
         true,
         {{0xA8, 0x20, 0xD3, 0x0F, 0xDA, 0x12, 0xC8}, 7},
         {{0xA8, 0x20, 0xD3, 0x30, 0xDA, 0x12, 0xC0}, 7}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof modules / sizeof *modules; i++)
        for (unsigned turned = 0; turned < 2; turned++) {
            struct glass glass = *glass_find(modules[i].chip, 0, 0);
            glass.h_px = modules[i].h_px;
            glass.line = modules[i].line;
            glass.lines_back = modules[i].lines_back;
            glass.column = 0;
            glass.columns_back = false;
            emulated_pages_init(&pages, &glass);
            pages.port.deferred = false;
            pages.port.foreign = true;
            send(&pages.port, turned ? &modules[i].turned : &modules[i].upright);
            send(&pages.port, &(const struct settings){{0xAF}, 1});
            check_pages(modules[i].h_px, turned);
        }
}

/* Told the other wiring, glass of 128x64 shows the upper half of memory on its even lines, the lower on odd ones; glass
 * of 128x32 every other line, and nothing below. */
static void lines_that_are_wired_otherwise_are_out_of_order(void **state)
{
    (void)state;
    for (unsigned low = 0; low < 2; low++) {
        emulated_pages_init(&pages, glass_find("ssd1306", 128, low ? 32 : 64));
        pages.port.deferred = false;
        pages.port.foreign = true;
        send(&pages.port, &(const struct settings){{0xDA, low ? 0x12 : 0x02, 0x8D, 0x14, 0xC8, 0xAF}, 6});
        if (low) send(&pages.port, &(const struct settings){{0xA8, 0x1F}, 2});
        for (unsigned y = 0; y < (low ? 32 : 64); y++) {
            const unsigned from_below = (low ? 31 : 63) - y;
            const unsigned output = low ? 2 * from_below : from_below / 2 + from_below % 2 * 32;
            const unsigned row = (low ? 31 : 63) - output;
            memset(pages.memory, 0, sizeof pages.memory);
            if (output < (low ? 32 : 64)) pages.memory[row / 8][127] = (uint8_t)(1u << row % 8);
            assert_int_equal(emulated_pages_is_bright(&pages, 0, y), output < (low ? 32 : 64));
        }
    }
}

static void small_glass_without_its_reference_stays_dark(void **state)
{
    (void)state;
    emulated_pages_init(&pages, glass_find("ssd1306", 72, 40));
    pages.port.deferred = false;
    send(&pages.port, &(const struct settings){{0xA8, 39, 0x8D, 0x14, 0xDA, 0x12, 0xA5, 0xAF}, 8});
    assert_false(emulated_pages_is_bright(&pages, 3, 3));
    send(&pages.port, &(const struct settings){{0xAD, 0x30}, 2});
    assert_true(emulated_pages_is_bright(&pages, 3, 3));
    assert_int_equal(pages.complaints, 0);
}

/* Colours ---------------------------------------------------------------------------------------------------------- */

static struct emulated_dcs lcd;

static void send_dcs(const uint8_t *bytes, size_t n_b)
{
    const struct bus bus = emulated_port_bus(&lcd.port);
    const struct pin dc = emulated_port_dc(&lcd.port);

    lcd.port.now_us += 1000000;
    assert_int_equal(pin_set(&dc, false), 0);
    assert_int_equal(bus_write(&bus, bytes, 1), 0);
    assert_int_equal(pin_set(&dc, true), 0);
    assert_int_equal(bus_write(&bus, bytes + 1, n_b - 1), 0);
}

#define SEND(...) send_dcs((const uint8_t[]){__VA_ARGS__}, sizeof((const uint8_t[]){__VA_ARGS__}))

/* A pixel at the start of memory's addresses: where the glass shows it, 1 for the right edge and 2 for the bottom. */
static unsigned corner_of(const char *chip, uint8_t scan, uint8_t madctl)
{
    static uint32_t raw[320 * 480];

    emulated_dcs_init(&lcd, glass_find(chip, 0, 0));
    memset(lcd.memory, 0, sizeof lcd.memory);
    lcd.port.deferred = false;
    SEND(0x11);
    SEND(0xB6, 0x08, scan, 0x27);
    SEND(0x36, madctl);
    SEND(0x3A, 0x66);
    SEND(0x2A, 0, 0, 0, 0);
    SEND(0x2B, 0, 0, 0, 0);
    SEND(0x2C, 0xFC, 0xFC, 0xFC);
    assert_int_equal(lcd.complaints, 0);
    emulated_dcs_show(&lcd, 0, NULL, raw);
    const unsigned w = lcd.glass.w_px, h = lcd.glass.h_px;
    return raw[0] ? 0 : raw[w - 1] ? 1 : raw[w * (h - 1)] ? 2 : raw[w * h - 1] ? 3 : 4;
}

/* LovyanGFX scans lines from below and mirrors nothing: the glass that others drive, turned by half. */
static void scan_directions_turn_what_madctl_does_not(void **state)
{
    static const char *const chips[] = {"ili9341", "ili9488"};

    (void)state;
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(corner_of(chips[i], 0x82, 0x48), 0);
        assert_int_equal(corner_of(chips[i], 0xC2, 0x08), 3);
        assert_int_equal(corner_of(chips[i], 0xC2, 0x88), 1);
        assert_int_equal(corner_of(chips[i], 0xA2, 0x08), 0);
        assert_int_equal(corner_of(chips[i], 0x82, 0x88), 3);
        assert_int_equal(corner_of(chips[i], 0x82, 0x08), 1);
    }
}

/* Arduino_GFX turns the scan of columns and mirrors nothing, TFT_eSPI and fb_st7796s the other way round: the same
 * glass. What comes before both keys, or once one of them was taken back, does nothing. */
static void registers_that_are_locked_stay_as_they_are(void **state)
{
    static uint32_t raw[320 * 480];
    static const struct {
        uint8_t keys[4], scan, madctl;
        unsigned locked, corner_px;
    } cases[] = {
        {{0xC3, 0x96, 0x3C, 0x69}, 0x22, 0x08, 0, 0},         {{0xC3, 0x96, 0x3C, 0x69}, 0x02, 0x48, 0, 0},
        {{0xC3, 0xC3, 0x3C, 0x69}, 0x22, 0x08, 1, 319},       {{0x96, 0x96, 0x69, 0x3C}, 0x22, 0x08, 1, 319},
        {{0xC3, 0x96, 0xC3, 0x96}, 0x62, 0x08, 0, 479 * 320},
    };

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        emulated_dcs_init(&lcd, glass_find("st7796", 0, 0));
        lcd.port.deferred = false;
        SEND(0x11);
        SEND(0xF0, cases[i].keys[0]);
        SEND(0xF0, cases[i].keys[1]);
        SEND(0xB6, 0x80, cases[i].scan, 0x3B);
        SEND(0xF0, cases[i].keys[2]);
        SEND(0xF0, cases[i].keys[3]);
        SEND(0x36, cases[i].madctl);
        SEND(0x3A, 0x55);
        SEND(0x2A, 0, 0, 0, 0);
        SEND(0x2B, 0, 0, 0, 0);
        SEND(0x2C, 0x12, 0x34);
        emulated_dcs_show(&lcd, 0, NULL, raw);
        assert_int_equal(raw[cases[i].corner_px], 0x1234);
        assert_int_equal(lcd.complaints_of[EMULATED_UNKNOWN_COMMAND], cases[i].locked);
        assert_int_equal(lcd.complaints, cases[i].locked);
    }
    SEND(0xF0, 0xA5);
    assert_int_equal(lcd.complaints_of[EMULATED_ARGS_VALUE], 1);
    SEND(0x01);
    SEND(0xB4, 0x01);
    assert_int_equal(lcd.complaints_of[EMULATED_UNKNOWN_COMMAND], 1);
}

/* Adafruit_ST7735.cpp and others: the first pixel of 128x128 is at 2, 3 with MX and MY, at 2, 1 without. */
static void memory_that_mode_pins_leave_ends_at_132_lines(void **state)
{
    static uint32_t raw[128 * 128];

    (void)state;
    for (unsigned turned = 0; turned < 2; turned++) {
        emulated_dcs_init(&lcd, glass_find("st7735", 128, 128));
        lcd.port.deferred = false;
        SEND(0x11);
        SEND(0x36, turned ? 0x08 : 0xC8);
        SEND(0x3A, 0x05);
        SEND(0x2A, 0, 2, 0, 129);
        SEND(0x2B, 0, turned ? 1 : 3, 0, turned ? 128 : 130);
        SEND(0x2C, 0x12, 0x34);
        emulated_dcs_show(&lcd, 0, NULL, raw);
        assert_int_equal(raw[turned ? 128 * 128 - 1 : 0], 0x1234);
        assert_int_equal(lcd.complaints, 0);
        SEND(0x2B, 0, 5, 0, 132);
        assert_int_equal(lcd.complaints_of[EMULATED_RANGE], 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(windows_of_greys_meet_the_same_glass_from_both_ends),
        cmocka_unit_test(outputs_that_are_not_scanned_are_dark),
        cmocka_unit_test(pages_meet_the_same_glass_from_both_ends),
        cmocka_unit_test(lines_that_are_wired_otherwise_are_out_of_order),
        cmocka_unit_test(small_glass_without_its_reference_stays_dark),
        cmocka_unit_test(scan_directions_turn_what_madctl_does_not),
        cmocka_unit_test(registers_that_are_locked_stay_as_they_are),
        cmocka_unit_test(memory_that_mode_pins_leave_ends_at_132_lines),
    };
    return cmocka_run_group_tests_name("scanning", tests, NULL, NULL);
}
