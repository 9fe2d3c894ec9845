/* SPDX-License-Identifier: MIT
 *
 * Which way a camera looks: from its three angles to the axes of view space. */
#ifndef LIM_ORIENTATION_H
#define LIM_ORIENTATION_H

#include "camera.h"

/* The camera's axes in the scene's, unit vectors within 8 units of 2^-30 a component: to the right, down
 * and ahead, in the order in which view space has them. */
struct lim_orientation {
    int32_t right_q30[3], down_q30[3], ahead_q30[3];
};

void lim_orientation_set(struct lim_orientation *orientation, const struct lim_camera *camera);

#endif
