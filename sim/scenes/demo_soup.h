/* SPDX-License-Identifier: MIT
 *
 * The demo scene while it is being built: a list of convex, planar, single-sided polygons, each
 * with a material and, once baked, a colour. Cutting keeps polygons convex and planar. */
#ifndef DEMO_SOUP_H
#define DEMO_SOUP_H

#include "demo_material.h"
#include "demo_vec.h"

#include <stddef.h>
#include <stdint.h>

enum {
    POLYGON_CORNERS = 24,
    PRISM_PLANES = 12,
};

struct polygon {
    struct vec3 corner[POLYGON_CORNERS]; /* counter-clockwise seen from the visible side */
    struct vec3 normal;                  /* unit */
    int count;
    int material;
    double grain;    /* -1..1: how this board or brick differs from its neighbours */
    uint32_t colour; /* 0xRRGGBB, baked */
    size_t order;    /* in which it was made */
};

struct soup {
    struct polygon *polygons;
    size_t count, capacity;
    uint32_t random;
};

/* A convex region without ends: inside all of its planes. */
struct prism {
    struct plane plane[PRISM_PLANES];
    int count;
};

/* Like realloc, but ends the program with a message where there is no memory. */
void *demo_realloc(void *memory, size_t size_b);

/* Uniform in 0..1, the same sequence in every run. */
double soup_random(struct soup *soup);

void soup_add(struct soup *soup, const struct vec3 *corner, int count, int material);
void soup_free(struct soup *soup);

/* Adds a polygon made from another one: same plane, material and grain, new corners. */
void soup_add_piece(struct soup *soup, const struct polygon *piece);

/* The plane across `normal` through a point, its inside where another point is. */
struct plane plane_towards(struct vec3 normal, struct vec3 on, struct vec3 inside);

/* The region swept by a convex outline moved both ways along an axis. */
struct prism prism_sweep(const struct vec3 *outline, int count, struct vec3 axis);

/* Cuts a polygon along a prism: it becomes the part inside, pieces of the rest are added at the
 * end. Left alone if nothing of it is inside. */
void soup_cut(struct soup *soup, size_t index, const struct prism *prism);

double polygon_area(const struct polygon *polygon);

/* Maps the unit square onto the polygon, uniformly. */
struct vec3 polygon_point(const struct polygon *polygon, double u, double v);

/* The part of a polygon inside a plane; count 0 if nothing is left. Corners within a millimetre
 * of the plane count as on it, so that no slivers come about. */
struct polygon polygon_clip(const struct polygon *polygon, struct plane plane);

/* The same for all of a prism's planes; count 0 also if it could get too many corners. */
struct polygon polygon_clip_prism(const struct polygon *polygon, const struct prism *prism);

#endif
