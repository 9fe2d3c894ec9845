/* SPDX-License-Identifier: MIT
 *
 * Frames that lim_frame_begin() began, for what drops them. */
#ifndef LIM_AHEAD_H
#define LIM_AHEAD_H

#include "limner.h"

/* If a frame was begun, it is no more, and has no instances. One that is being painted is the target's caller. */
static inline void lim_drop_ahead(struct lim *lim)
{
    LIM_ASSERT(lim && lim->ahead.stage != LIM_AHEAD_PAINTING);
    if (LIM_HAS_MOVERS && lim->ahead.stage != LIM_AHEAD_NONE) lim->movers->count = lim->movers->given = 0;
    lim->ahead.stage = LIM_AHEAD_NONE;
}

#endif
