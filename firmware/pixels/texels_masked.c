/* SPDX-License-Identifier: MIT
 *
 * Texels of a masked texture: of index 0 nothing is painted. One loop serves all widths, as few pixels are such. */
#include "pixels/texels.h"

#if LIM_HAS_MASKED

void lim_texels_paint_masked(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level)
{
    const LIM_FLASH uint8_t *const texels = level->texels;
    const LIM_FLASH uint16_t *const palette = level->palette;
    const uint32_t w_bits = level->w_bits, rows_mask = level->rows_mask >> w_bits, columns = 16 - w_bits;
    const uint32_t step = level->step;
    uint16_t *to = end - n;

    do {
        const uint32_t row = (uint32_t)(uint16_t)place >> columns & rows_mask;
        const uint_fast8_t texel = texels[(row << w_bits) + (place >> 16 >> columns)];
        if (texel) *to = palette[texel];
        to++;
        place += step;
    } while (to != end);
}

#endif
