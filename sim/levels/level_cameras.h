/* SPDX-License-Identifier: MIT
 *
 * Where a map's players and things stand, as cameras: eyes 41 units above the floor, looking where the thing does. */
#ifndef SIM_LEVEL_CAMERAS_H
#define SIM_LEVEL_CAMERAS_H

#include "base/error.h"

#include <stddef.h>

struct level_camera {
    double eye_m[3], target_m[3];
};

/* Those that stand in a sector higher than an eye: the first player first, the other players, then all other things in
 * their order. path: FILE.wad:MAP. On success *out is the caller's, and there is one at least. */
bool level_cameras_read(const char *path, struct level_camera **out, size_t *count, struct error *err);

#endif
