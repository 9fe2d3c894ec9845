/* SPDX-License-Identifier: MIT
 *
 * A building of n x n rooms on one floor, in the manner of rooms.obj: 4 m from room to room, doors, boxes, tables;
 * closed, seen from inside. The first SCALE_SUITE x SCALE_SUITE rooms are the same in a building of any size, and no
 * door leads out of them: whoever walks there sees the same. */
#ifndef SCALE_ROOMS_H
#define SCALE_ROOMS_H

#include <stdbool.h>
#include <stdio.h>

enum { SCALE_SUITE = 6, SCALE_ROOMS_MAX = 200, SCALE_FRAMES = 64 };

/* The building as OBJ; false: an error of the file's. */
bool scale_rooms_write(FILE *obj, int n);

/* A walk of SCALE_FRAMES cameras through the rooms of the suite, as a camera file. */
bool scale_rooms_walk(FILE *cam, int n);

#endif
