/* SPDX-License-Identifier: MIT */
#ifndef SIM_RGB888_H
#define SIM_RGB888_H

#include <stdint.h>

/* A colour 0xRRGGBB times another, to the nearest. */
static inline uint32_t rgb888_times(uint32_t a, uint32_t b)
{
    uint32_t out = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        out |= ((a >> shift & 0xFF) * (b >> shift & 0xFF) + 127) / 255 << shift;
    return out;
}

#endif
