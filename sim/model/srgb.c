/* SPDX-License-Identifier: MIT */
#include "model/srgb.h"

#include <math.h>

double srgb_from_linear(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055;
}

double srgb_to_linear(double channel)
{
    return channel <= 0.04045 ? channel / 12.92 : pow((channel + 0.055) / 1.055, 2.4);
}

uint32_t srgb_byte(double channel)
{
    return channel > 0 ? (uint32_t)(255 * fmin(channel, 1) + 0.5) : 0;
}

uint32_t srgb_tinted(uint32_t texel, uint32_t colour)
{
    uint32_t out = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        out |= ((texel >> shift & 0xFF) * (colour >> shift & 0xFF) + 127) / 255 << shift;
    return out;
}

uint32_t srgb_sum(uint32_t a, uint32_t b)
{
    uint32_t out = 0;
    if (!a || !b) return a | b;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const double light = srgb_to_linear((a >> shift & 0xFF) / 255.0) + srgb_to_linear((b >> shift & 0xFF) / 255.0);
        out = out << 8 | srgb_byte(srgb_from_linear(light));
    }
    return out;
}
