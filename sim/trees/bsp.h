/* SPDX-License-Identifier: MIT
 *
 * The tree of a mesh. Nodes carry the stored planes of coplanar groups, or cuts, which are axis planes
 * with no polygon of their own; leaves carry polygons in an order that is right from everywhere. Polygons
 * across a plane are split at exact points; each piece lies, up to the tolerance, on the side of every
 * plane above it that it was filed under. */
#ifndef SIM_BSP_H
#define SIM_BSP_H

#include "trees/coplanar.h"
#include "trees/edges.h"

#define BSP_NONE UINT32_MAX

struct parts;

/* A corner of a piece and the edge that leads to the next corner. */
struct bsp_corner {
    uint32_t point, edge;
};

/* A polygon of the mesh, or what splitting left of it. */
struct bsp_piece {
    size_t first; /* corners[first .. first + count) */
    uint32_t count;
    uint32_t polygon;         /* of the mesh */
    double centre[3], radius; /* a sphere that holds it; units */
};

struct bsp_node {
    uint32_t group;       /* of coplanar polygons, whose plane is the node's; or a cut; BSP_NONE: a leaf */
    uint32_t front, back; /* child nodes or BSP_NONE */
    uint32_t parent;      /* BSP_NONE at the root */
    bool in_front;        /* is it its parent's front child? */
    bool is_mesh;         /* a leaf whose pieces come in no order */
    size_t first, count;  /* its pieces: placed[first .. first + count); a leaf's nearest first */
};

struct bsp {
    const struct mesh *mesh;
    const struct coplanar *coplanar;
    const struct parts *parts; /* that shall become mesh leaves; NULL: none */
    double tolerance_units;    /* a corner this near to a plane counts as on it; 0: only if exactly on it */
    struct edges edges;        /* leads to the points */
    struct bsp_corner *corners;
    struct bsp_piece *pieces;
    struct bsp_node *nodes; /* parents before children, front subtrees before back ones */
    uint32_t *placed;       /* pieces, node by node */
    struct plane *cuts;     /* group coplanar->count + i is cuts[i] */
    struct map cut_of;      /* (axis, d) -> i */
    size_t cut_count, cut_capacity;
    size_t corner_count, corner_capacity, piece_count, piece_capacity, node_count, node_capacity;
    size_t placed_count, placed_capacity;
    size_t splits, depth;
};

/* More pieces than any scene can hold: building stops there. */
enum { BSP_PIECES_MAX = 1 << 20 };

/* Where a list of pieces stands: to become the front or the back child of a node, or the root (BSP_NONE). */
struct bsp_place {
    uint32_t parent;
    bool in_front;
};

/* The plane of a group or a cut. */
const struct plane *bsp_plane(const struct bsp *bsp, uint32_t group);

/* The group that stands for the axis plane of that kind, PLANE_X..PLANE_Z, at d. */
uint32_t bsp_cut(struct bsp *bsp, enum plane_kind axis, int32_t d);

enum { BSP_ON = 0, BSP_FRONT = 1, BSP_BACK = 2, BSP_BOTH = BSP_FRONT | BSP_BACK };

/* Where the corners of a piece are: a sum of BSP_FRONT and BSP_BACK. */
int bsp_piece_sides(const struct bsp *bsp, const struct bsp_piece *piece, const struct plane *plane);

/* The same of a group's plane, but a piece that lies on it all over is filed on one side: where it is over a polygon of
 * the group, or under it; else on that of its middle, or of its part's. */
int bsp_piece_filed(const struct bsp *bsp, const struct bsp_piece *piece, uint32_t group);

/* A new piece: that polygon of the mesh, whole. */
uint32_t bsp_piece_of(struct bsp *bsp, uint32_t polygon);

/* Splits a piece that has corners on both sides of the group's plane. */
void bsp_piece_split(struct bsp *bsp, uint32_t piece, uint32_t group, uint32_t *front, uint32_t *back);

/* How far any corner of a piece lies on the wrong side of a plane that the piece is filed under,
 * or off the plane that it is filed in; an upper bound, in units, 0 if exactly none does. */
double bsp_worst_violation(const struct bsp *bsp);

void bsp_free(struct bsp *bsp); /* leaves the points alone */

#endif
