/* SPDX-License-Identifier: MIT
 *
 * By words of eight pixels, of which the first and the last are mixed with what they had. */
#include "greys.h"

typedef uint32_t __attribute__((may_alias)) word; /* the picture is an array of bytes */

/* A number whose highest byte comes first, as it lies in memory; and the other way round. */
static inline uint32_t in_memory(uint32_t number)
{
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    return __builtin_bswap32(number);
#else
    return number;
#endif
}

void greys_set(struct greys *greys, uint16_t colour)
{
    const uint8_t *const bytes = (const uint8_t *)&colour;
    uint8_t row[4][2];

    greys->colour = colour;
    pixels_greys(row, (uint16_t)(bytes[0] << 8 | bytes[1]));
    for (uint8_t y = 0; y < 4; y++)
        greys->rows[y] = in_memory((row[y][0] * UINT32_C(256) + row[y][1]) * UINT32_C(0x10001));
}

static inline void mix(word *to, uint32_t row, uint32_t mask)
{
    *to ^= (*to ^ row) & mask;
}

void greys_fill(const struct greys *greys, uint16_t y_px, uint16_t x0_px, uint16_t x1_px)
{
    const uint32_t row = greys->rows[y_px & 3];
    word *const line = (word *)(void *)(greys->picture + (size_t)y_px * greys->line_b);
    word *to = line + x0_px / 8, *const end = line + x1_px / 8;
    const uint32_t from_x0 = in_memory(UINT32_MAX >> 4 * (x0_px & 7)), from_x1 = UINT32_MAX >> 4 * (x1_px & 7);

    if (to == end) {
        mix(to, row, from_x0 & ~in_memory(from_x1));
        return;
    }
    mix(to, row, from_x0);
    while (++to < end)
        *to = row;
    if (x1_px & 7) mix(end, row, ~in_memory(from_x1));
}
