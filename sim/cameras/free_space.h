/* SPDX-License-Identifier: MIT
 *
 * Where a scene's free space is: the side of its polygons from which they are seen. Right for closed scenes; in open
 * ones it still finds the side from which polygons are seen. */
#ifndef SIM_FREE_SPACE_H
#define SIM_FREE_SPACE_H

#include "scene/compiled.h"

/* Whether a point, in metres, lies in front of whatever polygons are next to it. The scene has polygons. */
bool free_space_holds(const struct compiled *scene, const double at_m[3]);

enum { FREE_SPACE_RAYS_MAX = 16 };

/* Whether the eye at such a point sees fronts rather than backs: of the rays to the targets and beyond no fewer meet
 * the front of a polygon first than a back, through which it is seen. From outside of a level, which is made to be seen
 * from within, it does not. Looks at all polygons. */
bool free_space_shows_fronts(const struct compiled *scene, const double at_m[3], const double (*targets_m)[3],
                             size_t count);

/* Whether three quarters of these rays and more meet a front first: of a scene that is seen from within alone. */
bool free_space_is_within(const struct compiled *compiled, const double at_m[3], const double (*targets_m)[3],
                          size_t count);

#endif
