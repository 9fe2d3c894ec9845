/* SPDX-License-Identifier: MIT
 *
 * Red and blue share a word, 16 bits apart: two multiplications a pixel, no division. What the colour adds is the
 * same for all pixels, the half that rounds included. */
#include "pixels/blend.h"

#include "colour.h"

#if LIM_HAS_TRANSPARENT

static const uint32_t RED_BLUE = 0x001F001F, RED_BLUE_HALVES = 0x00800080, GREEN = 0x07E0, GREEN_HALF = 0x1000;

/* Blue in bits 0..4, red in bits 16..20. */
static inline uint32_t red_blue_of(uint16_t rgb565)
{
    return (uint32_t)(rgb565 & 0xF800) << 5 | (rgb565 & 0x1F);
}

void lim_blend(uint16_t *line, uint16_t x_px, uint16_t n_px, uint16_t colour, uint8_t alpha)
{
    const uint32_t weight = (uint32_t)alpha + (alpha >> 7), rest = 256 - weight;
    const uint16_t rgb565 = lim_memory_colour(colour);
    const uint32_t red_blue = red_blue_of(rgb565) * weight + RED_BLUE_HALVES;
    const uint32_t green = (rgb565 & GREEN) * weight + GREEN_HALF;

    for (uint16_t *p = line + x_px, *const end = p + n_px; p < end; p++) {
        const uint16_t behind = lim_memory_colour(*p);
        const uint32_t mixed = (red_blue_of(behind) * rest + red_blue) >> 8 & RED_BLUE;
        const uint32_t mixed_green = ((behind & GREEN) * rest + green) >> 8 & GREEN;
        *p = lim_memory_colour((uint16_t)(mixed >> 5 | mixed_green | mixed));
    }
}

#endif
