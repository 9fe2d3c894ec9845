/* SPDX-License-Identifier: MIT
 *
 * One convex solid, line by line. In: a scene whose tree is a chain: each node's polygons face away
 * from all that comes after it, so the order of the nodes is right from everywhere. Out: every line
 * painted once, from top to bottom. Memory, lent: a head a line, three numbers a polygon that faces the eye, and the
 * faces that cross one line. */
#ifndef LIM_CONVEX_H
#define LIM_CONVEX_H

#include "pixels/texture.h"
#include "screen/project.h"

/* A polygon that faces the eye and meets the screen. */
struct lim_face {
    lim_index record;  /* word offset into lim_scene.polygons */
    uint16_t next;     /* in a list, or LIM_NONE */
    uint16_t crossing; /* its entry in the pool, or LIM_NONE */
#if LIM_HAS_STATS
    bool seen; /* it has painted a pixel */
#endif
};

/* A face that crosses the current line, and where its boundaries are unless it is non-monotone. Free for another
 * one on the lines from polygon.shape.bottom on. */
struct lim_crossing {
    struct lim_screen_polygon polygon;
    struct lim_edge_pair pair;
#if LIM_HAS_TEXTURE
    struct lim_gradients gradients; /* if it has a texture */
#endif
};

struct lim_convex {
    uint16_t *tops; /* for each line the faces that start on it, or LIM_NONE */
    struct lim_crossing *pool;
    struct lim_face *faces; /* those of this frame from the farthest to the nearest: from `farthest` to memory's end */
    uint16_t pool_used;     /* entries that this frame has used, free again or not */
    uint16_t farthest;
    uint16_t first; /* of the faces that cross the current line, or LIM_NONE */
};

#endif
