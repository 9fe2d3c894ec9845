/* SPDX-License-Identifier: MIT
 *
 * Colours as bytes, red first, and as the numbers that panels and hashes take. */
#ifndef SIM_RGB565_H
#define SIM_RGB565_H

#include <stdint.h>

/* Each part rounded down, as panels do. */
static inline uint16_t rgb565_from_rgb888(const uint8_t rgb[3])
{
    return (uint16_t)((rgb[0] >> 3) << 11 | (rgb[1] >> 2) << 5 | rgb[2] >> 3);
}

/* 0xRRGGBB, each part to nearest. */
static inline uint16_t rgb565_nearest(uint32_t colour)
{
    const uint32_t red = colour >> 16 & 0xFF, green = colour >> 8 & 0xFF, blue = colour & 0xFF;

    return (uint16_t)((red * 31 + 127) / 255 << 11 | (green * 63 + 127) / 255 << 5 | (blue * 31 + 127) / 255);
}

#endif
