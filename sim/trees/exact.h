/* SPDX-License-Identifier: MIT
 *
 * Points as exact rationals (GMP), in units, not rounded: vertices of the mesh and the points
 * where planes cut its edges. Each carries a double that decides whatever rounding cannot
 * change; GMP decides the rest. */
#ifndef SIM_EXACT_H
#define SIM_EXACT_H

#include "model/mesh.h"
#include "scene/plane.h"

#include <gmp.h>

/* Units with 8 fraction bits, on the grid or between its points. */
struct grid_point {
    int64_t q8[3];
};

struct exact_points {
    mpq_t (*at)[3];
    double (*approx)[3]; /* at, truncated: a relative error of at most 2^-52 */
    size_t count, at_capacity, approx_capacity;
};

void exact_free(struct exact_points *points);

/* Forgets the points from `count` on. */
void exact_truncate(struct exact_points *points, size_t count);

/* Adds (point_m - origin) * units_per_m, computed without rounding. Returns its index. */
uint32_t exact_add_m(struct exact_points *points, const double point_m[3], const struct grid *grid);

/* Adds the point where the line through points a and b, on different sides or not, meets the
 * plane; the line must not be parallel to it. */
uint32_t exact_add_crossing(struct exact_points *points, uint32_t a, uint32_t b, const struct plane *plane);

/* The sign of n . p - d, exact. */
int exact_side(const struct exact_points *points, uint32_t point, const struct plane *plane);

/* The order of two points along an axis, exact: negative, 0, positive. */
int exact_compare(const struct exact_points *points, uint32_t a, uint32_t b, int axis);

/* The nearest point whose coordinates have fraction_bits bits, 0..8; halves round up. */
struct grid_point exact_snap(const struct exact_points *points, uint32_t point, int fraction_bits);

#endif
