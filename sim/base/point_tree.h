/* SPDX-License-Identifier: MIT
 *
 * A k-d tree over points: finds those near a segment. Welding asks it for the neighbours of a point,
 * T-vertex insertion for the points along an edge. */
#ifndef SIM_POINT_TREE_H
#define SIM_POINT_TREE_H

#include <stddef.h>
#include <stdint.h>

struct point_tree {
    double (*points)[3]; /* the caller's */
    uint32_t *order;     /* indices into points: the middle of a range splits it */
    size_t count;
};

/* Called once for each point found, in no particular order. */
typedef void point_tree_visitor(void *context, uint32_t point);

/* A tree over the `count` points that `chosen` names. */
void point_tree_build(struct point_tree *tree, double (*points)[3], const uint32_t *chosen, size_t count);

/* Visits every point nearer than `radius` to the segment from a to b (a == b: to the point). */
void point_tree_near(const struct point_tree *tree, const double a[3], const double b[3], double radius,
                     point_tree_visitor *visit, void *context);

void point_tree_free(struct point_tree *tree);

#endif
