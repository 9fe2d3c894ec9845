/* SPDX-License-Identifier: MIT
 *
 * What is gathered goes by runs of one colour; here it is compared with a formula that takes each pixel by itself, in
 * lines of runs of all lengths, in two pieces. What is packed is compared with its pixels, packed one by one. What
 * single colours become is in test_panels.c. */
#include "pixels.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <string.h>

enum { LINE_PX = 96, LINES = 2000 };

/* Bayer's order of places in a square of 2^bits a side: that of its quarters, and within a quarter its own. */
static uint32_t order_of(uint32_t x, uint32_t y, int bits)
{
    static const uint32_t two[2][2] = {{0, 2}, {3, 1}};
    uint32_t order = 0;

    for (int i = 0; i < bits; i++)
        order = 4 * order + two[y >> i & 1][x >> i & 1];
    return order;
}

static uint32_t brightness_q16(uint32_t rgb565)
{
    return (rgb565 >> 11) * 632 + (rgb565 >> 5 & 63) * 611 + (rgb565 & 31) * 241;
}

static void put_pixel(enum panel_format format, uint8_t *to, uint32_t rgb565, uint32_t x, uint32_t y)
{
    const uint32_t light_q16 = brightness_q16(rgb565);
    uint32_t at = x, mask = 1u << y % 8, bits = light_q16 + (2 * order_of(x, y, 3) + 1) * 512 >= 65536 ? mask : 0;

    if (format == PANEL_MONO_LINES) {
        bits = bits ? 0x80u >> x % 8 : 0;
        mask = 0x80u >> x % 8;
        at = x / 8;
    } else if (format == PANEL_GREY4) {
        bits = (15 * light_q16 + (2 * order_of(x, y, 2) + 1) * 2048) / 65536 << (x % 2 ? 0 : 4);
        mask = x % 2 ? 0x0F : 0xF0;
        at = x / 2;
    }
    to[at] = (uint8_t)((to[at] & ~mask) | bits);
}

/* Runs of 1 to 32 pixels, black and white among their colours. */
static void fill_line(uint8_t *line, struct random *random)
{
    for (uint32_t i = 0, left = 0, rgb565 = 0; i < LINE_PX; i++, left--) {
        if (!left) {
            const uint32_t kind = (uint32_t)random_in(random, 0, 7);
            rgb565 = kind == 0 ? 0 : kind == 1 ? 65535 : (uint32_t)random_in(random, 0, 65535);
            left = (uint32_t)random_in(random, 0, 1) ? 1 : (uint32_t)random_in(random, 1, 32);
        }
        line[2 * i] = (uint8_t)(rgb565 >> 8);
        line[2 * i + 1] = (uint8_t)rgb565;
    }
}

static void lines_agree(enum panel_format format)
{
    struct random random = {(uint64_t)format + 1};

    for (int i = 0; i < LINES; i++) {
        const uint32_t y = (uint32_t)random_in(&random, 0, 63), x = (uint32_t)random_in(&random, 0, 39);
        const uint32_t n = (uint32_t)random_in(&random, 0, LINE_PX - x), first = (uint32_t)random_in(&random, 0, n);
        uint8_t line[2 * LINE_PX], wanted[LINE_PX] = {0}, to[LINE_PX] = {0};
        fill_line(line, &random);
        for (uint32_t at = 0; at < n; at++)
            put_pixel(format, wanted, (uint32_t)line[2 * at] << 8 | line[2 * at + 1], x + at, y);
        pixels_gather(format, to, line, (uint16_t)x, (uint16_t)y, (uint16_t)first);
        pixels_gather(format, to, line + 2 * first, (uint16_t)(x + first), (uint16_t)y, (uint16_t)(n - first));
        assert_memory_equal(to, wanted, sizeof to);
    }
}

static void pages_are_gathered_as_pixel_by_pixel(void **state)
{
    (void)state;
    lines_agree(PANEL_MONO_PAGES);
}

static void lines_of_bits_are_gathered_as_pixel_by_pixel(void **state)
{
    (void)state;
    lines_agree(PANEL_MONO_LINES);
}

static void greys_are_gathered_as_pixel_by_pixel(void **state)
{
    (void)state;
    lines_agree(PANEL_GREY4);
}

/* A line of one colour but for a byte of one pixel: runs are found four pixels at a time, and end at any of them. */
static void a_single_byte_ends_a_run(void **state)
{
    static const uint16_t colours[] = {0xFFFF, 0x0000, 0xFF00, 0x00FF, 0x7F7F, 0xF81F};
    enum { RUN_PX = 15 };

    (void)state;
    for (size_t i = 0; i < sizeof colours / sizeof *colours; i++)
        for (uint32_t at_b = 0; at_b < 2 * RUN_PX; at_b++)
            for (uint32_t y = 0; y < 8; y++) {
                uint8_t line[2 * RUN_PX], wanted[RUN_PX] = {0}, to[RUN_PX] = {0};
                for (uint32_t k = 0; k < 2 * RUN_PX; k++)
                    line[k] = (uint8_t)(k % 2 ? colours[i] : colours[i] >> 8);
                line[at_b] ^= 0xFF;
                for (uint32_t x = 0; x < RUN_PX; x++)
                    put_pixel(PANEL_GREY4, wanted, (uint32_t)line[2 * x] << 8 | line[2 * x + 1], x, y);
                pixels_gather(PANEL_GREY4, to, line, 0, (uint16_t)y, RUN_PX);
                assert_memory_equal(to, wanted, sizeof to);
            }
}

static void put_eight(enum panel_format format, uint32_t rgb565, uint32_t y)
{
    uint8_t line[16], wanted[4] = {0}, to[4] = {0};

    for (uint32_t x = 0; x < 8; x++) {
        line[2 * x] = (uint8_t)(rgb565 >> 8);
        line[2 * x + 1] = (uint8_t)rgb565;
        put_pixel(format, wanted, rgb565, x, y);
    }
    pixels_gather(format, to, line, 0, (uint16_t)y, 8);
    if (memcmp(to, wanted, sizeof to)) fail_msg("format %d: %04x on line %u", format, rgb565, y);
}

static void every_colour_is_gathered_as_the_formula_says(void **state)
{
    (void)state;
    for (uint32_t rgb565 = 0; rgb565 < 65536; rgb565++) {
        for (uint32_t y = 0; y < 8; y++) {
            put_eight(PANEL_MONO_LINES, rgb565, y);
            put_eight(PANEL_GREY4, rgb565, y);
        }
    }
}

/* Half bytes at `to`, the upper ones first. */
static void put_half(uint8_t *to, size_t at, unsigned half)
{
    to[at / 2] = (uint8_t)(at % 2 ? to[at / 2] | half : half << 4);
}

/* What a line becomes by its pixels, each of which is packed alone, at its place. Returns the half bytes. */
static size_t pack_one_by_one(enum panel_format format, uint8_t *to, const uint8_t *from, uint16_t x_px, uint16_t n_px)
{
    const size_t halves = format == PANEL_RGB444 ? 3 : 2 * pixels_b(format, 1);
    size_t at = 0;

    for (uint16_t i = 0; i < n_px; i++) {
        uint8_t one[4];
        pixels_pack(format, one, from + 2 * i, (uint16_t)(x_px + i), 5, 1);
        for (size_t k = 0; k < halves; k++)
            put_half(to, at++, k % 2 ? one[k / 2] & 15u : one[k / 2] >> 4);
    }
    return at;
}

/* In memory of its own or as far before the pixels as it has to begin, and nothing behind it. */
static void pixels_are_packed_as_one_by_one(void **state)
{
    static const enum panel_format formats[] = {PANEL_RGB565, PANEL_RGB444, PANEL_RGB666, PANEL_RGB666_LOW};
    enum { MOST_PX = 9, UNTOUCHED = 0x5A };
    struct random random = {7};

    (void)state;
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        for (uint16_t n_px = 0; n_px <= MOST_PX; n_px++)
            for (uint16_t x_px = 0; x_px < 4; x_px++) {
                uint8_t line[2 * MOST_PX], wanted[3 * MOST_PX + 2] = {0}, to[3 * MOST_PX + 2], place[3 * MOST_PX + 2];
                for (size_t k = 0; k < sizeof line; k++)
                    line[k] = (uint8_t)random_in(&random, 0, 255);
                const size_t used_b = (pack_one_by_one(formats[i], wanted, line, x_px, n_px) + 1) / 2;
                const size_t head_b = pixels_head_b(formats[i], n_px);
                memset(wanted + used_b, UNTOUCHED, sizeof wanted - used_b);
                memset(to, UNTOUCHED, sizeof to);
                pixels_pack(formats[i], to, line, x_px, 5, n_px);
                assert_memory_equal(to, wanted, sizeof to);
                assert_int_equal(pixels_b(formats[i], n_px), used_b);
                memset(place, UNTOUCHED, sizeof place);
                memcpy(place + head_b, line, 2u * n_px);
                pixels_pack(formats[i], place, place + head_b, x_px, 5, n_px);
                assert_memory_equal(place, wanted, used_b);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pages_are_gathered_as_pixel_by_pixel),
        cmocka_unit_test(lines_of_bits_are_gathered_as_pixel_by_pixel),
        cmocka_unit_test(greys_are_gathered_as_pixel_by_pixel),
        cmocka_unit_test(a_single_byte_ends_a_run),
        cmocka_unit_test(pixels_are_packed_as_one_by_one),
        cmocka_unit_test(every_colour_is_gathered_as_the_formula_says),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
