/* SPDX-License-Identifier: MIT
 *
 * Walls run along the axes, so a window looks north, south or west. */
#include "demo_window.h"

struct frame window_frame(const struct window *window)
{
    const int *lo = window->lo_mm, *hi = window->hi_mm;
    double x = (lo[0] + hi[0]) / 2.0, z = (lo[2] + hi[2]) / 2.0;
    switch (window->outward) {
    case NORTH:
        return frame_at(x, lo[1], lo[2], 0);
    case SOUTH:
        return frame_at(x, lo[1], hi[2], 180);
    case WEST:
        break;
    }
    return frame_at(lo[0], lo[1], z, 90);
}

int window_width_mm(const struct window *window)
{
    int along = window->outward == WEST ? 2 : 0;
    return window->hi_mm[along] - window->lo_mm[along];
}

int window_height_mm(const struct window *window)
{
    return window->hi_mm[1] - window->lo_mm[1];
}
