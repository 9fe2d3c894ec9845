/* SPDX-License-Identifier: MIT
 *
 * What reference_scene.c knows of a polygon, and reference.c draws. */
#ifndef SIM_REFERENCE_POLYGON_H
#define SIM_REFERENCE_POLYGON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* a * u + b * v + c, for u and v from -1 to 1 across the picture, v upwards. */
struct reference_edge {
    double a, b, c;
};

struct reference_polygon {
    uint32_t first, count; /* points[first .. first + count) */
    uint32_t face, mapping;
    size_t mover; /* 0: none */
    bool two_sided;
    double normal[3], offset_m;          /* normal . p = offset_m; not of unit length */
    double level_share;                  /* of a depth, in the frame being drawn: as much apart is in one plane */
    struct reference_edge inverse_depth; /* of the plane, for the frame being drawn */
    double depth_min_m, depth_max_m;     /* of the corners, the same */
};

static inline double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

static inline void subtract(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[i] - b[i];
}

#endif
