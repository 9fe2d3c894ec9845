/* SPDX-License-Identifier: MIT
 *
 * Which polygon a ray meets first: a tree of boxes over the polygons of a soup that no longer
 * changes. Polygons are opaque from both sides here. */
#ifndef DEMO_RAYS_H
#define DEMO_RAYS_H

#include "demo_soup.h"

#include <stdbool.h>

enum { NOTHING = -1 };

struct rays {
    const struct soup *soup;
    struct rays_node *nodes;
    int *order; /* polygon numbers, leaf by leaf */
    int node_count;
};

struct rays rays_build(const struct soup *soup);
void rays_free(struct rays *rays);

/* The nearest polygon along a unit direction, or NOTHING. */
int rays_first(const struct rays *rays, struct vec3 from, struct vec3 direction);

/* Is anything within reach in the way? What shines itself, sky and flames, is not. */
bool rays_blocked(const struct rays *rays, struct vec3 from, struct vec3 direction, double reach_m);

#endif
