/* SPDX-License-Identifier: MIT
 *
 * A wide floor with 25 small boxes on it, in five rows about its middle: what a single grid holds badly. */
#ifndef SCALE_FLOOR_H
#define SCALE_FLOOR_H

#include <stdbool.h>
#include <stdio.h>

enum { SCALE_FLOOR_MIN = 20, SCALE_FLOOR_MAX = 1000000 };

/* The floor is side_m wide and long, at height 0; the edges of the boxes grow from least_m to most_m, evenly in their
 * logarithm. 126 faces: box k has the faces 5 k + 2 to 5 k + 6, and no bottom. */
bool scale_floor_write(FILE *obj, long side_m, double least_m, double most_m);

/* Round the boxes at a man's height and below, as a camera file. */
bool scale_floor_walk(FILE *cam, int frames);

#endif
