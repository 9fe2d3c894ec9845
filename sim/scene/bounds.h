/* SPDX-License-Identifier: MIT
 *
 * Bounds of what is drawn below each node: the compiler makes boxes of them, the loader holds boxes
 * against them. */
#ifndef SIM_BOUNDS_H
#define SIM_BOUNDS_H

#include "long.h"

struct bounds {
    int low[3], high[3]; /* units, fractions included; empty: low > high */
    size_t polygons;
};

/* Fills a bounds for each of the scene's nodes, whose indices and runs must be sound. */
void bounds_of_subtrees(const struct lim_scene *scene, struct bounds *all);

/* Of all vertices of a mesh. */
struct bounds bounds_of_mesh(const struct lim_scene *scene);

/* The least box, and whether a box is large enough. */
struct lim_box bounds_box(const struct bounds *bounds);
bool bounds_fit(const struct bounds *bounds, const struct lim_box *box);

/* The same of a long scene. */
struct lim_long_box bounds_long_box(const struct bounds *bounds);
bool bounds_fit_long(const struct bounds *bounds, const struct lim_long_box *box);

#endif
