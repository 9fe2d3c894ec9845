/* SPDX-License-Identifier: MIT
 *
 * Where a camera looks, as camera.h says it, in long double: for tests whose truth has no code of the renderer. */
#ifndef TESTS_CAMERA_AXES_H
#define TESTS_CAMERA_AXES_H

#include "camera.h"

#include <math.h>
#include <string.h>

static inline void camera_axes_turn(long double a[3], long double b[3], long double angle)
{
    for (int i = 0; i < 3; i++) {
        const long double x = a[i], y = b[i];
        a[i] = x * cosl(angle) + y * sinl(angle);
        b[i] = y * cosl(angle) - x * sinl(angle);
    }
}

static inline long double camera_axes_radians(uint32_t angle)
{
    return angle * (2 * acosl(-1) / 4294967296.0L);
}

/* Right, up and ahead. */
static inline void camera_axes_set(const struct lim_camera *camera, long double axes[3][3])
{
    static const long double straight[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};

    memcpy(axes, straight, sizeof straight);
    camera_axes_turn(axes[2], axes[1], camera_axes_radians(camera->pitch));
    for (int axis = 0; axis < 3; axis++) { /* about y: what is ahead turns from -z towards -x */
        const long double x = axes[axis][0], z = axes[axis][2], yaw = camera_axes_radians(camera->yaw);
        axes[axis][0] = x * cosl(yaw) + z * sinl(yaw);
        axes[axis][2] = z * cosl(yaw) - x * sinl(yaw);
    }
    camera_axes_turn(axes[1], axes[0], camera_axes_radians(camera->roll));
}

#endif
