/* SPDX-License-Identifier: MIT
 *
 * The memory that frames of a compiled scene need. */
#ifndef LIM_FRAME_MEMORY_H
#define LIM_FRAME_MEMORY_H

#include <stdint.h>

/* What memory a frame needs; the compiler measures all but the first two on sampled cameras. A frame that needs more
 * falls back to bands; without room for pieces, polygons go by their farthest points (LIM_NEWELL). */
struct lim_limits {
    uint16_t depth;    /* nodes on the longest path from the root: least stack of the walk */
    uint16_t vertices; /* most vertices of any polygon */
    /* What the next three take together is one memory, which they share; LIM_CONVEX and meshes take the last alone. */
    uint16_t retained_cells; /* points and heads of the polygons retained between SPAN and PAINT */
    uint16_t gaps;           /* gaps beyond the first of each line, all lines together */
    uint16_t active;         /* polygons that cross one line, beyond those that find room elsewhere */
    uint16_t pieces;         /* LIM_NEWELL: how often polygons are split */
    uint16_t layers;         /* pieces of transparent polygons on one line; 0: there are no such polygons */
    uint16_t leaf_vertices;  /* most vertices of any mesh leaf; 0: there is none */
    uint16_t leaf_polygons;  /* of a mesh leaf that are sorted at once, measured likewise: 1 or more if there is one */
};

#endif
