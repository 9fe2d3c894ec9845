/* SPDX-License-Identifier: MIT
 *
 * Sutherland and Hodgman (1974): the outline is cut by one edge of the window after the other. */
#include "trees/overlap.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>

void outline_2d_add(struct outline_2d *outline, double u, double v)
{
    outline->at = grow(outline->at, outline->count, &outline->capacity, sizeof *outline->at);
    outline->at[outline->count][0] = u;
    outline->at[outline->count++][1] = v;
}

void outline_2d_free(struct outline_2d *outline)
{
    free(outline->at);
    *outline = (struct outline_2d){0};
}

/* Twice the area of a triangle; > 0: c is to the left of the line from a to b. */
static double turn(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* What lies to the left of the line from a to b. */
static void cut(const struct outline_2d *from, const double a[2], const double b[2], struct outline_2d *to)
{
    to->count = 0;
    for (size_t i = 0; i < from->count; i++) {
        const double *p = from->at[i], *q = from->at[(i + 1) % from->count];
        const double p_left = turn(a, b, p), q_left = turn(a, b, q);
        if (p_left >= 0) outline_2d_add(to, p[0], p[1]);
        if ((p_left >= 0) == (q_left >= 0)) continue;
        const double along = p_left / (p_left - q_left);
        outline_2d_add(to, p[0] + along * (q[0] - p[0]), p[1] + along * (q[1] - p[1]));
    }
}

/* Twice its area over half its perimeter, or a little more, if it is long. */
static double width_of(const struct outline_2d *outline)
{
    double area = 0, perimeter = 0;
    for (size_t i = 0; i < outline->count; i++) {
        const double *p = outline->at[i], *q = outline->at[(i + 1) % outline->count];
        if (i + 1 < outline->count) area += turn(outline->at[0], p, q);
        perimeter += hypot(q[0] - p[0], q[1] - p[1]);
    }
    return perimeter > 0 ? area / perimeter : 0;
}

bool overlap_find(struct outline_2d *part, const struct outline_2d *window, struct outline_2d *spare, double least)
{
    for (size_t i = 0; i < window->count && part->count; i++) {
        cut(part, window->at[i], window->at[(i + 1) % window->count], spare);
        const struct outline_2d whole = *part;
        *part = *spare;
        *spare = whole;
    }
    return width_of(part) > least;
}
