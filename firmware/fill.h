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

/* n pixels from x on, or none; `line`, the target's, is 4-byte aligned. */
void lim_fill(uint16_t *line, uint16_t x_px, uint16_t n_px, uint16_t colour);

typedef uint32_t __attribute__((may_alias)) lim_pixel_pair; /* lines are arrays of uint16_t */

/* Writes `count` times 16 pairs, once at least. Returns the place behind them. */
lim_pixel_pair *lim_fill_sixteens(lim_pixel_pair *to, uint32_t count, uint32_t pair);

/* lim_fill() of one pixel at least, where calls are many: what is less than 16 pairs by one jump, past the stores that
 * are too many. */
static inline void lim_fill_inline(uint16_t *line, uint32_t x_px, uint32_t n_px, uint16_t colour)
{
    uint16_t *const begin = line + x_px, *const end = begin + n_px;
    const uint32_t pair = (uint32_t)colour << 16 | colour;
    lim_pixel_pair *q = (lim_pixel_pair *)(((uintptr_t)begin + 2) & ~(uintptr_t)3);
    uint32_t more = (uint32_t)(((((uintptr_t)end & ~(uintptr_t)3) - (uintptr_t)q) >> 2) - 1); /* than one pair */

    begin[0] = end[-1] = colour; /* the halves of words at the ends, if there are such */
    if (n_px < 3) return;
    if (more > 15) {
        q = lim_fill_sixteens(q, more >> 4, pair);
        more &= 15;
    }
    // clang-format off
    switch (more) {
    case 15: q[15] = pair; /* fall through */
    case 14: q[14] = pair; /* fall through */
    case 13: q[13] = pair; /* fall through */
    case 12: q[12] = pair; /* fall through */
    case 11: q[11] = pair; /* fall through */
    case 10: q[10] = pair; /* fall through */
    case 9: q[9] = pair; /* fall through */
    case 8: q[8] = pair; /* fall through */
    case 7: q[7] = pair; /* fall through */
    case 6: q[6] = pair; /* fall through */
    case 5: q[5] = pair; /* fall through */
    case 4: q[4] = pair; /* fall through */
    case 3: q[3] = pair; /* fall through */
    case 2: q[2] = pair; /* fall through */
    case 1: q[1] = pair; /* fall through */
    case 0: q[0] = pair; return;
    default: __builtin_unreachable();
    }
    // clang-format on
}

/* lim_fill() of line y, or, if that is NULL, by the target. */
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
