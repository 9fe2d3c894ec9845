/* SPDX-License-Identifier: MIT
 *
 * Double-precision vectors of three, as plain arrays, for the host's mesh stages. */
#ifndef SIM_VEC3_H
#define SIM_VEC3_H

#include <math.h>

static inline void vec3_sub(double out[3], const double a[3], const double b[3])
{
    for (int axis = 0; axis < 3; axis++)
        out[axis] = a[axis] - b[axis];
}

static inline double vec3_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double vec3_distance2(const double a[3], const double b[3])
{
    double d[3];
    vec3_sub(d, a, b);
    return vec3_dot(d, d);
}

/* Where on the line from a to b the foot of p's perpendicular lies: 0 at a, 1 at b. a != b. */
static inline double vec3_foot(const double a[3], const double b[3], const double p[3])
{
    double ab[3], ap[3];
    vec3_sub(ab, b, a);
    vec3_sub(ap, p, a);
    return vec3_dot(ab, ap) / vec3_dot(ab, ab);
}

/* Squared distance of p from the segment a-b, which may be a point. */
static inline double vec3_segment_distance2(const double a[3], const double b[3], const double p[3])
{
    double from_a2 = vec3_distance2(a, p), length2 = vec3_distance2(a, b);
    if (length2 == 0) return from_a2;
    double t = vec3_foot(a, b, p);
    if (t <= 0) return from_a2;
    if (t >= 1) return vec3_distance2(b, p);
    double off2 = 0;
    for (int axis = 0; axis < 3; axis++) {
        double off = p[axis] - (a[axis] + t * (b[axis] - a[axis]));
        off2 += off * off;
    }
    return off2;
}

#endif
