/* SPDX-License-Identifier: MIT
 *
 * Solomon Systech's controllers, beside what test_every_panel.c shows of all panels: glass of any make, what a chip
 * cannot, and what the emulated chips complain about. */
#include "glass/emulated_solomon.h"
#include "panels.h"
#include "rigs/cmocka_ready.h"
#include "screen.h"

#include <string.h>

enum { W_PX = 48, H_PX = 40 };

static struct rig {
    struct emulated_solomon chip;
    struct solomon_config config;
    struct solomon display;
    struct screen screen;
    uint32_t mem[SCREEN_PAGES_MEM_B(128, 2) / 4];
} rig;

/* An emulated module of a make, and a configuration for the usual one. */
static void rig_setup(const struct solomon_chip *driver)
{
    const struct glass glass = glass_like(driver->name, W_PX, H_PX, 10, 0);
    emulated_solomon_init(&rig.chip, &glass);
    rig.chip.port.deferred = true;
    rig.config = (struct solomon_config){.bus = emulated_port_bus(&rig.chip.port),
                                         .dc = emulated_port_dc(&rig.chip.port),
                                         .reset = emulated_port_reset(&rig.chip.port),
                                         .clock = emulated_port_clock(&rig.chip.port),
                                         .w_px = W_PX,
                                         .h_px = H_PX,
                                         .ox_px = 10};
}

static void rig_start(const struct solomon_chip *driver)
{
    assert_int_equal(solomon_setup(&rig.display, driver, &rig.config), 0);
    assert_int_equal(screen_init(&rig.screen, &rig.display.panel, LIM_NEAREST_FIRST, rig.mem, sizeof rig.mem), 0);
    assert_int_equal(panel_init(&rig.display.panel), 0);
}

/* On the glass, of a picture that is upright or turned by half. */
static void see(unsigned x, unsigned y, uint8_t rgb[3])
{
    const bool turned = rig.display.rotation == PANEL_TURNED_180;

    emulated_solomon_see(&rig.chip, turned ? W_PX - 1 - x : x, turned ? H_PX - 1 - y : y, rgb);
}

/* Black, but for a white spot at x, y and a red one beside it: seen there by the picture's viewer. */
static void check_spot(unsigned x, unsigned y)
{
    const struct lim_target *target = &rig.screen.target;
    uint8_t rgb[3];

    assert_int_equal(screen_begin_frame(&rig.screen), 0);
    for (uint16_t line_y = 0; line_y < target->h_px; line_y++) {
        uint8_t *line = target->lend(target->ctx, line_y);
        memset(line, 0, 2u * target->w_px);
        if (line_y == y) memcpy(&line[2 * x], "\xFF\xFF\xF8\x00", 4);
        assert_int_equal(target->done(target->ctx, line_y, 0, target->w_px), 0);
    }
    assert_int_equal(screen_end_frame(&rig.screen), 0);
    see(x, y, rgb);
    assert_memory_equal(rgb, "\xFF\xFF\xFF", 3);
    see(x + 1, y, rgb);
    const bool is_grey = rig.display.panel.format == PANEL_GREY4;
    assert_true(rgb[0] > 50 && rgb[2] == (is_grey ? rgb[0] : 0));
    see(x - 1, y, rgb);
    assert_memory_equal(rgb, "\0\0\0", 3);
    if (rig.chip.complaints) fail_msg("%u complaints, the last: %s", rig.chip.complaints, rig.chip.complaint);
}

/* The lines of glass whose maker shifts them by so much, upright; and the shift that it needs turned by half. */
static unsigned shift_lines(struct glass *glass, bool flipped, unsigned shift)
{
    const unsigned all = glass->mem_h_px, from = glass->told_lines ? H_PX : all;

    glass->line = (uint16_t)((flipped ? all - shift : from - 1 + shift) % all);
    glass->lines_back = !flipped;
    return ((glass->told_lines ? 0u : H_PX) + all - shift) % all;
}

static void check_make(const struct solomon_chip *chip, unsigned make)
{
    struct glass *glass = &rig.chip.glass;

    rig_setup(chip);
    rig.config.flip_columns = make & 1;
    rig.config.flip_rows = make & 2;
    rig.config.bgr = make & 4;
    rig.config.invert = glass->negative = make & 8;
    rig.config.shift = make & 16 ? 32 : 0;
    rig.config.shift_turned = (uint8_t)shift_lines(glass, make & 2, rig.config.shift);
    if (make & 1) {
        glass->column = (uint16_t)(glass->mem_w_px - 1 - glass->column);
        glass->columns_back = !glass->columns_back;
    }
    if (make & 4) glass->blue_first = !glass->blue_first;
    rig_start(chip);
    check_spot(3, 5);
    assert_int_equal(panel_set_rotation(&rig.display.panel, PANEL_TURNED_180), 0);
    check_spot(3, 5);
    assert_int_equal(panel_set_rotation(&rig.display.panel, PANEL_UPRIGHT), 0);
    check_spot(W_PX - 2, H_PX - 1);
}

static void glass_of_any_make_shows_the_picture(void **state)
{
    (void)state;
    for (size_t i = 0; panels_solomon[i]; i++)
        for (unsigned make = 0; make < 32; make++)
            check_make(panels_solomon[i], make);
}

static void grey_is_not_turned_by_quarters_and_colours_are(void **state)
{
    (void)state;
    for (size_t i = 0; panels_solomon[i]; i++) {
        const bool can = panels_solomon[i] == &ssd1351;
        rig_setup(panels_solomon[i]);
        rig_start(panels_solomon[i]);
        assert_int_equal(panel_set_rotation(&rig.display.panel, PANEL_TURNED_90), can ? 0 : PANEL_ERR_UNSUPPORTED);
        assert_int_equal(rig.display.panel.w_px, can ? H_PX : W_PX);
        assert_int_equal(panel_set_rotation(&rig.display.panel, (enum panel_rotation)4), PANEL_ERR_UNSUPPORTED);
        rig.config.rotation = PANEL_TURNED_270;
        assert_int_equal(solomon_setup(&rig.display, panels_solomon[i], &rig.config), can ? 0 : PANEL_ERR_CONFIG);
    }
}

/* The argument of the command that chooses the glass's voltage, on its way to the display. */
struct converter_spy {
    struct bus bus;
    uint8_t command, before, argument;
};

static int spy_write(void *ctx, const uint8_t *data, size_t n_b)
{
    struct converter_spy *spy = ctx;

    if (spy->before == spy->command && n_b == 1) spy->argument = data[0];
    spy->before = n_b == 1 ? data[0] : 0;
    return bus_write(&spy->bus, data, n_b);
}

static int spy_flush(void *ctx)
{
    return bus_flush(&((struct converter_spy *)ctx)->bus);
}

static void the_glass_gets_its_voltage_from_where_it_is_made(void **state)
{
    (void)state;
    for (int own = 0; own < 2; own++) {
        rig_setup(&ssd0323);
        struct converter_spy spy = {.bus = rig.config.bus, .command = 0xAD};
        rig.config.bus = (struct bus){.ctx = &spy, .write = spy_write, .flush = spy_flush};
        rig.config.converter = own;
        assert_int_equal(solomon_setup(&rig.display, &ssd0323, &rig.config), 0);
        assert_int_equal(panel_init(&rig.display.panel), 0);
        assert_int_equal(spy.argument, own ? 0x03 : 0x02);
    }
    rig.config.converter = true;
    assert_int_equal(solomon_setup(&rig.display, &ssd1327, &rig.config), PANEL_ERR_CONFIG);
}

static void what_a_chip_cannot_is_refused(void **state)
{
    (void)state;
    for (size_t i = 0; panels_solomon[i]; i++) {
        const struct solomon_chip *chip = panels_solomon[i];
        const bool is_grey = chip->column_px == 2;
        rig_setup(chip);
        struct solomon_config bad[10];
        for (unsigned k = 0; k < 10; k++)
            bad[k] = rig.config;
        bad[0].w_px = 0;
        bad[1].h_px = 0;
        bad[2].h_px = (uint16_t)(chip->mem_h_px + 1);
        bad[3].ox_px = (uint16_t)(chip->mem_w_px - W_PX + 2);
        bad[4].format = PANEL_RGB444;
        bad[5].bus.write = NULL;
        bad[6].dc.set = NULL;
        bad[7].clock.delay = NULL;
        bad[8].w_px = W_PX - 1;
        bad[9].ox_px = 11;
        for (unsigned k = 0; k < 8; k++)
            assert_int_equal(solomon_setup(&rig.display, chip, &bad[k]), PANEL_ERR_CONFIG);
        for (unsigned k = 8; k < 10; k++)
            assert_int_equal(solomon_setup(&rig.display, chip, &bad[k]), is_grey ? PANEL_ERR_CONFIG : 0);
        rig_start(chip);
        struct panel *panel = &rig.display.panel;
        assert_int_equal(panel_window(panel, 0, 0, W_PX + 2, 1), PANEL_ERR_WINDOW);
        assert_int_equal(panel_window(panel, 0, H_PX, 2, 1), PANEL_ERR_WINDOW);
        assert_int_equal(panel_window(panel, 1, 0, 2, 1), is_grey ? PANEL_ERR_WINDOW : 0);
        assert_int_equal(panel_window(panel, 0, 0, 2, 1), 0);
        assert_int_equal(panel_pixels(panel, rig.mem, 4), PANEL_ERR_WINDOW);
        assert_int_equal(panel_pixels(panel, rig.mem, 2), PANEL_ERR_WINDOW);
        assert_int_equal(panel_set_backlight(panel, true), PANEL_ERR_UNSUPPORTED);
    }
}

/* Memory is written as the window and the remap say, so a frame costs its pixels and one window. */
static void a_frame_is_one_window(void **state)
{
    (void)state;
    rig_setup(&ssd1327);
    rig_start(&ssd1327);
    const uint64_t before_b = rig.chip.port.bus_b;
    check_spot(3, 5);
    assert_int_equal(rig.chip.port.bus_b - before_b, 6 + W_PX * H_PX / 2);
}

/* What the emulated chips notice. */
static void mistakes_are_complained_about(void **state)
{
    static const struct {
        const struct solomon_chip *chip;
        uint8_t bytes[8], n_b; /* the first with D/C low, the others as the chip wants arguments or pixels */
    } mistakes[] = {{&ssd1351, {0x2E}, 1},
                    {&ssd1351, {0xB1, 0x32}, 2}, /* locked */
                    {&ssd1351, {0xFD, 0x77}, 2},
                    {&ssd1351, {0x15, 5, 4}, 3},
                    {&ssd1351, {0x75, 0, 128}, 3},
                    {&ssd1351, {0xA0, 0x34}, 2},       /* 256 colours */
                    {&ssd1351, {0xA0, 0x54}, 2},       /* lines wired otherwise */
                    {&ssd1351, {0xA6, 0x00}, 2},       /* pixels without 5Ch */
                    {&ssd1327, {0xA8, 0x1F, 0xAF}, 3}, /* fewer lines than the glass has */
                    {&ssd1327, {0x5C}, 1},
                    {&ssd1327, {0xA0, 0xD1}, 2},
                    {&ssd0323, {0x75, 0, 80}, 3},
                    {&ssd0323, {0xFD, 0xB1}, 2}};
    (void)state;
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++) {
        rig_setup(mistakes[i].chip);
        rig.chip.port.deferred = false;
        assert_int_equal(bus_write(&rig.config.bus, mistakes[i].bytes, 1), 0);
        assert_int_equal(pin_set(&rig.config.dc, !mistakes[i].chip->args_low), 0);
        assert_int_equal(bus_write(&rig.config.bus, &mistakes[i].bytes[1], mistakes[i].n_b - 1u), 0);
        if (!rig.chip.complaints) fail_msg("mistake %zu of a %s went unnoticed", i, mistakes[i].chip->name);
    }
}

static void pixels_too_many_cut_or_too_early_are_complained_about(void **state)
{
    const uint8_t pixels[8] = {0};

    (void)state;
    for (size_t i = 0; panels_solomon[i]; i++) {
        rig_setup(panels_solomon[i]);
        rig.chip.port.deferred = false;
        rig_start(panels_solomon[i]);
        assert_int_equal(panel_window(&rig.display.panel, 0, 0, 2, 1), 0);
        assert_int_equal(pin_set(&rig.config.dc, true), 0);
        assert_int_equal(bus_write(&rig.config.bus, pixels, 8), 0);
        assert_true(rig.chip.complaints > 0);
    }
    rig_setup(&ssd1351);
    rig.chip.port.deferred = false;
    rig_start(&ssd1351);
    assert_int_equal(panel_window(&rig.display.panel, 0, 0, 2, 1), 0);
    assert_int_equal(pin_set(&rig.config.dc, true), 0);
    assert_int_equal(bus_write(&rig.config.bus, pixels, 1), 0);
    assert_int_equal(pin_set(&rig.config.dc, false), 0);
    assert_int_equal(bus_write(&rig.config.bus, (const uint8_t[]){0xA6}, 1), 0);
    assert_int_equal(rig.chip.complaints, 1);
    assert_int_equal(pin_set(&rig.config.reset, false), 0);
    assert_int_equal(bus_write(&rig.config.bus, pixels, 1), 0);
    assert_int_equal(pin_set(&rig.config.reset, true), 0);
    assert_int_equal(rig.chip.complaints, 3); /* a byte during the reset, which was too short */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(glass_of_any_make_shows_the_picture),
        cmocka_unit_test(grey_is_not_turned_by_quarters_and_colours_are),
        cmocka_unit_test(the_glass_gets_its_voltage_from_where_it_is_made),
        cmocka_unit_test(what_a_chip_cannot_is_refused),
        cmocka_unit_test(a_frame_is_one_window),
        cmocka_unit_test(mistakes_are_complained_about),
        cmocka_unit_test(pixels_too_many_cut_or_too_early_are_complained_about),
    };
    return cmocka_run_group_tests_name("solomon", tests, NULL, NULL);
}
