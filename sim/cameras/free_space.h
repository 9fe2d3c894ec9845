/* SPDX-License-Identifier: MIT
 *
 * Where a scene's free space is: the side of its polygons from which they are seen. Right for closed scenes; in open
 * ones it still finds the side from which polygons are seen. */
#ifndef SIM_FREE_SPACE_H
#define SIM_FREE_SPACE_H

#include "scene/compiled.h"

/* Whether a point, in metres, lies in front of whatever polygons are next to it. The scene has polygons. */
bool free_space_holds(const struct compiled *scene, const double at_m[3]);

#endif
