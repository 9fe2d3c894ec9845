/* SPDX-License-Identifier: MIT
 *
 * Corners lie on no round numbers, so that a lattice does not happen to hold them. */
#include "scale_floor.h"

#include <math.h>

enum { ROW = 5, BOXES = ROW * ROW };
static const double APART_M = 3, OFF_M[2] = {0.137, 0.291};

static void write_box(FILE *obj, int number, const double low_m[2], double edge_m)
{
    static const int faces[5][4] = {{5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}};
    for (int i = 0; i < 8; i++) {
        const double x_m = low_m[0] + (i % 4 == 1 || i % 4 == 2 ? edge_m : 0),
                     z_m = low_m[1] + (i % 4 >= 2 ? edge_m : 0);
        fprintf(obj, "v %.6f %.6f %.6f\n", x_m, i < 4 ? 0 : edge_m, z_m);
    }
    for (int f = 0; f < 5; f++)
        fprintf(obj, "f %d %d %d %d\n", 4 + 8 * number + faces[f][0], 4 + 8 * number + faces[f][1],
                4 + 8 * number + faces[f][2], 4 + 8 * number + faces[f][3]);
}

bool scale_floor_write(FILE *obj, long side_m, double least_m, double most_m)
{
    const double half_m = (double)side_m / 2;
    fprintf(obj, "v %.6f 0 %.6f\nv %.6f 0 %.6f\nv %.6f 0 %.6f\nv %.6f 0 %.6f\nf 1 4 3 2\n", -half_m, -half_m, half_m,
            -half_m, half_m, half_m, -half_m, half_m);
    for (int i = 0; i < BOXES; i++) {
        const double low_m[2] = {(i % ROW - ROW / 2) * APART_M + OFF_M[0], (i / ROW - ROW / 2) * APART_M + OFF_M[1]};
        write_box(obj, i, low_m, least_m * pow(most_m / least_m, i / (BOXES - 1.0)));
    }
    return !ferror(obj);
}

bool scale_floor_walk(FILE *cam, int frames)
{
    for (int i = 0; i < frames; i++) {
        const double angle = 6.283185307179586 * i / frames, away_m = 9 + 3 * cos(5 * angle);
        fprintf(cam, "%.4f %.4f %.4f %.4f 0.3 %.4f\n", away_m * cos(angle), 1.2 + 0.7 * sin(3 * angle),
                away_m * sin(angle), 2 * sin(7 * angle), 2 * cos(4 * angle));
    }
    return !ferror(cam);
}
