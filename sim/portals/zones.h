/* SPDX-License-Identifier: MIT
 *
 * Zones: cells joined into something like rooms, so that what can be seen is found and stored once for each room
 * and not for each of the tree's many cells. Any partition is right; a good one has few openings between zones. */
#ifndef SIM_ZONES_H
#define SIM_ZONES_H

#include "portals/cells.h"

#define ZONE_NONE UINT32_MAX

struct zones {
    uint32_t *of_cell; /* ZONE_NONE: no eye is expected here, or the cell has no end */
    size_t count;
    uint32_t *cells; /* by zone */
    size_t *first;   /* of each zone in `cells`, count + 1 of them */
};

void zones_find(const struct cells *cells, struct zones *out);
void zones_free(struct zones *zones);

#endif
