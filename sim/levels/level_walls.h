/* SPDX-License-Identifier: MIT
 *
 * Walls: what a line's sides show above, below and between the sectors beside it. */
#ifndef SIM_LEVEL_WALLS_H
#define SIM_LEVEL_WALLS_H

#include "levels/level.h"
#include "levels/level_faces.h"
#include "levels/level_sectors.h"

/* Between the sectors that there are (level_sectors.h), also where lines say otherwise or there is none, so that
 * nothing is open. sky: the index of the look of the sky's texture. */
void level_walls_add(const struct level *level, const struct level_sectors *sectors, size_t sky,
                     struct level_faces *faces);

static inline bool level_is_sky(const char *flat)
{
    for (const char *sky = LEVEL_SKY_FLAT; *sky || *flat; sky++, flat++)
        if (*sky != *flat) return false;
    return true;
}

#endif
