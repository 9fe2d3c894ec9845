/* SPDX-License-Identifier: MIT
 *
 * Frames that lim_frame_begin() began, for what drops them. */
#ifndef LIM_AHEAD_H
#define LIM_AHEAD_H

#include "limner.h"

/* If a frame was begun, it is no more, and has no instances. */
static inline void lim_drop_ahead(struct lim *lim)
{
    if (LIM_HAS_MOVERS && lim->ahead.stage != LIM_AHEAD_NONE) lim->movers->count = lim->movers->given = 0;
    lim->ahead.stage = LIM_AHEAD_NONE;
}

#endif
