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
#include "view/pass.h"

#define LIM_CONVEX_MEM_B(h_px, polygon_count, active_count)                                                            \
    LIM_MEM_ALIGNED_B(LIM_MEM_ALIGNED_B(LIM_CONVEX_POOL_AT_B(h_px) + (polygon_count) * sizeof(struct lim_face)) +      \
                      (active_count) * sizeof(struct lim_crossing))
/* Where the crossings begin, whose edges may have 64 bits. */
#define LIM_CONVEX_POOL_AT_B(h_px)                                                                                     \
    ((LIM_MEM_ALIGNED_B(LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) + (h_px) * sizeof(uint16_t)) +         \
      LIM_ALIGNOF(struct lim_crossing) - 1) &                                                                          \
     ~(LIM_ALIGNOF(struct lim_crossing) - 1))

/* A polygon that faces the eye and meets the screen. */
struct lim_face {
    lim_index record;                        /* word offset into lim_scene.polygons */
    uint16_t next;                           /* in a list, or LIM_NONE */
    uint16_t crossing;                       /* its entry in the pool, or LIM_NONE */
    LIM_OPTIONAL(bool, seen, LIM_HAS_STATS); /* it has painted a pixel */
};

/* A face that crosses the current line, and where its boundaries are unless it is non-monotone. Free for another
 * one on the lines from polygon.shape.bottom on. */
struct lim_crossing {
    struct lim_screen_polygon polygon;
    struct lim_edge_pair pair;
    LIM_OPTIONAL(struct lim_gradients, gradients, LIM_HAS_TEXTURE); /* if it has a texture */
};

struct lim_convex {
    struct lim_pass *pass;
    const struct lim_texturing *texturing;
    uint16_t *tops; /* for each line the faces that start on it, or LIM_NONE */
    struct lim_crossing *pool;
    struct lim_face *faces; /* those of this frame from the farthest to the nearest: from `farthest` to memory's end */
    uint16_t pool_used;     /* entries that this frame has used, free again or not */
    uint16_t farthest;
    uint16_t first;                                          /* of the faces that cross the current line, or LIM_NONE */
    LIM_OPTIONAL(struct lim_piece_look, look, LIM_HAS_FILL); /* of the current line */
};

/* `active`: for how many faces on a line; 0 is the least. */
size_t lim_convex_mem_b(const struct lim_scene *scene, const struct lim_target *target, uint16_t active);
void lim_convex_init(struct lim_convex *convex, void *mem, size_t mem_b);

/* A frame, of a camera that is taken in. 0, an enum lim_error, or the target's error. */
LIM_MUST_CHECK int lim_convex_frame(struct lim_convex *convex);

#endif
