/* SPDX-License-Identifier: MIT
 *
 * One convex solid, line by line. In: a scene whose tree is a chain: each node's polygons face away
 * from all that comes after it, so the order of the nodes is right from everywhere. Out: every line
 * painted once, from left to right. Memory: a link a polygon, a head a line, and the faces that
 * cross one line, lent. */
#ifndef LIM_CONVEX_H
#define LIM_CONVEX_H

#include "project.h"

/* A polygon that faces the eye and meets the screen; faces lie in the order of the nodes. */
struct lim_face {
    uint16_t record; /* word offset into lim_scene.polygons */
    uint16_t next;   /* in a list, or LIM_NONE */
};

/* A face, or a triangle of a folded one, that crosses the current line: pixels [left.x, right.x). */
struct lim_crossing {
    struct lim_edge_pair pair;
    struct lim_screen_polygon polygon; /* shape.top: the line on which `pair` begins */
    uint32_t rank;                     /* the lower, the nearer */
    uint16_t next;                     /* in the list, or LIM_NONE */
    bool seen;                         /* it has painted a pixel; LIM_HAS_STATS only */
};

struct lim_convex {
    struct lim_face *faces;
    uint16_t face_count;
    uint16_t late;  /* faces for which there was no room on the line above */
    uint16_t *tops; /* for each line the faces that start on it, or LIM_NONE */
    struct lim_crossing *pool;
    uint16_t pool_size, used;
    uint16_t first, free; /* lists through `next`; `first` runs from left to right */
};

#endif
