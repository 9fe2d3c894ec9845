/* SPDX-License-Identifier: MIT
 *
 * Sides are cut in two, and the parts again, until chance or depth says stop. */
#include "tiny_scenes.h"

#include "tiny_model.h"

#include <math.h>

struct tiling {
    struct model *model;
    struct random *random;
    double turn[2]; /* radians, about y and x */
    int side;       /* 0..5: axis * 2 + (1 for the far side) */
};

static void place(const struct tiling *tiling, double u, double v, double out[3])
{
    int axis = tiling->side / 2;
    double p[3];
    p[axis] = tiling->side % 2, p[(axis + 1) % 3] = u, p[(axis + 2) % 3] = v;
    double c = cos(tiling->turn[0]), s = sin(tiling->turn[0]), x = c * p[0] + s * p[2], z = c * p[2] - s * p[0];
    c = cos(tiling->turn[1]), s = sin(tiling->turn[1]);
    out[0] = x, out[1] = c * p[1] - s * z, out[2] = s * p[1] + c * z;
}

static void add_tile(const struct tiling *tiling, const double low[2], const double high[2])
{
    double corners[4][3];
    bool far = tiling->side % 2; /* the near side is seen from behind: the other way round */
    place(tiling, low[0], low[1], corners[0]);
    place(tiling, high[0], low[1], corners[far ? 1 : 3]);
    place(tiling, high[0], high[1], corners[2]);
    place(tiling, low[0], high[1], corners[far ? 3 : 1]);
    tiny_add(tiling->model, 4, (const double(*)[3])corners);
}

static void cut(const struct tiling *tiling, const double low[2], const double high[2], int depth)
{
    if (depth == 0 || random_in(tiling->random, 0, 4) == 0) {
        add_tile(tiling, low, high);
        return;
    }
    int axis = (int)random_in(tiling->random, 0, 1);
    double at = low[axis] + (high[axis] - low[axis]) * (0.2 + 0.6 * random_unit(tiling->random));
    double end[2] = {high[0], high[1]}, start[2] = {low[0], low[1]};
    end[axis] = start[axis] = at;
    cut(tiling, low, end, depth - 1);
    cut(tiling, start, high, depth - 1);
}

void tiny_tiled_box(struct model *model, struct random *random)
{
    const double low[2] = {0, 0}, high[2] = {1, 1};
    struct tiling tiling = {model, random, {random_unit(random), random_unit(random)}, 0};
    for (; tiling.side < 6; tiling.side++)
        cut(&tiling, low, high, 5);
}
