/* SPDX-License-Identifier: MIT
 *
 * Architecture by carving: the world is solid, rooms, doorways, window openings and the outdoors
 * are boxes of air cut out of it. What is left between air and solid is the scene's shell: closed,
 * without cracks and without overlaps whatever the boxes do. */
#ifndef DEMO_CARVE_H
#define DEMO_CARVE_H

#include "demo_soup.h"

/* Instead of a material: no surface. */
enum { LEFT_OUT = -1 };

/* One box of air, in millimetres, and the materials of the surfaces around it. */
struct space {
    int lo_mm[3], hi_mm[3];
    int floor, floor2; /* chequered where they differ */
    int wall, ceiling;
    int dado, dado_mm; /* the walls' lower part */
    int panel_mm;      /* surfaces are cut into panels of about this size, each of one colour; 0: not cut */
    int tile_mm[2];    /* the floor's tiles along x and z; 0: panels */
};

void carve(struct soup *soup, const struct space *spaces, size_t count);

#endif
