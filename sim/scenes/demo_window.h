/* SPDX-License-Identifier: MIT
 *
 * A window of the house, and where it stands. */
#ifndef DEMO_WINDOW_H
#define DEMO_WINDOW_H

#include "demo_vec.h"

#include <stdbool.h>

enum outward { NORTH, SOUTH, WEST };

/* A window: the box of its opening through the wall, divided by bars into columns and rows. */
struct window {
    int lo_mm[3], hi_mm[3];
    enum outward outward;
    int columns, rows;
    bool sunny;        /* the sun shines in */
    double brightness; /* of the sky seen through it, 1 = as it is */
};

/* At the middle of a window's outer lower edge, facing into the room. */
struct frame window_frame(const struct window *window);
int window_width_mm(const struct window *window);
int window_height_mm(const struct window *window);

#endif
