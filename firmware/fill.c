/* SPDX-License-Identifier: MIT
 *
 * Two pixels a store, sixteen a turn: a full-screen fill is bound by memory, not by the loop. */
#include "fill.h"

typedef uint32_t __attribute__((may_alias)) pixel_pair; /* the lines are arrays of uint16_t */

void lim_fill(uint16_t *line, uint16_t x_px, uint16_t n_px, uint16_t colour)
{
    uint16_t *p = line + x_px, *const end = p + n_px;
    const uint32_t pair = (uint32_t)colour << 16 | colour;

    if ((x_px & 1) && p < end) *p++ = colour;
    for (; end - p >= 16; p += 16) {
        pixel_pair *q = (pixel_pair *)(void *)p;
        q[0] = q[1] = q[2] = q[3] = pair;
        q[4] = q[5] = q[6] = q[7] = pair;
    }
    for (; end - p >= 2; p += 2)
        *(pixel_pair *)(void *)p = pair;
    if (p < end) *p = colour;
}
