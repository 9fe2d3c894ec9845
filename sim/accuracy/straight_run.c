/* SPDX-License-Identifier: MIT
 *
 * A straight line through n points, by least squares. */
#include "accuracy/straight_run.h"

#include <math.h>

static const double SAME_STEP = 0.004; /* texels a pixel: what places are rounded to, in pictures of 256 texels */

static double way_between(const struct straight_pixel *from, const struct straight_pixel *to, int axis)
{
    const double way = (to->texels[axis] - from->texels[axis]) / from->sides[axis];
    return (way - floor(way + 0.5)) * from->sides[axis];
}

static bool goes_on(const struct straight_run *run, const struct straight_pixel *pixel)
{
    if (!run->count || pixel->begins || pixel->y_px != run->last.y_px || pixel->level != run->last.level) return false;
    if (pixel->x_px != run->last.x_px + 1) return false;
    for (int i = 0; i < 2 && run->count > 1; i++)
        if (fabs(way_between(&run->last, pixel, i) - run->step[i]) > SAME_STEP) return false;
    return true;
}

static void add(struct straight_run *run, const struct straight_pixel *pixel)
{
    const double x = pixel->x_px - run->first.x_px;
    for (int i = 0; i < 2; i++) {
        if (run->count == 1) run->step[i] = way_between(&run->first, pixel, i);
        run->way[i] += pixel->way[i];
        run->x_way[i] += x * pixel->way[i];
        run->ways2 += pixel->way[i] * pixel->way[i];
    }
    run->x += x;
    run->xx += x * x;
    run->last = *pixel;
    run->count++;
}

double straight_run_end(struct straight_run *run)
{
    const double n = (double)run->count, spread = n * run->xx - run->x * run->x;
    double left = run->ways2;
    for (int i = 0; i < 2 && run->count > 2; i++) {
        const double slope = (n * run->x_way[i] - run->x * run->way[i]) / spread;
        left -= slope * (run->x_way[i] - run->x * run->way[i] / n) + run->way[i] * run->way[i] / n;
    }
    left = run->count > 2 && left > 0 ? left : 0;
    *run = (struct straight_run){.count = 0};
    return left;
}

double straight_run_add(struct straight_run *run, const struct straight_pixel *pixel)
{
    double left = 0;
    if (!goes_on(run, pixel)) {
        left = straight_run_end(run);
        run->first = *pixel;
    }
    add(run, pixel);
    return left;
}
