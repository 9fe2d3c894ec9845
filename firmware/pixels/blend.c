/* SPDX-License-Identifier: MIT
 *
 * Red and blue share a word, 16 bits apart: two multiplications a pixel, no division. What the colour adds is the
 * same for all pixels, the half that rounds included; and a run of pixels that are equal is mixed once. */
#include "pixels/blend.h"

#include "colour.h"
#include "pixels/fill.h"

#if LIM_HAS_TRANSPARENT

static const uint32_t RED_BLUE = 0x001F001F, RED_BLUE_HALVES = 0x00800080, GREEN = 0x07E0, GREEN_HALF = 0x1000;

/* Blue in bits 0..4, red in bits 16..20. */
static inline uint32_t red_blue_of(uint16_t rgb565)
{
    return (uint32_t)(rgb565 & 0xF800) << 5 | (rgb565 & 0x1F);
}

/* What a colour of some alpha makes of a pixel. */
struct mix {
    uint32_t red_blue, green, rest;
};

static inline struct mix mix_of(uint16_t rgb565, uint8_t alpha)
{
    const uint32_t weight = (uint32_t)alpha + (alpha >> 7);

    return (struct mix){red_blue_of(rgb565) * weight + RED_BLUE_HALVES, (rgb565 & GREEN) * weight + GREEN_HALF,
                        256 - weight};
}

static inline uint16_t mix_over(const struct mix *mix, uint16_t colour)
{
    const uint16_t behind = lim_memory_colour(colour);
    const uint32_t mixed = (red_blue_of(behind) * mix->rest + mix->red_blue) >> 8 & RED_BLUE;
    const uint32_t mixed_green = ((behind & GREEN) * mix->rest + mix->green) >> 8 & GREEN;

    return lim_memory_colour((uint16_t)(mixed >> 5 | mixed_green | mixed));
}

/* Pixels that are equal, from the first one on, until one is not or a word begins; then two at a time. Returns the one
 * behind them. */
static inline uint16_t *blend_run(uint16_t *p, const uint16_t *end, uint16_t behind, uint16_t mixed)
{
    do
        *p++ = mixed;
    while (p < end && *p == behind && (LIM_8_BIT || (uintptr_t)p & 3));
    if (LIM_8_BIT || p >= end || *p != behind) return p;
    const uint32_t equal = (uint32_t)behind << 16 | behind, both = (uint32_t)mixed << 16 | mixed;
    lim_pixel_pair *pair = __builtin_assume_aligned(p, 4);
    for (const uint16_t *last = end - 1; (uint16_t *)pair < last && *pair == equal; pair++)
        *pair = both;
    return (uint16_t *)pair;
}

/* What lies behind glass are runs of one colour, mostly. */
void lim_blend(uint16_t *line, uint16_t x_px, uint16_t n_px, uint16_t colour, uint8_t alpha)
{
    const struct mix mix = mix_of(lim_memory_colour(colour), alpha);
    uint16_t *p = line + x_px, *const end = p + n_px;

    while (p < end)
        p = blend_run(p, end, *p, mix_over(&mix, *p));
}

#endif
