/* SPDX-License-Identifier: MIT
 *
 * Which triangles of a mesh need depth at each pixel, because their distance orders them wrongly: those that pass
 * through each other, and large ones beside what is small. Found by drawing. */
#ifndef SIM_MESH_ORDER_H
#define SIM_MESH_ORDER_H

#include "core/core.h"
#include "scene/compiled.h"

/* The share of pixels that may have a wrong order: a part of what a profile may have wrong, or of a bound in percent;
 * 0: there is none. NULL: fast. */
double mesh_order_share(const struct core *core, double wrong_percent);

/* Gives depth to as few triangles of a mesh for LIM_MESH_DEPTH as leave less than `share` of the pixels of sampled
 * pictures with a wrong order, and puts them last; to all, where most need it or no few do. Out of time: likewise. */
bool mesh_order_settle(struct compiled *scene, const struct core *core, double share, struct error *err);

#endif
