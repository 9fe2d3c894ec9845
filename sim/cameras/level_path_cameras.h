/* SPDX-License-Identifier: MIT
 *
 * The players and things of a map (levels/level_cameras.h) as a camera path. */
#ifndef SIM_LEVEL_PATH_CAMERAS_H
#define SIM_LEVEL_PATH_CAMERAS_H

#include "cameras/camera_path.h"

/* A frame each; most: as many of them, the first one and others as evenly as can be; 0: all. */
bool level_path_cameras(const char *path, size_t most, struct camera_path *out, struct error *err);

#endif
