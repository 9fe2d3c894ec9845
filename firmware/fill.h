/* SPDX-License-Identifier: MIT
 *
 * Pixels into memory: RGB565 as the bus wants it, the byte with the red bits first. */
#ifndef LIM_FILL_H
#define LIM_FILL_H

#include "target.h"

/* A colour as the target's memory holds it. */
static inline uint16_t lim_memory_colour(uint16_t rgb565)
{
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    return (uint16_t)(rgb565 << 8 | rgb565 >> 8);
#else
    return rgb565;
#endif
}

/* n pixels from x on; `line` is 4-byte aligned. */
void lim_fill(uint16_t *line, uint16_t x_px, uint16_t n_px, uint16_t colour);

/* The same of line y, or, if that is NULL, by the target. */
static inline void lim_fill_run(const struct lim_target *target, uint16_t *line, uint16_t y_px, uint16_t x_px,
                                uint16_t n_px, uint16_t colour)
{
#if LIM_HAS_RUNS
    if (!LIM_HAS_LINES || !line) {
        target->put_run(target->ctx, y_px, x_px, n_px, colour);
        return;
    }
#else
    (void)target, (void)y_px;
#endif
    lim_fill(line, x_px, n_px, colour);
}

#endif
