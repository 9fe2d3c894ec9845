/* SPDX-License-Identifier: MIT
 *
 * What carpenters, masons and painters add to the carved shell: bars in windows, frames round
 * doors, beams, stairs, the fireplace, roofs, rugs, closed doors, and the houses far away. */
#ifndef DEMO_JOINERY_H
#define DEMO_JOINERY_H

#include "demo_carve.h"
#include "demo_window.h"

/* A window's bars, too flat for their sides to show: width, and distance from the wall's outside;
 * the wall's thickness. */
enum { BAR_MM = 60, BAR_AT_MM = 150, WALL_MM = 350 };

/* How far a doorway's posts reach over the hole in the wall. */
enum { POST_HIDES_MM = 55 };

/* The axis along which one walks through: 0 or 2. */
int doorway_axis(const struct space *doorway);

void joinery_doorway(struct soup *soup, const struct space *doorway);
void joinery_window(struct soup *soup, const struct window *window);
void joinery_fixtures(struct soup *soup);

#endif
