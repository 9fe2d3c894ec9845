/* SPDX-License-Identifier: MIT
 *
 * A loop for each width, because shifts by constants are free or half as long. Where short code is asked for, one for
 * all. */
#include "pixels/texels.h"

#if LIM_HAS_TEXTURE

#if LIM_OPTIMISE_SIZE

void lim_texels_paint_any(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level)
{
    const LIM_FLASH uint8_t *const texels = level->texels;
    const LIM_FLASH uint16_t *const palette = level->palette;
    const uint32_t w_bits = level->w_bits, rows_mask = level->rows_mask >> w_bits, columns = 16 - w_bits;
    uint16_t *to = end - n;

    do {
        const uint32_t row = (uint32_t)(uint16_t)place >> columns & rows_mask;
        *to++ = palette[texels[(row << w_bits) + (place >> 16 >> columns)]];
        place += level->step;
    } while (to != end);
}

#else

#define SIZED(w_bits)                                                                                                  \
    static void paint_##w_bits(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level)  \
    {                                                                                                                  \
        lim_texels_paint_sized(end, n, place, level, w_bits);                                                          \
    }

SIZED(0)
SIZED(1)
SIZED(2)
SIZED(3)
SIZED(4)
SIZED(5)
SIZED(6)
SIZED(7)
SIZED(8)
SIZED(9)
SIZED(10)

lim_texels_painter *const LIM_FLASH lim_texels_painters[11] = {paint_0, paint_1, paint_2, paint_3, paint_4, paint_5,
                                                               paint_6, paint_7, paint_8, paint_9, paint_10};

#endif

#endif
