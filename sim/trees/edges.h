/* SPDX-License-Identifier: MIT
 *
 * The lines along which polygons meet: edges of the mesh, and the cuts that splitting made. When
 * a plane cuts an edge the new point is registered on the edge, once, whoever cuts it first; in
 * the end every piece along the edge gets every point of it. So no split opens a crack. */
#ifndef SIM_EDGES_H
#define SIM_EDGES_H

#include "base/map.h"
#include "trees/exact.h"

/* A line between two points. Parts of a cut edge remain the same edge. */
struct mesh_edge {
    uint32_t ends[2];
    bool hidden; /* no edge of the model: a cut, or a diagonal */
};

struct edge_cut {
    uint32_t edge, point;
    const struct edges *edges; /* the table it is in: for the comparison in edges_sort() */
};

struct edges {
    struct exact_points *points; /* the mesh's come first; cuts are added */
    struct mesh_edge *items;
    size_t count, capacity;
    struct edge_cut *cuts; /* edges_sort() brings them into order */
    size_t cut_count, cut_capacity;
    struct map by_ends;  /* (lower end, higher end) -> edge */
    struct map by_plane; /* (edge, plane) -> cut point */
};

/* The edge of the mesh between two points, entered if new. */
uint32_t edges_between(struct edges *edges, uint32_t a, uint32_t b);

/* A new edge that the splitting of one polygon makes. */
uint32_t edges_add_cut(struct edges *edges, uint32_t a, uint32_t b);

/* The point where a plane, known by its index, cuts an edge. */
uint32_t edges_cut(struct edges *edges, uint32_t edge, const struct plane *plane, uint32_t plane_index);

/* Sorts the cuts by edge, and along each edge from ends[0] to ends[1]. */
void edges_sort(struct edges *edges);

/* The registered points strictly between points a and b of an edge, in that order, are
 * cuts[first], cuts[first + step], ... `count` of them. After edges_sort(). */
struct edge_range {
    size_t first, count;
    int step;
};
struct edge_range edges_between_ends(const struct edges *edges, uint32_t edge, uint32_t a, uint32_t b);

void edges_free(struct edges *edges); /* leaves the points alone */

#endif
