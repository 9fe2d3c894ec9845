/* SPDX-License-Identifier: MIT
 *
 * Hidden lines by painting: a polygon is filled with the background, and the pixels along its outline with a colour.
 * In: a polygon on the screen, and a piece of a line that is the polygon's. Out: pixels. Memory: none.
 *
 * A pixel of the polygon is stroked when one of its four neighbours is not the polygon's and the way there, from centre
 * to centre, crosses an edge that is to be drawn. Nothing but the polygon's own pixels decides, so every order of
 * drawing paints the same; and polygons whose edge is not to be drawn on either side meet without a line. */
#ifndef LIM_WIREFRAME_H
#define LIM_WIREFRAME_H

#include "stages.h"

/* An outline on one line; colours as they lie in memory. */
struct lim_wire {
    const struct lim_target *target; /* what fills the line if it has no memory, or NULL */
    const struct lim_point *at;
    const uint16_t *hidden; /* an edge a bit, from corner k to the next: 1 is not drawn */
    uint16_t colour, background;
    int16_t y;
    uint8_t n;
};

/* A polygon's outline on line y, in a style whose background is `background`. */
struct lim_wire lim_wire_of(const struct lim_screen_polygon *polygon, const struct lim_wireframe *style,
                            uint16_t background, int16_t y);

/* Pixels x0 <= x < x1 of the line, or of the target's if it is NULL, all of them the polygon's. */
void lim_wire_fill(uint16_t *line, const struct lim_wire *wire, uint16_t x0, uint16_t x1);

#endif
