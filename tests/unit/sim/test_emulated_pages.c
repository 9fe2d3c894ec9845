/* SPDX-License-Identifier: MIT
 *
 * The emulated controllers of pages, told by hand: what they complain about, and how an SSD1306's window runs on. */
#include "glass/emulated_pages.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

static struct emulated_pages chip;

static void power(const char *name, unsigned w_px, unsigned h_px, unsigned ox_px)
{
    const struct glass glass = glass_like(name, w_px, h_px, ox_px, 0);
    emulated_pages_init(&chip, &glass);
}

static void mistakes_are_complained_about(void **state)
{
    static const struct {
        const char *chip;
        uint8_t commands[8], n_b;
    } mistakes[] = {{"ssd1306", {0xAF}, 1},
                    {"ssd1306", {0x20, 0x03}, 2},
                    {"ssd1306", {0x2F}, 1},
                    {"ssd1306", {0xDA, 0x02}, 2},
                    {"sh1106", {0x8D}, 1},
                    {"st7567", {0x2F}, 1},
                    {"st7567", {0xAF}, 1},
                    {"pcd8544", {0x0C}, 1},
                    {"pcd8544", {0x01}, 1},
                    {"pcd8544", {0x21, 0x01}, 2},
                    {"ssd1306", {0x21, 0, 127}, 3}, /* addressed page by page */
                    {"ssd1306", {0x20, 0, 0xB0}, 3},
                    {"ssd1306", {0x20, 0, 0x00}, 3},
                    {"ssd1306", {0x20, 0, 0x21, 0, 128}, 5},
                    {"ssd1306", {0x20, 0, 0x21, 5, 4}, 5},
                    {"ssd1306", {0x20, 0, 0x22, 0, 8}, 5},
                    {"ssd1306", {0x20, 0, 0x22, 2, 1}, 5},
                    {"sh1106", {0x21}, 1}};
    (void)state;
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++) {
        power(mistakes[i].chip, 84, 48, 0);
        const struct bus bus = emulated_port_bus(&chip.port);
        assert_int_equal(bus_write(&bus, mistakes[i].commands, mistakes[i].n_b), 0);
        if (!chip.complaints) fail_msg("mistake %zu of a %s went unnoticed", i, mistakes[i].chip);
    }
    const uint8_t byte = 0;
    power("sh1106", 128, 64, 2);
    const struct bus bus = emulated_port_bus(&chip.port);
    const struct pin dc = emulated_port_dc(&chip.port);
    assert_int_equal(bus_write(&bus, (const uint8_t[]){0x18, 0x04}, 2), 0); /* column 132 */
    assert_int_equal(pin_set(&dc, true), 0);
    assert_int_equal(bus_write(&bus, &byte, 1), 0);
    assert_int_equal(chip.complaints, 1);
}

/* Horizontal addressing of the emulated SSD1306, told and filled by hand. */
static void send_to_ssd1306(const uint8_t *commands, size_t commands_b, const uint8_t *data, size_t data_b)
{
    const struct bus bus = emulated_port_bus(&chip.port);
    const struct pin dc = emulated_port_dc(&chip.port);

    assert_int_equal(pin_set(&dc, false), 0);
    assert_int_equal(bus_write(&bus, commands, commands_b), 0);
    assert_int_equal(pin_set(&dc, true), 0);
    assert_int_equal(bus_write(&bus, data, data_b), 0);
}

static void an_emulated_window_runs_on_to_its_end_and_is_full_then(void **state)
{
    static const uint8_t window[] = {0x20, 0x00, 0x21, 126, 127, 0x22, 6, 7}, data[] = {1, 2, 3, 4, 5, 6};

    (void)state;
    power("ssd1306", 128, 64, 0);
    send_to_ssd1306(window, sizeof window, data, 3);
    assert_memory_equal(&chip.memory[6][126], data, 2);
    assert_int_equal(chip.memory[7][126], 3);
    send_to_ssd1306(window + 2, 3, data + 4, 1); /* columns alone: the page stays */
    assert_int_equal(chip.memory[7][126], 5);
    send_to_ssd1306(window, sizeof window, data, 4);
    assert_memory_equal(&chip.memory[7][126], data + 2, 2);
    assert_int_equal(chip.complaints, 0);
    send_to_ssd1306(NULL, 0, data + 4, 1); /* round again, which no driver means */
    assert_int_equal(chip.memory[6][126], 5);
    assert_int_equal(chip.complaints, 1);
    send_to_ssd1306(window + 2, 2, data, 1);
    assert_int_equal(chip.complaints, 2); /* data for an argument */
}

/* By the datasheets' formulas, in other terms: at 63 an ST7567 has all of 2.1 V times the ratio. */
static void the_voltage_of_the_glass_is_by_the_datasheet(void **state)
{
    static const struct {
        const char *chip;
        uint8_t commands[4], n_b;
        unsigned mv;
    } supplies[] = {{"st7567", {0x27, 0x81, 63}, 3, 13650},
                    {"st7567", {0x20, 0x81, 63}, 3, 6300},
                    {"st7567", {0x24, 0x81, 0}, 3, 6416},
                    {"pcd8544", {0x21, 0x80}, 2, 3060},
                    {"pcd8544", {0x21, 0xFF}, 2, 10680},
                    {"sh1106", {0xE3}, 1, 8000},
                    {"sh1106", {0x30}, 1, 6400},
                    {"sh1106", {0x33}, 1, 9000},
                    {"ssd1306", {0x81, 255}, 2, 0}};
    (void)state;
    for (size_t i = 0; i < sizeof supplies / sizeof *supplies; i++) {
        power(supplies[i].chip, 84, 48, 0);
        chip.port.now_us += 1000000;
        const struct bus bus = emulated_port_bus(&chip.port);
        assert_int_equal(bus_write(&bus, supplies[i].commands, supplies[i].n_b), 0);
        assert_in_range(emulated_pages_supply_mv(&chip), supplies[i].mv, supplies[i].mv + 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mistakes_are_complained_about),
        cmocka_unit_test(the_voltage_of_the_glass_is_by_the_datasheet),
        cmocka_unit_test(an_emulated_window_runs_on_to_its_end_and_is_full_then),
    };
    return cmocka_run_group_tests_name("emulated_pages", tests, NULL, NULL);
}
