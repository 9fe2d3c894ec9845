/* SPDX-License-Identifier: MIT
 *
 * Corner k of a box has the high end of axis i where bit i of k is set. */
#include "boxes.h"

#include "tiny_model.h"

#include <math.h>

static void add_side(struct model *model, const double low_m[3], const double high_m[3], int axis, int far, bool inside)
{
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = far ? 1 << axis : 0;
    const bool reversed = far ? inside : !inside; /* u, v, axis are right-handed */
    const int around[4] = {base, base + (reversed ? v : u), base + u + v, base + (reversed ? u : v)};
    double corners[4][3];

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            corners[k][i] = around[k] >> i & 1 ? high_m[i] : low_m[i];
    tiny_add(model, 4, (const double(*)[3])corners);
}

static void add_box(struct model *model, const double low_m[3], const double high_m[3], bool inside)
{
    for (int side = 0; side < 6; side++)
        add_side(model, low_m, high_m, side / 2, side % 2, inside);
}

void boxes_add_world(struct model *model)
{
    const double low_m[3] = {-BOXES_END_M, -BOXES_END_M, -BOXES_END_M};
    const double high_m[3] = {BOXES_END_M, BOXES_END_M, BOXES_END_M};

    boxes_add_room(model, low_m, high_m);
}

void boxes_add_room(struct model *model, const double low_m[3], const double high_m[3])
{
    add_box(model, low_m, high_m, true);
}

void boxes_add_solid(struct model *model, const double low_m[3], const double high_m[3])
{
    add_box(model, low_m, high_m, false);
}

/* Six times the volume of a tetrahedron; positive if d lies behind the face a b c. */
static double volume(const double a[3], const double b[3], const double c[3], const double d[3])
{
    double sum = 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += (a[i] - d[i]) * ((b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]));
    }
    return sum;
}

void boxes_add_tetrahedron(struct model *model, const double corners_m[4][3], bool hollow)
{
    for (int out = 0; out < 4; out++) {
        double face[3][3];
        int count = 0;
        for (int k = 0; k < 4; k++)
            if (k != out) memcpy(face[count++], corners_m[k], sizeof face[0]);
        if ((volume(face[0], face[1], face[2], corners_m[out]) < 0) != hollow) {
            double other[3];
            memcpy(other, face[1], sizeof other);
            memcpy(face[1], face[2], sizeof other);
            memcpy(face[2], other, sizeof other);
        }
        tiny_add(model, 3, (const double(*)[3])face);
    }
}

static void random_corner(struct random *random, const double centre_m[3], double out_m[3])
{
    boxes_random_point(random, 10 * 256, 256, out_m);
    for (int i = 0; i < 3; i++)
        out_m[i] += centre_m[i];
}

void boxes_add_jumble(struct model *model)
{
    struct random random = {70};

    boxes_add_world(model);
    for (int k = 0; k < 24; k++) {
        double centre_m[3], corners_m[4][3];
        boxes_random_point(&random, 90 * 256, 256, centre_m);
        for (int c = 0; c < 4; c++)
            random_corner(&random, centre_m, corners_m[c]);
        if (k % 3 == 0) {
            double high_m[3];
            for (int i = 0; i < 3; i++)
                high_m[i] = centre_m[i] + 256 * (double)random_in(&random, 1, 30);
            boxes_add_solid(model, centre_m, high_m);
        } else if (volume(corners_m[0], corners_m[1], corners_m[2], corners_m[3]) != 0) {
            boxes_add_tetrahedron(model, (const double(*)[3])corners_m, false);
        }
    }
}

void boxes_random_point(struct random *random, double range_m, double step_m, double out_m[3])
{
    const int64_t steps = (int64_t)floor(range_m / step_m);

    for (int i = 0; i < 3; i++)
        out_m[i] = (double)random_in(random, -steps, steps) * step_m;
}
