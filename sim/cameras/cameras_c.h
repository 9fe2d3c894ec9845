/* SPDX-License-Identifier: MIT
 *
 * A camera path as C, for firmware that plays it: sim/targets/frames.c does. */
#ifndef SIM_CAMERAS_C_H
#define SIM_CAMERAS_C_H

#include "cameras/camera_path.h"

#include <stdio.h>

/* Writes a header: the picture's size as CAMERAS_W_PX and CAMERAS_H_PX, CAMERAS_COUNT, and the array `cameras` in the
 * scene's units. times_s, NULL or one a camera: where in the animation each is, as CAMERAS_TIME_MS(frame). Refuses what
 * camera_path_to_camera() refuses. */
bool cameras_c_write(const struct camera_path *path, const double *times_s, const struct lens *lens,
                     const struct grid *grid, unsigned w_px, unsigned h_px, FILE *file, struct error *err);

#endif
