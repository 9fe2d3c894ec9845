/* SPDX-License-Identifier: MIT
 *
 * From a camera to the three rows of the view matrix: done once a frame, in 64 bits. */
#ifndef LIM_ROWS_H
#define LIM_ROWS_H

#include "camera.h"
#include "view/transform.h"

struct lim_rows {
    uint8_t tele_bits;     /* the row of z is kept 2^tele_bits times as long: a narrow lens makes it short */
    struct lim_row row[3]; /* x, y and z of view space */
    int32_t near_qv;       /* distance of the near plane in view space, >= PERSPECTIVE_Z_MIN_QV */
    uint32_t far_units;    /* no vertex is farther from the eye */
};

/* Returns false when the camera is out of range (camera.h). */
bool lim_rows_set(struct lim_rows *rows, const struct lim_scene *scene, const struct lim_camera *camera);

/* The same with the axes that lim_orientation_set() would make of the angles. Without a scene, for what may be anywhere
 * in the 16-bit cube. */
bool lim_rows_set_turned(struct lim_rows *rows, const struct lim_scene *scene, const struct lim_camera *camera,
                         const int32_t axes_q30[9]);

#endif
