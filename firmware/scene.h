/* SPDX-License-Identifier: MIT
 *
 * A compiled scene: a BSP tree in const data. `limner compile` writes it as C arrays for flash
 * and as a .lim file, which a host loads in place; SCENE.md specifies the bits of both.
 *
 * Coordinates are units: 16-bit integers, one scale for the whole scene, y up, right-handed.
 * A plane is the set of points p with n . p = d; its front is where n . p > d. */
#ifndef LIM_SCENE_H
#define LIM_SCENE_H

#include "config.h"

#define LIM_NONE 0xFFFFu /* "no such index", in every index field below */

enum { LIM_SCENE_VERSION = 2 };

struct lim_vertex {
    int16_t x, y, z; /* units */
};

/* What rounding to units took from a vertex: in profile exact it is drawn at units + fraction. */
struct lim_fraction {
    int8_t x_q8, y_q8, z_q8;
};

/* How a node's plane is stored; each kind is decided exactly. */
enum lim_plane_kind {
    LIM_PLANE_X,     /* x = plane: the node's field `plane` is the offset itself, an int16_t */
    LIM_PLANE_Y,     /* y = plane */
    LIM_PLANE_Z,     /* z = plane */
    LIM_PLANE_XZ,    /* upright: lim_plane with n[1] == 0 and exact == LIM_NONE */
    LIM_PLANE_SMALL, /* lim_plane with exact == LIM_NONE: n and d are the plane */
    LIM_PLANE_LARGE  /* lim_plane is a filter; lim_plane_exact decides when it cannot */
};

/* Bounds that the compiler keeps: |n[0]| + |n[1]| + |n[2]| <= 32767 and |d| < 2^30.
 * LARGE: n = the exact normal times s, rounded, with s such that the longest component is at
 * most 8191; d = the exact d times s, rounded. */
struct lim_plane {
    int16_t n[3];
    uint16_t exact; /* index into lim_scene.exact, or LIM_NONE */
    int32_t d;      /* n . p of the points on the plane, in n's scale times units */
};

/* |n[i]| < 2^31, |d| < 2^48; d = d_hi * 2^32 + d_lo. */
struct lim_plane_exact {
    int32_t n[3];
    int32_t d_hi;
    uint32_t d_lo;
};

/* A run is a sequence of polygon records in lim_scene.polygons that share a plane and a facing:
 * word 0: bits 0..7 number of vertices, bit 15 set in the run's last record, the rest zero;
 * word 1: colour, RGB565 as a number (red in bits 11..15);
 * then one vertex index a word, counter-clockwise seen from the side that the polygon faces. */
#define LIM_POLYGON_COUNT 0x00FFu
#define LIM_POLYGON_LAST 0x8000u
enum { LIM_POLYGON_HEAD_WORDS = 2 };

struct lim_node {
    uint16_t kind;        /* enum lim_plane_kind */
    uint16_t plane;       /* offset or index into lim_scene.planes, by kind */
    uint16_t front, back; /* child nodes on either side of the plane, or LIM_NONE */
    uint16_t front_run;   /* word offset of the polygons that face the front, or LIM_NONE */
    uint16_t back_run;    /* the same for those that face the back */
    uint16_t box;         /* bounds of the whole subtree, or LIM_NONE: too small to be worth it */
};

/* Holds every polygon of a subtree: |p[i] - centre[i]| <= half[i]. */
struct lim_box {
    int16_t centre[3]; /* units */
    uint16_t half[3];  /* units, 0..32768 */
};

/* What memory a frame needs; the compiler measures the last three on sampled cameras, and a
 * frame that needs more falls back to bands. */
struct lim_limits {
    uint16_t depth;          /* nodes on the longest path from the root: least stack of the walk */
    uint16_t vertices;       /* most vertices of any polygon */
    uint16_t retained_cells; /* points and heads of the polygons retained between SPAN and PAINT */
    uint16_t gaps;           /* gaps beyond the first of each line, all lines together */
    uint16_t active;         /* polygons that cross one line */
};

struct lim_scene {
    const LIM_FLASH struct lim_vertex *vertices;
    const LIM_FLASH struct lim_node *nodes; /* the root is nodes[0]; children come after parents */
    const LIM_FLASH struct lim_plane *planes;
    const LIM_FLASH struct lim_plane_exact *exact;
    const LIM_FLASH struct lim_box *boxes;
    const LIM_FLASH uint16_t *polygons;
    const LIM_FLASH struct lim_fraction *fractions; /* vertex_count of them, or NULL */
    uint16_t vertex_count, node_count, plane_count, exact_count, box_count;
    uint16_t polygon_words; /* length of `polygons` */
    uint16_t polygon_count; /* records in it */
    uint16_t background;    /* colour where no polygon is seen, RGB565 as a number */
    struct lim_limits limits;
};

#endif
