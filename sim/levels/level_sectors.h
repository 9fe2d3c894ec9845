/* SPDX-License-Identifier: MIT
 *
 * Which sector is where: the plane, divided by a map's lines into triangles of one sector each, and those joined to
 * convex polygons. All corners are vertices of the map, so floors, ceilings and walls share them. */
#ifndef SIM_LEVEL_SECTORS_H
#define SIM_LEVEL_SECTORS_H

#include "levels/level_regions.h"

/* Refuses a map whose lines enclose nothing. */
bool level_sectors_make(const struct level *level, struct level_sectors *out, struct error *err);
void level_sectors_free(struct level_sectors *sectors);

/* Calls `take` for each polygon: its corners, counter-clockwise, and its sector. */
typedef void level_polygon_sink(void *context, const int32_t (*corners)[2], size_t count, uint32_t sector);
void level_sectors_each(const struct level_sectors *sectors, level_polygon_sink *take, void *context);

/* LEVEL_VOID: outside of all. */
uint32_t level_sector_at(const struct level_sectors *sectors, int x, int y);

#endif
