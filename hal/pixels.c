/* SPDX-License-Identifier: MIT
 *
 * Ordered dither: of two levels a colour lies between, the brighter one is taken at as many places of a square as it is
 * parts of the way there; neighbours are far apart in the order (Bayer, 1973). Squares are of 8x8 places for black and
 * white, else of 4x4.
 *
 * What is gathered goes by runs of one colour: in a line, a colour's levels repeat with the square. */
#include "pixels.h"

/* 65536 * 15 / 31 and 15 / 63, rounded up: the greatest value still gives 15, whatever is added. */
#define FIVE_TO_FOUR_Q16 UINT32_C(31711)
#define SIX_TO_FOUR_Q16 UINT32_C(15604)

/* Order of 8x8 places: of each bit of x and y two of the place's, x ^ y and y, the finest first; so a column and a row
 * are parts of it that x and y alone say. Of 4x4 places it is the same without the last two bits. */
enum { COLUMN_1 = 32, COLUMN_2 = 8, COLUMN_4 = 2 };

static uint8_t row_of_64(uint16_t y_px)
{
    static const HAL_FLASH uint8_t rows[8] = {0, 48, 12, 60, 3, 51, 15, 63};

    return rows[y_px & 7];
}

/* (2 * place + 1) / 32 of a level, Q16. */
static uint32_t threshold_q16(uint16_t x_px, uint16_t y_px)
{
    static const HAL_FLASH uint8_t columns[4] = {0, COLUMN_1, COLUMN_2, COLUMN_1 | COLUMN_2};

    return ((uint32_t)((uint8_t)(columns[x_px & 3] ^ row_of_64(y_px)) >> 2) * 2 + 1) << 11;
}

static uint16_t dithered_rgb444(uint16_t rgb565, uint32_t add_q16)
{
    const uint32_t red = ((rgb565 >> 11) * FIVE_TO_FOUR_Q16 + add_q16) >> 16;
    const uint32_t green = ((rgb565 >> 5 & 63u) * SIX_TO_FOUR_Q16 + add_q16) >> 16;
    const uint32_t blue = ((rgb565 & 31u) * FIVE_TO_FOUR_Q16 + add_q16) >> 16;

    return (uint16_t)(red << 8 | green << 4 | blue);
}

static uint16_t rgb565_at(const uint8_t *from, uint16_t i)
{
    return (uint16_t)((unsigned)from[2u * i] << 8 | from[2u * i + 1u]);
}

static void pack_rgb444(uint8_t *to, const uint8_t *from, uint16_t x_px, uint16_t y_px, uint16_t n_px)
{
    for (uint16_t i = 0; i < n_px; i = (uint16_t)(i + 2u)) {
        const uint16_t first = dithered_rgb444(rgb565_at(from, i), threshold_q16((uint16_t)(x_px + i), y_px));
        const bool is_odd = n_px - i == 1;
        const uint16_t second = is_odd ? 0
                                       : dithered_rgb444(rgb565_at(from, (uint16_t)(i + 1u)),
                                                         threshold_q16((uint16_t)(x_px + i + 1u), y_px));
        *to++ = (uint8_t)(first >> 4);
        *to++ = (uint8_t)(first << 4 | second >> 8);
        if (!is_odd) *to++ = (uint8_t)second;
    }
}

/* Five bits are widened by their highest one, so that white stays white. */
static void pack_rgb666(uint8_t *to, const uint8_t *from, uint16_t n_px, uint8_t down)
{
    for (uint16_t i = 0; i < n_px; i++) {
        const unsigned rgb565 = rgb565_at(from, i);
        *to++ = (uint8_t)(((rgb565 >> 8 & 0xF8u) | (rgb565 >> 13 & 0x04u)) >> down);
        *to++ = (uint8_t)((rgb565 >> 3 & 0xFCu) >> down);
        *to++ = (uint8_t)(((rgb565 << 3 & 0xF8u) | (rgb565 >> 2 & 0x04u)) >> down);
    }
}

void pixels_pack(enum panel_format format, uint8_t *to, const uint8_t *from, uint16_t x_px, uint16_t y_px,
                 uint16_t n_px)
{
    if (format == PANEL_RGB444)
        pack_rgb444(to, from, x_px, y_px, n_px);
    else if (format == PANEL_RGB666 || format == PANEL_RGB666_LOW)
        pack_rgb666(to, from, n_px, format == PANEL_RGB666_LOW ? 2 : 0);
    else if (to != from)
        for (size_t i = 0; i < pixels_b(format, n_px); i++)
            to[i] = from[i];
}

static uint16_t product(uint8_t a, uint8_t b)
{
    return (uint16_t)((unsigned)a * b);
}

/* 2^16 times 0.299 / 31, 0.587 / 63 and 0.114 / 31, rounded: 632, 611 and 241. White's sum is 2^16 + 20: held at 2^16 -
 * 1 it is as white. */
static uint16_t brightness_q16(uint16_t rgb565)
{
    const uint8_t red = (uint8_t)(rgb565 >> 11), green = rgb565 >> 5 & 63, blue = rgb565 & 31;
    const uint16_t both = (uint16_t)(product(red, 79) * 8u + product(green, 99) + green * 512u);
    const uint16_t all = (uint16_t)(both + product(blue, 241));

    return all < both ? UINT16_MAX : all;
}

/* Four pixels of a line, a bit each, the highest on the left: 1 for white. Of 64 places the last ones in the order are
 * white. */
static uint8_t mono_of_4(uint8_t order, uint8_t white)
{
    uint8_t bits = 0;

    if ((uint8_t)(order + white) & 64) bits |= 8;
    if ((uint8_t)((order ^ COLUMN_1) + white) & 64) bits |= 4;
    if ((uint8_t)((order ^ COLUMN_2) + white) & 64) bits |= 2;
    if ((uint8_t)((order ^ (COLUMN_1 | COLUMN_2)) + white) & 64) bits |= 1;
    return bits;
}

/* Eight from a multiple of 8 on. As many of 64 are white as the brightness has 64ths, rounded. */
static uint8_t mono_of_8(uint16_t brightness_q16, uint16_t y_px)
{
    const uint8_t white = (uint8_t)(((brightness_q16 >> 1) + 256u) >> 9), row = row_of_64(y_px);

    return (uint8_t)(mono_of_4(row, white) << 4 | mono_of_4(row ^ COLUMN_4, white));
}

/* Two pixels of a line from an even one on. */
static uint8_t greys_of_2(uint16_t brightness_q16, uint16_t x_px, uint16_t y_px)
{
    const uint32_t level_q16 = UINT32_C(15) * brightness_q16;
    const uint32_t left = (level_q16 + threshold_q16(x_px, y_px)) >> 16;
    const uint32_t right = (level_q16 + threshold_q16((uint16_t)(x_px + 1u), y_px)) >> 16;

    return (uint8_t)(left << 4 | right);
}

void pixels_greys(uint8_t bytes[4][2], uint16_t rgb565)
{
    const uint16_t light_q16 = brightness_q16(rgb565);

    for (uint8_t y = 0; y < 4; y++) {
        bytes[y][0] = greys_of_2(light_q16, 0, y);
        bytes[y][1] = greys_of_2(light_q16, 2, y);
    }
}

static uint8_t with(uint8_t byte, uint8_t mask, uint8_t bits)
{
    return (uint8_t)((byte & ~(unsigned)mask) | (bits & mask));
}

/* Pixels x0_px <= x < x1_px of a line, of so many bits each: even bytes have pattern[0], odd ones pattern[1]. */
static void put_in_line(uint8_t *to, const uint8_t pattern[2], uint8_t pixel_bits, uint16_t x0_px, uint16_t x1_px)
{
    const uint16_t first = (uint16_t)(x0_px * pixel_bits), end = (uint16_t)(x1_px * pixel_bits);
    const uint16_t last_at = end / 8;
    uint8_t mask = (uint8_t)(0xFFu >> (first & 7u));
    uint16_t at = first / 8;

    for (; at < last_at; at++, mask = 0xFF)
        to[at] = with(to[at], mask, pattern[at & 1]);
    mask &= (uint8_t) ~(0xFFu >> (end & 7u));
    if (mask) to[at] = with(to[at], mask, pattern[at & 1]);
}

/* Bits of a byte, the lowest first. */
static uint8_t bit_of(uint8_t i)
{
    static const HAL_FLASH uint8_t bits[8] = {1, 2, 4, 8, 16, 32, 64, 128};

    return bits[i];
}

/* The same of a page's, a byte each: one bit of it. */
static HAL_ALONE void put_in_page(uint8_t *to, uint8_t pattern, uint8_t bit, uint8_t column, uint16_t n_px)
{
    const uint8_t others = (uint8_t)~bit;

    for (; n_px; n_px--) {
        uint8_t byte = *to & others;
        if (pattern & column) byte |= bit;
        *to++ = byte;
        column = (uint8_t)(column >> 1 | column << 7);
    }
}

static HAL_ALONE void fill_lines(enum panel_format format, uint8_t *to, uint16_t rgb565, uint16_t x_px, uint16_t y_px,
                                 uint16_t n_px)
{
    const uint16_t light_q16 = brightness_q16(rgb565), x1_px = (uint16_t)(x_px + n_px);

    if (format == PANEL_GREY4) {
        const uint8_t greys[2] = {greys_of_2(light_q16, 0, y_px), greys_of_2(light_q16, 2, y_px)};
        put_in_line(to, greys, 4, x_px, x1_px);
    } else {
        const uint8_t mono = mono_of_8(light_q16, y_px);
        put_in_line(to, (const uint8_t[]){mono, mono}, 1, x_px, x1_px);
    }
}

void pixels_fill(enum panel_format format, uint8_t *to, uint16_t rgb565, uint16_t x_px, uint16_t y_px, uint16_t n_px)
{
    if (PIXELS_ONLY_PAGES || format == PANEL_MONO_PAGES)
        put_in_page(to + x_px, mono_of_8(brightness_q16(rgb565), y_px), bit_of(y_px & 7), bit_of(~x_px & 7), n_px);
    else
        fill_lines(format, to, rgb565, x_px, y_px, n_px);
}

/* Behind the pixels that have the colour of the first one. Four at a time as long as there are as many. */
static HAL_ALONE const uint8_t *run_end(const uint8_t *from, const uint8_t *end)
{
    const uint8_t high = from[0], low = from[1];

    for (; end - from >= 8; from += 8)
        if (from[0] != high || from[1] != low || from[2] != high || from[3] != low || from[4] != high ||
            from[5] != low || from[6] != high || from[7] != low)
            break;
    while (from < end && from[0] == high && from[1] == low)
        from += 2;
    return from;
}

void pixels_gather(enum panel_format format, uint8_t *to, const uint8_t *from, uint16_t x_px, uint16_t y_px,
                   uint16_t n_px)
{
    const uint8_t *const end = from + 2u * n_px;

    while (from < end) {
        const uint8_t *const next = run_end(from, end);
        const uint16_t run_px = (uint16_t)((next - from) / 2), rgb565 = rgb565_at(from, 0);
        if (rgb565) pixels_fill(format, to, rgb565, x_px, y_px, run_px);
        x_px = (uint16_t)(x_px + run_px);
        from = next;
    }
}
