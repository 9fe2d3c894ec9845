/* SPDX-License-Identifier: MIT
 *
 * From a camera to the three rows of the view matrix: done once a frame, in 64 bits. */
#ifndef LIM_ROWS_H
#define LIM_ROWS_H

#include "camera.h"
#include "stages.h"

/* Returns false when the camera is out of range (camera.h). */
bool lim_rows_set(struct lim_rows *rows, const struct lim_scene *scene, const struct lim_camera *camera);

/* The same with the axes that lim_orientation_set() would make of the angles. Without a scene, for what may be anywhere
 * in the 16-bit cube. */
bool lim_rows_set_turned(struct lim_rows *rows, const struct lim_scene *scene, const struct lim_camera *camera,
                         const int32_t axes_q30[9]);

#endif
