/* SPDX-License-Identifier: MIT
 *
 * Edges are looked at one by one, anew on every line: there is no state that could differ between orders.
 *
 * Corners run counter-clockwise. So an edge that goes down is a left boundary and one that goes up a right one; one
 * that goes to the left has the polygon below, and one that goes to the right above. */
#include "lines/wireframe.h"

#include "pixels/fill.h"
#include "screen/edge.h"
#include "screen/polygon.h"

#if LIM_HAS_WIREFRAME

/* Pixels x0 <= x < x1; empty if x0 >= x1. */
struct stroke {
    int16_t x0, x1;
};

static int16_t lesser(int16_t a, int16_t b)
{
    return a < b ? a : b;
}

static int16_t wireframe_greater(int16_t a, int16_t b)
{
    return a > b ? a : b;
}

/* Where the edge from p to q strokes line y. Between this line and the one beyond the edge it passes the columns from
 * one crossing to the other: the pixels that it parts from their neighbours above, or below. */
static struct stroke stroke_of(struct lim_point p, struct lim_point q, int16_t y)
{
    const bool is_left = p.y < q.y;
    const struct lim_point upper = is_left ? p : q, lower = is_left ? q : p;
    const int16_t top = lim_edge_line_of(upper.y), bottom = lim_edge_line_of(lower.y);

    if (y + 1 < top || y > bottom) return (struct stroke){0, 0};
    const int16_t here = lim_edge_column(upper, lower, y);
    const int16_t beyond = p.x == q.x ? here : lim_edge_column(upper, lower, (int16_t)(q.x < p.x ? y - 1 : y + 1));
    struct stroke stroke = {lesser(here, beyond), wireframe_greater(here, beyond)};
    if (y < top || y >= bottom) return stroke;
    if (is_left)
        stroke.x1 = wireframe_greater(stroke.x1, (int16_t)(here + 1));
    else
        stroke.x0 = lesser(stroke.x0, (int16_t)(here - 1));
    return stroke;
}

struct lim_wire lim_wire_of(const struct lim_screen_polygon *polygon, const struct lim_wireframe *style,
                            uint16_t background, int16_t y)
{
    return (struct lim_wire){.at = polygon->at,
                             .hidden = lim_hidden_of(polygon),
                             .colour = style->one_colour ? lim_memory_colour(style->colour) : polygon->colour,
                             .background = background,
                             .y = y,
                             .n = polygon->n};
}

static void stroke_run(uint16_t *line, const struct lim_wire *wire, int16_t x0, int16_t x1, uint16_t colour)
{
    lim_fill_run(wire->target, line, (uint16_t)wire->y, (uint16_t)x0, (uint16_t)(x1 - x0), colour);
}

void lim_wire_fill(uint16_t *line, const struct lim_wire *wire, uint16_t x0, uint16_t x1)
{
    stroke_run(line, wire, (int16_t)x0, (int16_t)x1, wire->background);
    for (uint_fast8_t k = 0; k < wire->n; k++) {
        if (wire->hidden[k >> 4] >> (k & 15) & 1) continue;
        const struct lim_point next = wire->at[k + 1u < wire->n ? k + 1u : 0];
        const struct stroke stroke = stroke_of(wire->at[k], next, wire->y);
        const int16_t from = wireframe_greater(stroke.x0, (int16_t)x0), to = lesser(stroke.x1, (int16_t)x1);
        if (from < to) stroke_run(line, wire, from, to, wire->colour);
    }
}

#endif
