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
static void pack_rgb666(uint8_t *to, const uint8_t *from, uint16_t n_px)
{
    for (uint16_t i = 0; i < n_px; i++) {
        const unsigned rgb565 = rgb565_at(from, i);
        *to++ = (uint8_t)((rgb565 >> 8 & 0xF8u) | (rgb565 >> 13 & 0x04u));
        *to++ = (uint8_t)(rgb565 >> 3 & 0xFCu);
        *to++ = (uint8_t)((rgb565 << 3 & 0xF8u) | (rgb565 >> 2 & 0x04u));
    }
}

void pixels_pack(enum panel_format format, uint8_t *to, const uint8_t *from, uint16_t x_px, uint16_t y_px,
                 uint16_t n_px)
{
    if (format == PANEL_RGB444)
        pack_rgb444(to, from, x_px, y_px, n_px);
    else if (format == PANEL_RGB666)
        pack_rgb666(to, from, n_px);
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

/* 0.299, 0.587 and 0.114 of a level each, 2^16 in all for white. */
static uint32_t brightness_q16(uint16_t rgb565)
{
    return (rgb565 >> 11) * UINT32_C(632) + (rgb565 >> 5 & 63u) * UINT32_C(611) + (rgb565 & 31u) * UINT32_C(241);
}

void pixels_to_page(uint8_t *page, const uint8_t *from, uint16_t x_px, uint16_t y_px, uint16_t n_px)
{
    const uint8_t bit = (uint8_t)(1u << (y_px & 7u));

    for (uint16_t i = 0; i < n_px; i++) {
        const uint16_t x = (uint16_t)(x_px + i);
        const uint32_t add_q16 = (2 * order_of_64(x, y_px) + 1) << 9;
        const bool is_bright = (brightness_q16(rgb565_at(from, i)) + add_q16) >> 16;
        page[x] = (uint8_t)(is_bright ? page[x] | bit : page[x] & ~bit);
    }
}
