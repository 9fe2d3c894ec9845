/* SPDX-License-Identifier: MIT
 *
 * Which way a camera looks: from its three angles to the axes of view space. */
#ifndef LIM_ORIENTATION_H
#define LIM_ORIENTATION_H

#include "camera.h"

/* The camera's axes in the scene's, one after the other, unit vectors within 8 units of 2^-30 a component: to the
 * right, down and ahead, in the order in which view space has them. */
void lim_orientation_set(int32_t axes_q30[9], const struct lim_camera *camera);

#endif
