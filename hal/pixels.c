/* SPDX-License-Identifier: MIT
 *
 * Ordered dither: of two levels a colour lies between, the brighter one is taken at as many of 16 places as it is
 * sixteenths of the way there; neighbours are far apart in the order (Bayer, 1973). */
#include "pixels.h"

/* 65536 * 15 / 31 and 15 / 63, rounded up: the greatest value still gives 15, whatever is added. */
#define FIVE_TO_FOUR_Q16 UINT32_C(31711)
#define SIX_TO_FOUR_Q16 UINT32_C(15604)

/* (2 * place + 1) / 32 of a level, Q16. */
static uint32_t threshold_q16(uint16_t x_px, uint16_t y_px)
{
    static const uint8_t order[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

    return (2 * (uint32_t)order[y_px & 3][x_px & 3] + 1) << 11;
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

/* Order of 8x8 places: of each bit of x and y two of the place's, the finest first. */
static uint32_t order_of_64(uint32_t x, uint32_t y)
{
    uint32_t order = 0;

    for (uint8_t i = 0; i < 3; i++, x >>= 1, y >>= 1)
        order = order << 2 | ((x ^ y) & 1u) << 1 | (y & 1u);
    return order;
}

/* 2^16 times 0.299 / 31, 0.587 / 63 and 0.114 / 31, rounded: 2^16 + 20 for white, which is still below the next level,
 * and 0 for black. */
static uint32_t brightness_q16(uint16_t rgb565)
{
    return (rgb565 >> 11) * UINT32_C(632) + (rgb565 >> 5 & 63u) * UINT32_C(611) + (rgb565 & 31u) * UINT32_C(241);
}

static bool is_bright(uint16_t rgb565, uint16_t x_px, uint16_t y_px)
{
    const uint32_t add_q16 = (2 * order_of_64(x_px, y_px) + 1) << 9;

    return (brightness_q16(rgb565) + add_q16) >> 16;
}

static uint8_t grey4(uint16_t rgb565, uint16_t x_px, uint16_t y_px)
{
    return (uint8_t)((15 * brightness_q16(rgb565) + threshold_q16(x_px, y_px)) >> 16);
}

static uint8_t with(uint8_t byte, uint8_t mask, uint8_t bits)
{
    return (uint8_t)((byte & ~(unsigned)mask) | bits);
}

void pixels_gather(enum panel_format format, uint8_t *to, const uint8_t *from, uint16_t x_px, uint16_t y_px,
                   uint16_t n_px)
{
    for (uint16_t i = 0; i < n_px; i++) {
        const uint16_t x = (uint16_t)(x_px + i), rgb565 = rgb565_at(from, i);
        if (format == PANEL_GREY4) {
            const uint8_t up = x & 1u ? 0 : 4;
            to[x / 2] = with(to[x / 2], (uint8_t)(0x0Fu << up), (uint8_t)(grey4(rgb565, x, y_px) << up));
        } else {
            const bool is_line = format == PANEL_MONO_LINES;
            const uint8_t bit = (uint8_t)(is_line ? 0x80u >> (x & 7u) : 1u << (y_px & 7u));
            uint8_t *byte = &to[is_line ? x / 8 : x];
            *byte = with(*byte, bit, is_bright(rgb565, x, y_px) ? bit : 0);
        }
    }
}
