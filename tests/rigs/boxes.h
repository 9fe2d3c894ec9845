/* SPDX-License-Identifier: MIT
 *
 * Scenes of boxes and tetrahedra in whole metres where one metre is one unit of the grid: a room from
 * end to end of the grid makes it so, and all that is built in it lies exactly where it is meant to. */
#ifndef TESTS_BOXES_H
#define TESTS_BOXES_H

#include "model/model.h"
#include "random.h"

#define BOXES_END_M 32767 /* of the grid, in each direction */

/* The walls of the room that is as large as the grid, seen from inside. The model starts empty. */
void boxes_add_world(struct model *model);

/* The six sides of a box, seen from inside or from outside. */
void boxes_add_room(struct model *model, const double low_m[3], const double high_m[3]);
void boxes_add_solid(struct model *model, const double low_m[3], const double high_m[3]);

/* A tetrahedron, its faces seen from outside, or, `hollow`, from inside. */
void boxes_add_tetrahedron(struct model *model, const double corners_m[4][3], bool hollow);

/* The world with boxes and tetrahedra in it, through one another, their corners on multiples of 256 m. */
void boxes_add_jumble(struct model *model);

/* A whole number of steps from -range_m to range_m on each axis. */
void boxes_random_point(struct random *random, double range_m, double step_m, double out_m[3]);

#endif
