/* SPDX-License-Identifier: MIT
 *
 * The packing of pixels, against formulas of its own; and what single chips of the DCS family have beside what
 * test_every_panel.c shows of all. */
#include "rigs/panels/dcs_rig.h"

#include <math.h>

enum { ODD_W_PX = 17, ODD_H_PX = 24 };

/* Bayer's order, from that of 2x2: each quarter is filled in the order of the whole. */
static unsigned order_of(unsigned x, unsigned y)
{
    static const unsigned two[2][2] = {{0, 2}, {3, 1}};

    return 4 * two[y % 2][x % 2] + two[y / 2 % 2][x / 2 % 2];
}

static unsigned dithered(unsigned value, unsigned most, unsigned x, unsigned y)
{
    return (unsigned)floor(15.0 * value / most + (2 * order_of(x, y) + 1) / 32.0 + 1e-9);
}

/* What the chip ought to have in its memory. */
static uint32_t raw_of(enum panel_format format, uint16_t rgb565, unsigned x, unsigned y)
{
    const unsigned red = rgb565 >> 11, green = rgb565 >> 5 & 63, blue = rgb565 & 31;

    if (format == PANEL_RGB565) return rgb565;
    if (format == PANEL_RGB444)
        return dithered(red, 31, x, y) << 8 | dithered(green, 63, x, y) << 4 | dithered(blue, 31, x, y);
    return (uint32_t)floor(red * 63 / 31.0 + 0.5) << 18 | green << 10 | (uint32_t)floor(blue * 63 / 31.0 + 0.5) << 2;
}

/* Pixels ------------------------------------------------------------------------------------- */

static void every_colour_is_packed_as_the_formula_says(void **state)
{
    (void)state;
    for (uint32_t rgb565 = 0; rgb565 < 65536; rgb565++) {
        const uint8_t from[2] = {(uint8_t)(rgb565 >> 8), (uint8_t)rgb565};
        for (unsigned place = 0; place < 16; place++) {
            const uint16_t x = (uint16_t)(place % 4 + 4 * (rgb565 % 7)), y = (uint16_t)(place / 4 + 4 * (rgb565 % 5));
            uint8_t to[3] = {0};
            pixels_pack(PANEL_RGB444, to, from, x, y, 1);
            const uint32_t raw = raw_of(PANEL_RGB444, (uint16_t)rgb565, x, y);
            if (to[0] != raw >> 4 || to[1] != (raw << 4 & 0xF0)) fail_msg("rgb444 of %04x at %u", rgb565, place);
        }
        uint8_t to[3];
        pixels_pack(PANEL_RGB666, to, from, 0, 0, 1);
        const uint32_t raw = (uint32_t)to[0] << 16 | (uint32_t)to[1] << 8 | to[2];
        if (raw != raw_of(PANEL_RGB666, (uint16_t)rgb565, 0, 0)) fail_msg("rgb666 of %04x is %06x", rgb565, raw);
        pixels_pack(PANEL_RGB666_LOW, to, from, 0, 0, 1);
        const uint32_t low = (uint32_t)to[0] << 16 | (uint32_t)to[1] << 8 | to[2];
        if (low != raw >> 2) fail_msg("rgb666 of %04x in the low bits is %06x", rgb565, low);
    }
}

static void dither_keeps_the_mean_and_black_and_white(void **state)
{
    (void)state;
    for (unsigned level = 0; level < 32; level++) {
        unsigned sum = 0;
        for (unsigned place = 0; place < 16; place++) {
            const uint8_t from[2] = {(uint8_t)(level << 3), 0};
            uint8_t to[2];
            pixels_pack(PANEL_RGB444, to, from, (uint16_t)(place % 4), (uint16_t)(place / 4), 1);
            sum += to[0] >> 4;
            if (level == 0) assert_int_equal(to[0] >> 4, 0);
            if (level == 31) assert_int_equal(to[0] >> 4, 15);
        }
        assert_true(fabs(sum / 16.0 - level * 15 / 31.0) <= 1 / 32.0 + 1e-9);
    }
}

/* BT.601's brightness in 16 levels; on a threshold, which rounding to 2^-16 moves, the neighbouring one. */
static void every_colour_has_its_grey(void **state)
{
    unsigned moved = 0;

    (void)state;
    for (uint32_t rgb565 = 0; rgb565 < 65536; rgb565++) {
        const uint8_t from[2] = {(uint8_t)(rgb565 >> 8), (uint8_t)rgb565};
        const double level = 0.299 * (rgb565 >> 11) / 31 + 0.587 * (rgb565 >> 5 & 63) / 63 + 0.114 * (rgb565 & 31) / 31;
        const unsigned x = rgb565 % 5, y = rgb565 % 7;
        uint8_t line[3] = {0xA5, 0xA5, 0xA5};
        line[x / 2] = x % 2 ? 0xA0 : 0x05;
        pixels_gather(PANEL_GREY4, line, from, (uint16_t)x, (uint16_t)y, 1);
        const unsigned grey = x % 2 ? line[x / 2] & 15 : line[x / 2] >> 4;
        const unsigned wanted = (unsigned)fmin(15, floor(15 * level + (2 * order_of(x, y) + 1) / 32.0 + 1e-9));
        if (grey > wanted + 1 || wanted > grey + 1) fail_msg("grey of %04x is %u, not %u", rgb565, grey, wanted);
        moved += grey != wanted;
        for (unsigned i = 0; i < 6; i++)
            if (i != x) assert_int_equal(line[i / 2] >> (i % 2 ? 0 : 4) & 15, i % 2 ? 0x5 : 0xA);
        if (rgb565 == 0 || rgb565 == 65535) assert_int_equal(grey, rgb565 ? 15 : 0);
    }
    assert_true(moved < 65536 / 200);
}

static void lines_are_packed_in_their_own_memory(void **state)
{
    enum { PX = 33, HEAD_B = (PX + 3) / 4 * 4 };
    (void)state;
    for (int f = PANEL_RGB565; f <= PANEL_RGB666_LOW; f++) {
        const enum panel_format format = (enum panel_format)f;
        uint8_t line[HEAD_B + 2 * PX], apart[3 * PX], from[2 * PX];
        const size_t head_b = format >= PANEL_RGB666 ? HEAD_B : 0;
        assert_true(head_b >= pixels_head_b(format, PX));
        for (unsigned i = 0; i < sizeof from; i++)
            from[i] = line[head_b + i] = (uint8_t)(i * 37 + 11);
        pixels_pack(format, apart, from, 3, 2, PX);
        pixels_pack(format, line, line + head_b, 3, 2, PX);
        assert_memory_equal(line, apart, pixels_b(format, PX));
    }
}

/* Panels ------------------------------------------------------------------------------------- */

static struct dcs_make module_of(const struct dcs_chip *chip, uint16_t w_px, uint16_t h_px)
{
    return (struct dcs_make){.chip = chip->name,
                             .w_px = w_px,
                             .h_px = h_px,
                             .ox_px = (uint16_t)((chip->mem_w_px - w_px) / 3),
                             .oy_px = (uint16_t)((chip->mem_h_px - h_px) / 3),
                             .ips = true};
}

static bool is_seen(unsigned x, unsigned y)
{
    uint16_t x0_px, x1_px;

    panel_visible(&rig.display.panel, (uint16_t)y, &x0_px, &x1_px);
    return x >= x0_px && x < x1_px;
}

static void start(const struct dcs_chip *chip, uint16_t w_px, uint16_t h_px)
{
    rig_setup(module_of(chip, w_px, h_px));
    rig_start(2);
}

static void formats_that_a_chip_does_not_take_are_refused(void **state)
{
    (void)state;
    for (size_t i = 0; panels_dcs[i]; i++)
        for (int f = 0; f <= PANEL_FORMATS; f++) {
            rig_setup(module_of(panels_dcs[i], ODD_W_PX, ODD_H_PX));
            rig.config.format = (enum panel_format)f;
            const bool takes = f == PANEL_USUAL || (f < PANEL_FORMATS && panels_dcs[i]->formats >> f & 1);
            assert_int_equal(dcs_setup(&rig.display, panels_dcs[i], &rig.config), takes ? 0 : PANEL_ERR_CONFIG);
        }
}

/* 78.5 % of the pixels, and a window for each line. Nothing that is seen is left out: the glass decides by real
 * numbers. */
static void round_glass_gets_what_it_shows_and_no_more(void **state)
{
    (void)state;
    for (uint16_t side = 239; side <= 240; side++) {
        start(&gc9a01, side, side);
        const uint64_t before_b = rig.chip.port.bus_b;
        unsigned seen = 0, most = 0;
        assert_int_equal(draw_frame(&rig.screen), 0);
        const double part = (double)(rig.chip.port.bus_b - before_b) / (2.0 * side * side);
        for (unsigned y = 0; y < side; y++)
            for (unsigned x = 0; x < side; x++) {
                const double dx = 2 * x + 1.0 - side, dy = 2 * y + 1.0 - side;
                const bool inside = dx * dx + dy * dy <= (double)side * side;
                assert_int_equal(is_seen(x, y), inside);
                seen += inside;
                most = x > most && inside ? x : most;
            }
        assert_int_equal(most, side - 1u);
        print_message("# panels: round glass of %u pixels gets %.1f %% of a frame's bytes\n", side, 100 * part);
        assert_true(part < 0.82 && part > (double)seen / (side * side));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_colour_is_packed_as_the_formula_says),
        cmocka_unit_test(dither_keeps_the_mean_and_black_and_white),
        cmocka_unit_test(every_colour_has_its_grey),
        cmocka_unit_test(lines_are_packed_in_their_own_memory),
        cmocka_unit_test(formats_that_a_chip_does_not_take_are_refused),
        cmocka_unit_test(round_glass_gets_what_it_shows_and_no_more),
    };
    return cmocka_run_group_tests_name("panels", tests, NULL, NULL);
}
