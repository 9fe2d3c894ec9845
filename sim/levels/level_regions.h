/* SPDX-License-Identifier: MIT
 *
 * Which sector a triangle is of, by the lines round it. */
#ifndef SIM_LEVEL_REGIONS_H
#define SIM_LEVEL_REGIONS_H

#include "levels/level_sectors.h"

/* Sets sectors->sector_of and what is counted with it, once the triangulation is complete. */
void level_regions_find(const struct level *level, struct level_sectors *sectors);

#endif
