/* SPDX-License-Identifier: MIT
 *
 * Pixels into memory. */
#ifndef LIM_FILL_H
#define LIM_FILL_H

#include "pixels/falls.h"
#include "pixels/target_parts.h"

/* n pixels from x on, or none; `line`, the target's, is 4-byte aligned. */
void lim_fill(uint16_t *line, uint16_t x_px, uint16_t n_px, uint16_t colour);

typedef uint32_t __attribute__((may_alias)) lim_pixel_pair; /* lines are arrays of uint16_t */

/* Writes that many pairs, 16 at least. */
void lim_fill_many(lim_pixel_pair *to, uint_fast16_t pairs, uint32_t pair);

/* Writes so many by one jump, past the stores that are too many; more than 16 by a call. */
static LIM_HOT_INLINE void lim_fill_pairs(lim_pixel_pair *to, uint_fast16_t pairs, uint32_t pair)
{
    // clang-format off
    switch (pairs) {
    case 16: to[15] = pair; LIM_FALL_THROUGH;
    case 15: to[14] = pair; LIM_FALL_THROUGH;
    case 14: to[13] = pair; LIM_FALL_THROUGH;
    case 13: to[12] = pair; LIM_FALL_THROUGH;
    case 12: to[11] = pair; LIM_FALL_THROUGH;
    case 11: to[10] = pair; LIM_FALL_THROUGH;
    case 10: to[9] = pair; LIM_FALL_THROUGH;
    case 9: to[8] = pair; LIM_FALL_THROUGH;
    case 8: to[7] = pair; LIM_FALL_THROUGH;
    case 7: to[6] = pair; LIM_FALL_THROUGH;
    case 6: to[5] = pair; LIM_FALL_THROUGH;
    case 5: to[4] = pair; LIM_FALL_THROUGH;
    case 4: to[3] = pair; LIM_FALL_THROUGH;
    case 3: to[2] = pair; LIM_FALL_THROUGH;
    case 2: to[1] = pair; LIM_FALL_THROUGH;
    case 1: to[0] = pair; LIM_FALL_THROUGH;
    case 0: return;
    default: lim_fill_many(to, pairs, pair);
    }
    // clang-format on
}

/* lim_fill() of pixels x0 <= x < x1, one at least, where calls are many. */
static LIM_HOT_INLINE void lim_fill_inline(uint16_t *line, int_fast16_t x0_px, int_fast16_t x1_px, uint16_t colour)
{
    const int_fast16_t from = (x0_px + 1) >> 1, to = x1_px >> 1, last_px = x1_px - 1;

    line[x0_px] = line[last_px] = colour; /* the halves of words at the ends, if there are such */
    if (last_px - x0_px < 2) return;
    lim_fill_pairs((lim_pixel_pair *)__builtin_assume_aligned(line, 4) + from, (uint_fast16_t)(to - from),
                   (uint32_t)colour << 16 | colour);
}

/* lim_fill() from pixel 0 on: a whole line, mostly. */
static inline void lim_fill_line(uint16_t *line, uint16_t n_px, uint16_t colour)
{
    if (n_px >= 32 && n_px % 2 == 0)
        lim_fill_many(__builtin_assume_aligned(line, 4), n_px / 2, (uint32_t)colour << 16 | colour);
    else
        lim_fill(line, 0, n_px, colour);
}

/* lim_fill() of line y, or, if that is NULL, by the target. */
static inline void lim_fill_run(const struct lim_target *target, uint16_t *line, uint16_t y_px, uint16_t x_px,
                                uint16_t n_px, uint16_t colour)
{
    if (LIM_HAS_FILL && (!LIM_HAS_LINES || !line)) {
        lim_piece_fill *const fill = lim_target_fill(target);
        struct lim_piece_look look = {target->ctx, colour, y_px};
        fill(&look, x_px, (uint16_t)(x_px + n_px));
        return;
    }
    lim_fill(line, x_px, n_px, colour);
}

#endif
