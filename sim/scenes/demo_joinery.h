/* SPDX-License-Identifier: MIT
 *
 * What carpenters, masons and painters add to the carved shell: bars in windows, frames round
 * doors, beams, stairs, the fireplace, roofs, rugs, closed doors, and the houses far away. */
#ifndef DEMO_JOINERY_H
#define DEMO_JOINERY_H

#include "demo_carve.h"
#include "demo_house.h"

/* A window's bars: width, and depth from the wall's outside; the wall's thickness. */
enum { BAR_MM = 60, BAR_FROM_MM = 120, BAR_TO_MM = 180, WALL_MM = 350 };

void joinery_doorway(struct soup *soup, const struct space *doorway);
void joinery_window(struct soup *soup, const struct window *window);
void joinery_fixtures(struct soup *soup);

#endif
