/* SPDX-License-Identifier: MIT
 *
 * Colours as bytes, red first, and as the numbers that panels and hashes take. */
#ifndef SIM_RGB565_H
#define SIM_RGB565_H

#include <stdint.h>

static inline uint16_t rgb565_from_rgb888(const uint8_t rgb[3])
{
    return (uint16_t)((rgb[0] >> 3) << 11 | (rgb[1] >> 2) << 5 | rgb[2] >> 3);
}

#endif
