/* SPDX-License-Identifier: MIT
 *
 * Where two convex outlines overlap in a plane. */
#ifndef SIM_OVERLAP_H
#define SIM_OVERLAP_H

#include <stdbool.h>
#include <stddef.h>

/* A convex outline, counter-clockwise; grows as needed, overlap_free() it. */
struct outline_2d {
    double (*at)[2];
    size_t count, capacity;
};

void outline_2d_add(struct outline_2d *outline, double u, double v);

/* Leaves in `part` what lies within `window`; `spare` is room for it. Returns whether anything that is as wide as
 * `least` does: a common edge is nothing. */
bool overlap_find(struct outline_2d *part, const struct outline_2d *window, struct outline_2d *spare, double least);

void outline_2d_free(struct outline_2d *outline);

#endif
