/* SPDX-License-Identifier: MIT
 *
 * Which sector a triangle is of, by the lines round it. */
#ifndef SIM_LEVEL_REGIONS_H
#define SIM_LEVEL_REGIONS_H

#include "levels/level.h"
#include "levels/level_triangles.h"

static const uint32_t LEVEL_VOID = UINT32_MAX; /* no sector */

struct level_sectors {
    struct triangles triangles;
    uint32_t *sector_of; /* each triangle: a sector, or LEVEL_VOID */
    uint32_t *next;      /* of each half-edge, the next one round its polygon */
    uint32_t *before;
    bool *is_inside;       /* of each half-edge: no border of its polygon */
    uint32_t *points;      /* of each vertex of the map that a line has; others: TRIANGLES_NONE */
    size_t crossing_count; /* lines that cross others, and end there */
    uint32_t first_crossing;
    size_t astray_count; /* lines that name a sector which does not lie beside them */
    uint32_t first_astray;
    size_t open_count; /* sectors that no lines close off from what is outside of the map */
    uint32_t first_open;
};

/* Sets sectors->sector_of and what is counted with it, once the triangulation is complete. */
void level_regions_find(const struct level *level, struct level_sectors *sectors);

#endif
