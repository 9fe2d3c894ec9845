/* SPDX-License-Identifier: MIT
 *
 * Convex solids for tests: hulls of random points on a sphere, the five regular solids, prisms with many
 * sides, boxes with corners along their edges; all about 1 m in radius, turned at random, around the origin. */
#ifndef TESTS_CONVEX_RIG_H
#define TESTS_CONVEX_RIG_H

#include "cameras/camera_path.h"
#include "mesh_rig.h"

enum { CONVEX_RIG_KINDS = 8 }; /* regular solids 0 to 4, prisms 5, boxes 6, random hulls 7 */

/* An empty mesh receives the faces of one solid. */
void convex_rig_add(struct mesh *mesh, struct random *random, unsigned kind);

/* An eye from 0 to 6 m away, one in seven inside of the solid, that looks past it a little; one in four
 * along an axis, so that level edges stay level. */
struct viewpoint convex_rig_viewpoint(struct random *random);

#endif
