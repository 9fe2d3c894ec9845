/* SPDX-License-Identifier: MIT
 *
 * Monochrome panels of pages, beside what test_every_panel.c shows of all panels: with and without reset, glass of any
 * make, what a chip cannot, and what the emulated chips complain about. */
#include "cmocka_ready.h"
#include "emulated_pages.h"
#include "fault_port.h"
#include "panels.h"
#include "screen.h"
#include "test_card.h"

#include <math.h>
#include <string.h>

enum { MOST_W_PX = 132, MOST_H_PX = 64 };

static struct rig {
    struct emulated_pages chip;
    struct fault_port fault;
    struct pages_config config;
    struct pages display;
    struct screen screen;
    uint32_t mem[SCREEN_PAGES_MEM_B(MOST_W_PX, MOST_H_PX) / 4];
} rig;

static void rig_setup(const struct pages_chip *driver, uint16_t w_px, uint16_t h_px)
{
    const struct emulated_pages_module module = {.kind = emulated_pages_kind_find(driver->name),
                                                 .w_px = w_px,
                                                 .h_px = h_px,
                                                 .ox_px = (uint16_t)((driver->mem_w_px - w_px) / 3)};
    emulated_pages_init(&rig.chip, &module);
    rig.chip.port.deferred = true;
    rig.fault = (struct fault_port){.bus = emulated_port_bus(&rig.chip.port),
                                    .dc = {.inner = emulated_port_dc(&rig.chip.port)},
                                    .reset = {.inner = emulated_port_reset(&rig.chip.port)},
                                    .backlight = {.inner = emulated_port_backlight(&rig.chip.port)},
                                    .clock = emulated_port_clock(&rig.chip.port),
                                    .pending_b = &rig.chip.port.pending_b};
    fault_port_arm(&rig.fault, -1);
    rig.config = (struct pages_config){.bus = fault_port_bus(&rig.fault),
                                       .dc = fault_port_pin(&rig.fault, &rig.fault.dc),
                                       .reset = fault_port_pin(&rig.fault, &rig.fault.reset),
                                       .backlight = fault_port_pin(&rig.fault, &rig.fault.backlight),
                                       .clock = fault_port_clock(&rig.fault),
                                       .w_px = w_px,
                                       .h_px = h_px,
                                       .ox_px = module.ox_px};
}

static void rig_open(const struct pages_chip *driver, unsigned n_lines)
{
    assert_int_equal(pages_setup(&rig.display, driver, &rig.config), 0);
    const size_t mem_b = SCREEN_PAGES_MEM_B(rig.config.w_px, n_lines);
    assert_int_equal(screen_init(&rig.screen, &rig.display.panel, LIM_NEAREST_FIRST, rig.mem, mem_b), 0);
}

/* Red, green, blue and grey corners; a ramp elsewhere. */
static uint16_t card_px(unsigned x, unsigned y)
{
    uint16_t corner;

    return test_card_corner(x, y, rig.config.w_px, rig.config.h_px, &corner) ? corner : (uint16_t)(x * 211u + y * 31u);
}

/* In pieces of at most piece_px, junk first. */
static int draw(unsigned piece_px)
{
    const struct lim_target *target = &rig.screen.target;

    const int late = screen_begin_frame(&rig.screen);
    if (late) return late;
    for (uint16_t y = 0; y < target->h_px; y++) {
        uint8_t *line = target->lend(target->ctx, y);
        memset(line, 0xEE, 2u * target->w_px);
        for (unsigned x = 0; x < target->w_px; x++) {
            line[2 * x] = (uint8_t)(card_px(x, y) >> 8);
            line[2 * x + 1] = (uint8_t)card_px(x, y);
        }
        for (unsigned x = 0; x < target->w_px; x += piece_px) {
            const unsigned n = target->w_px - x < piece_px ? target->w_px - x : piece_px;
            const int err = target->done(target->ctx, y, (uint16_t)x, (uint16_t)n);
            if (err) return err;
        }
    }
    return screen_end_frame(&rig.screen);
}

/* Bayer's order of 2^k x 2^k, from that of half the size: each quarter is filled in the order of the whole. */
static unsigned order_of(unsigned x, unsigned y, unsigned k)
{
    static const unsigned two[2][2] = {{0, 2}, {3, 1}};

    return k ? 4 * order_of(x % (1u << (k - 1)), y % (1u << (k - 1)), k - 1) + two[y >> (k - 1) & 1][x >> (k - 1) & 1]
             : 0;
}

static bool is_bright(unsigned x, unsigned y)
{
    const uint16_t px = card_px(x, y);
    const double level = 0.299 * (px >> 11) / 31 + 0.587 * (px >> 5 & 63) / 63 + 0.114 * (px & 31) / 31;

    return level + (2 * order_of(x % 8, y % 8, 3) + 1) / 128.0 >= 1.0;
}

/* Nearly all: on a threshold the brightness, rounded to 2^-16, may fall otherwise. */
static void assert_shown(bool turned, bool mirrored, bool inverted)
{
    unsigned wrong = 0;

    for (unsigned y = 0; y < rig.config.h_px; y++)
        for (unsigned x = 0; x < rig.config.w_px; x++) {
            const unsigned right = rig.config.w_px - 1u - x, below = rig.config.h_px - 1u - y;
            const bool shown = emulated_pages_is_bright(&rig.chip, turned != mirrored ? right : x, turned ? below : y);
            wrong += shown != (is_bright(x, y) != inverted);
        }
    if (rig.chip.complaints) fail_msg("%u complaints, the last: %s", rig.chip.complaints, rig.chip.complaint);
    if (wrong > 4) fail_msg("%s: %u pixels are wrong", rig.display.chip->name, wrong);
}

static void check_card(const struct pages_chip *chip, uint16_t w_px, uint16_t h_px)
{
    for (unsigned way = 0; way < (chip->flip ? 4u : 1u); way++)
        for (unsigned wired = 0; wired < 2; wired++) {
            rig_setup(chip, w_px, h_px);
            rig.config.rotation = way & 1 ? PANEL_TURNED_180 : PANEL_UPRIGHT;
            rig.config.mirror = way & 2;
            if (!wired) rig.config.reset.set = NULL;
            rig_open(chip, 2);
            assert_int_equal(panel_init(&rig.display.panel), 0);
            assert_int_equal(draw(wired ? w_px : 7), 0);
            assert_shown(way & 1, way & 2, false);
            assert_int_equal(panel_set_inverted(&rig.display.panel, true), 0);
            assert_shown(way & 1, way & 2, true);
        }
}

static void the_card_is_right_on_every_chip(void **state)
{
    (void)state;
    for (size_t i = 0; panels_pages[i]; i++) {
        check_card(panels_pages[i], panels_pages[i]->mem_w_px, panels_pages[i]->mem_h_px);
        check_card(panels_pages[i], 37, 32);
    }
}

/* Glass that shows memory from the other end, or bright where a pixel is off, and a configuration that says so. */
static void glass_of_any_make_shows_the_card(void **state)
{
    (void)state;
    for (size_t i = 0; panels_pages[i]; i++)
        for (unsigned make = 0; make < (panels_pages[i]->flip ? 8u : 2u); make++) {
            rig_setup(panels_pages[i], 48, 48);
            rig.chip.module.negative = rig.config.invert = make & 1;
            rig.chip.module.first_columns = rig.config.flip_columns = make & 2;
            rig.chip.module.first_lines = rig.config.flip_rows = make & 4;
            rig_open(panels_pages[i], 2);
            assert_int_equal(panel_init(&rig.display.panel), 0);
            assert_int_equal(draw(48), 0);
            assert_shown(false, false, false);
        }
}

static void what_a_chip_cannot_is_refused(void **state)
{
    (void)state;
    for (size_t i = 0; panels_pages[i]; i++) {
        const struct pages_chip *chip = panels_pages[i];
        rig_setup(chip, 48, 48);
        const struct pages_config good = rig.config;
        struct pages_config bad[9];
        for (unsigned k = 0; k < 9; k++)
            bad[k] = good;
        bad[0].w_px = 0;
        bad[1].h_px = 20;
        bad[2].h_px = (uint16_t)(chip->mem_h_px + 8);
        bad[3].w_px = (uint16_t)(chip->mem_w_px + 1);
        bad[4].ox_px = (uint16_t)(chip->mem_w_px - 47);
        bad[5].rotation = PANEL_TURNED_90;
        bad[6].bus.write = NULL;
        bad[7].dc.set = NULL;
        bad[8].clock.delay = NULL;
        for (unsigned k = 0; k < 9; k++)
            assert_int_equal(pages_setup(&rig.display, chip, &bad[k]), PANEL_ERR_CONFIG);
        bad[0] = good;
        bad[0].mirror = true;
        assert_int_equal(pages_setup(&rig.display, chip, &bad[0]), chip->flip ? 0 : PANEL_ERR_CONFIG);
        rig_open(chip, 1);
        assert_int_equal(panel_window(&rig.display.panel, 0, 4, 8, 8), PANEL_ERR_WINDOW);
        assert_int_equal(panel_window(&rig.display.panel, 0, 0, 49, 8), PANEL_ERR_WINDOW);
        assert_int_equal(panel_pixels(&rig.display.panel, rig.mem, 8), PANEL_ERR_WINDOW);
    }
}

/* What the emulated chips notice. */
static void mistakes_are_complained_about(void **state)
{
    static const struct {
        const char *chip;
        uint8_t commands[8], n_b;
    } mistakes[] = {{"ssd1306", {0xAF}, 1},       {"ssd1306", {0x20, 0x00}, 2}, {"ssd1306", {0x2F}, 1},
                    {"ssd1306", {0xDA, 0x02}, 2}, {"sh1106", {0x8D}, 1},        {"st7567", {0x2F}, 1},
                    {"st7567", {0xAF}, 1},        {"pcd8544", {0x0C}, 1},       {"pcd8544", {0x01}, 1},
                    {"pcd8544", {0x22}, 1},       {"pcd8544", {0x21, 0x01}, 2}};
    (void)state;
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++) {
        struct emulated_pages *chip = &rig.chip;
        const struct emulated_pages_module module = {emulated_pages_kind_find(mistakes[i].chip), 84, 48, 0, 0, 0, 0};
        emulated_pages_init(chip, &module);
        if (strcmp(mistakes[i].chip, "ssd1306") == 0 && i == 3) chip->module.h_px = 64;
        const struct bus bus = emulated_port_bus(&chip->port);
        assert_int_equal(bus_write(&bus, mistakes[i].commands, mistakes[i].n_b), 0);
        if (!chip->complaints) fail_msg("mistake %zu of a %s went unnoticed", i, mistakes[i].chip);
    }
    const struct emulated_pages_module module = {emulated_pages_kind_find("sh1106"), 128, 64, 2, 0, 0, 0};
    const uint8_t byte = 0;
    emulated_pages_init(&rig.chip, &module);
    const struct bus bus = emulated_port_bus(&rig.chip.port);
    const struct pin dc = emulated_port_dc(&rig.chip.port);
    assert_int_equal(bus_write(&bus, (const uint8_t[]){0x18, 0x04}, 2), 0); /* column 132 */
    assert_int_equal(pin_set(&dc, true), 0);
    assert_int_equal(bus_write(&bus, &byte, 1), 0);
    assert_int_equal(rig.chip.complaints, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_card_is_right_on_every_chip),
        cmocka_unit_test(glass_of_any_make_shows_the_card),
        cmocka_unit_test(what_a_chip_cannot_is_refused),
        cmocka_unit_test(mistakes_are_complained_about),
    };
    return cmocka_run_group_tests_name("pages", tests, NULL, NULL);
}
