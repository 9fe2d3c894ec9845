/* SPDX-License-Identifier: MIT
 *
 * Which sector is where: the plane, divided by a map's lines into triangles of one sector each, and those joined to
 * convex polygons. All corners are vertices of the map, so floors, ceilings and walls share them. */
#ifndef SIM_LEVEL_SECTORS_H
#define SIM_LEVEL_SECTORS_H

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

/* Refuses a map whose lines enclose nothing. */
bool level_sectors_make(const struct level *level, struct level_sectors *out, struct error *err);
void level_sectors_free(struct level_sectors *sectors);

/* Calls `take` for each polygon: its corners, counter-clockwise, and its sector. */
typedef void level_polygon_sink(void *context, const int32_t (*corners)[2], size_t count, uint32_t sector);
void level_sectors_each(const struct level_sectors *sectors, level_polygon_sink *take, void *context);

/* LEVEL_VOID: outside of all. */
uint32_t level_sector_at(const struct level_sectors *sectors, int x, int y);

#endif
