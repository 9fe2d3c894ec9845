/* SPDX-License-Identifier: MIT
 *
 * Hostile cameras, for the tests of the extremes: what is hard comes up often. */
#ifndef TESTS_RANDOM_CAMERA_H
#define TESTS_RANDOM_CAMERA_H

#include "camera.h"
#include "random.h"

#include <math.h>

/* Along the axes, half-way between them, or a hair off: a whole turn has 8 eighths. */
static inline uint32_t random_angle(struct random *random)
{
    const uint32_t eighth = (uint32_t)random_in(random, 0, 7) << 29;

    switch (random_u64(random) % 3) {
    case 0:
        return eighth;
    case 1:
        return eighth + (uint32_t)random_in(random, -3, 3);
    default:
        return (uint32_t)random_u64(random);
    }
}

/* As many long lenses as wide ones, and often either end of the range. */
static inline uint32_t random_tan_q28(struct random *random)
{
    const int doublings = LIM_HAS_TELE ? 12 : 7;
    uint32_t tan_q28;

    switch (random_u64(random) % 5) {
    case 0:
        return LIM_TAN_MIN_Q28;
    case 1:
        return LIM_TAN_MAX_Q28;
    default:
        tan_q28 = (uint32_t)random_in(random, LIM_TAN_MIN_Q28, 2 * LIM_TAN_MIN_Q28);
        return tan_q28 << random_in(random, 0,
                                    doublings); /* a statement of its own: compilers would choose the order */
    }
}

/* From the eye to the corners of the near plane that is in use (camera.h), in units. */
static inline double near_reach_units(const struct lim_camera *camera)
{
    const double tan_x = ldexp(camera->tan_x_q28, -28), tan_y = ldexp(camera->tan_y_q28, -28);
    const double narrow = fmin(1, fmin(tan_x, tan_y)), zoom = narrow < 1.0 / 8 ? 0.5 : narrow;

    return fmax(2 / zoom, camera->near_q8 / 256.0) * sqrt(1 + tan_x * tan_x + tan_y * tan_y);
}

#endif
