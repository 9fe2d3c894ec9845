/* SPDX-License-Identifier: MIT
 *
 * Streams that others wrote: what glass would bear of them is a notice, and does what it does on glass; commands and
 * pixels that are cut, and what is not modelled but seen, are complaints as ever. From the project's own drivers all of
 * it is. */
#include "glass/emulated_display.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

static struct emulated_display display;
static struct port port;

static void power(const char *chip, bool foreign)
{
    emulated_display_init(&display, glass_find(chip, 0, 0));
    display.port->deferred = false;
    if (foreign) emulated_display_take_foreign(&display);
    port = emulated_port_whole(display.port);
}

/* A command, and arguments as data. */
static void send(const uint8_t *bytes, size_t n_b)
{
    assert_int_equal(pin_set(&port.dc, false), 0);
    assert_int_equal(bus_write(&port.bus, bytes, 1), 0);
    assert_int_equal(pin_set(&port.dc, true), 0);
    if (n_b > 1) assert_int_equal(bus_write(&port.bus, bytes + 1, n_b - 1), 0);
}

#define SEND(...) send((const uint8_t[]){__VA_ARGS__}, sizeof((const uint8_t[]){__VA_ARGS__}))

static void send_commands(const uint8_t *bytes, size_t n_b)
{
    assert_int_equal(pin_set(&port.dc, false), 0);
    assert_int_equal(bus_write(&port.bus, bytes, n_b), 0);
}

#define COMMANDS(...) send_commands((const uint8_t[]){__VA_ARGS__}, sizeof((const uint8_t[]){__VA_ARGS__}))

static void check(unsigned notices, unsigned complaints)
{
    const char *last;
    const unsigned noticed = emulated_display_notices(&display, &last);

    assert_int_equal(noticed, notices);
    assert_true(noticed == 0 || last[0] != '\0');
    const unsigned complained = emulated_display_complaints(&display, &last);
    if (complained != complaints) fail_msg("%u complaints, the last: %s", complained, last);
}

/* What Linux' and others' drivers send to an ILI9341 beyond what it describes. */
static void send_to_ili9341(void)
{
    display.port->now_us = 1000000;
    SEND(0xEF, 0x03, 0x80, 0x02);       /* not described */
    SEND(0xB6, 0x08, 0x82, 0x27, 0x00); /* one too many */
    SEND(0x35);                         /* without its argument */
    SEND(0x00, 0x0F);                   /* neither does this take any */
}

static void an_lcd_bears_vendors_registers(void **state)
{
    (void)state;
    power("ili9341", true);
    send_to_ili9341();
    check(4, 0);
    power("ili9341", false);
    send_to_ili9341();
    check(0, 4);
}

static void an_lcd_that_is_not_waited_for_goes_on(void **state)
{
    (void)state;
    for (int foreign = 0; foreign < 2; foreign++) {
        power("st7735", foreign);
        SEND(0x01);
        SEND(0x11);
        assert_int_equal(display.chip.dcs.asleep, !foreign);
        check(foreign ? 3 : 0, foreign ? 0 : 3);
    }
}

/* A frame before sleep is left, pixels beyond the window, and a window that memory does not have. */
static void an_lcd_bears_pixels_too_early_and_too_many(void **state)
{
    const uint32_t *const first = &display.chip.dcs.memory[0][0].raw;

    (void)state;
    for (int foreign = 0; foreign < 2; foreign++) {
        power("st7789", foreign);
        display.port->now_us = 1000000;
        SEND(0x3A, 0x55);
        SEND(0x2A, 0, 0, 0, 0);
        SEND(0x2B, 0, 0, 0, 0);
        SEND(0x2C, 1, 2, 3, 4);
        assert_int_equal(*first, 0x0304);
        SEND(0x2A, 0, 0, 1, 0);
        SEND(0x2C, 5, 6); /* into the window that there was */
        assert_int_equal(*first, 0x0506);
        check(foreign ? 4 : 0, foreign ? 0 : 4);
    }
}

static void a_pixel_that_is_cut_is_a_complaint_from_anybody(void **state)
{
    (void)state;
    power("st7789", true);
    display.port->now_us = 1000000;
    SEND(0x11);
    display.port->now_us += 1000000;
    SEND(0x3A, 0x55);
    SEND(0x2A, 0, 0, 0, 9);
    SEND(0x2B, 0, 0, 0, 9);
    SEND(0x2C, 1, 2, 3);
    SEND(0x2A, 0);
    SEND(0x00);
    check(0, 2);
}

static void an_oled_bears_scrolling_that_is_stopped(void **state)
{
    (void)state;
    power("ssd1306", true);
    display.port->now_us = 1000000;
    COMMANDS(0xAE, 0x2E, 0xE3, 0x8D, 0x14, 0xA8, 0x3F, 0xDA, 0x12, 0xE2, 0xAF);
    check(1, 0);
    assert_true(display.chip.pages.on);
    COMMANDS(0x26, 0, 0, 0, 7, 0, 0xFF); /* its arguments are no commands */
    check(2, 0);
    assert_true(display.chip.pages.on);
    COMMANDS(0xA5);
    check(2, 0);
    for (unsigned x = 0; x < 128; x++)
        assert_true(emulated_pages_is_bright(&display.chip.pages, x, x / 2));
    COMMANDS(0x20, 0x00, 0x21, 5, 4);
    check(3, 0);
}

/* As Linux' driver does: the start by the other mode's commands before each frame, and no window for the second. */
static void an_oled_bears_a_start_by_commands_of_its_other_mode(void **state)
{
    static uint8_t frame[1024];

    (void)state;
    power("ssd1306", true);
    display.port->now_us = 1000000;
    for (unsigned i = 0; i < sizeof frame; i++)
        frame[i] = (uint8_t)(i * 7 + i / 8);
    COMMANDS(0x20, 0x01, 0x21, 0, 127, 0x22, 0, 7);
    for (unsigned k = 0; k < 2; k++) {
        COMMANDS(0x00, 0x10);
        assert_int_equal(pin_set(&port.dc, true), 0);
        assert_int_equal(bus_write(&port.bus, frame, sizeof frame), 0);
        for (unsigned i = 0; i < sizeof frame; i++)
            assert_int_equal(display.chip.pages.memory[i % 8][i / 8], frame[i]);
        check(2 * (k + 1), 0);
    }
}

/* As u8g2 does: whole rows at once, and each page and first column by commands that are not of that mode. */
static void an_oled_takes_places_by_commands_of_its_other_mode(void **state)
{
    static const uint8_t places[][2] = {{5, 0x20}, {0, 0x7B}, {7, 0x05}};
    static const uint8_t bytes[] = {0x12, 0x34, 0x56};

    (void)state;
    power("ssd1306", true);
    display.port->now_us = 1000000;
    COMMANDS(0x20, 0x00);
    for (unsigned i = 0; i < sizeof places / sizeof *places; i++) {
        const uint8_t page = places[i][0], column = places[i][1];
        COMMANDS(0x10 | column >> 4, column & 15, 0xB0 | page);
        assert_int_equal(pin_set(&port.dc, true), 0);
        assert_int_equal(bus_write(&port.bus, bytes, sizeof bytes), 0);
        assert_memory_equal(&display.chip.pages.memory[page][column], bytes, sizeof bytes);
        check(3 * (i + 1), 0);
    }
}

static void an_lcd_of_pages_bears_its_supply_at_once(void **state)
{
    (void)state;
    for (int foreign = 0; foreign < 2; foreign++) {
        power("st7567", foreign);
        display.port->now_us = 1000000;
        COMMANDS(0x2F, 0xAF);
        check(foreign ? 2 : 0, foreign ? 0 : 2);
        assert_true(display.chip.pages.on);
    }
}

/* As u8g2 does on a fast processor: 50 ns before and behind each message; and LovyanGFX, turned: lines beyond the last.
 */
static void a_memory_lcd_bears_short_waits_and_lines_beyond_the_last(void **state)
{
    static uint8_t before[sizeof display.chip.sharp.memory];

    (void)state;
    for (int foreign = 0; foreign < 2; foreign++) {
        uint8_t message[1 + 1 + 16 + 2] = {0x80, 0x40, 0x0F}; /* line 2 */
        power("ls013b7dh03", foreign);
        assert_int_equal(pin_set(&port.select, true), 0);
        assert_int_equal(bus_write(&port.bus, message, sizeof message), 0);
        assert_int_equal(pin_set(&port.select, false), 0);
        assert_int_equal(pin_set(&port.select, true), 0);
        check(foreign ? 3 : 0, foreign ? 0 : 3);
        assert_int_equal(display.chip.sharp.memory[1][0], 0x0F);
        memcpy(before, display.chip.sharp.memory, sizeof before);
        message[1] = 0x81; /* line 129 */
        message[2] = 0x55;
        assert_int_equal(bus_write(&port.bus, message, sizeof message), 0);
        check(foreign ? 5 : 0, foreign ? 0 : 5);
        assert_memory_equal(before, display.chip.sharp.memory, sizeof before);
    }
}

static void an_oled_with_windows_bears_what_it_does_not_know(void **state)
{
    (void)state;
    for (int foreign = 0; foreign < 2; foreign++) {
        power("ssd1327", foreign);
        COMMANDS(0x99, 0xB1, 0x51);
        check(foreign ? 1 : 0, foreign ? 0 : 1);
        COMMANDS(0x15, 5, 4);
        check(foreign ? 2 : 0, foreign ? 0 : 2);
        COMMANDS(0xA0, 0x11); /* odd and even lines are not apart */
        check(foreign ? 2 : 0, foreign ? 1 : 3);
    }
}

/* Commands are more frequent than data, and small numbers than large ones, so that many are understood. What is seen is
 * asked for again and again: registers of any values must not lead out of memory. */
static void any_bytes_are_borne_by_every_module(void **state)
{
    static uint8_t rgb[3 * 320 * 480];
    uint32_t chance = 1;

    (void)state;
    for (const struct glass *row = glass_rows; row->chip; row++) {
        emulated_display_init(&display, row);
        display.port->deferred = false;
        display.port->timeless = true;
        port = emulated_port_whole(display.port);
        for (unsigned i = 0; i < 3000; i++) {
            chance = chance * 1664525u + 1013904223u;
            const uint8_t byte = (uint8_t)(chance >> 24), wide = (uint8_t)(chance >> 16);
            if (pin_is_wired(&port.dc)) assert_int_equal(pin_set(&port.dc, wide & 1), 0);
            if (pin_is_wired(&port.select)) assert_int_equal(pin_set(&port.select, wide & 15), 0);
            assert_int_equal(bus_write(&port.bus, &byte, 1), 0);
            if (i % 500 == 0) emulated_display_show(&display, rgb);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_lcd_bears_vendors_registers),
        cmocka_unit_test(an_lcd_that_is_not_waited_for_goes_on),
        cmocka_unit_test(an_lcd_bears_pixels_too_early_and_too_many),
        cmocka_unit_test(a_pixel_that_is_cut_is_a_complaint_from_anybody),
        cmocka_unit_test(an_oled_bears_scrolling_that_is_stopped),
        cmocka_unit_test(an_oled_bears_a_start_by_commands_of_its_other_mode),
        cmocka_unit_test(an_oled_takes_places_by_commands_of_its_other_mode),
        cmocka_unit_test(an_lcd_of_pages_bears_its_supply_at_once),
        cmocka_unit_test(a_memory_lcd_bears_short_waits_and_lines_beyond_the_last),
        cmocka_unit_test(an_oled_with_windows_bears_what_it_does_not_know),
        cmocka_unit_test(any_bytes_are_borne_by_every_module),
    };
    return cmocka_run_group_tests_name("notices", tests, NULL, NULL);
}
