/* SPDX-License-Identifier: MIT
 *
 * What a frame did, counted. */
#ifndef LIM_STATS_H
#define LIM_STATS_H

#include "config.h"

/* What a frame did; all zero when LIM_HAS_STATS is 0. */
struct lim_stats {
    uint32_t nodes;             /* nodes visited */
    uint32_t boxes, boxes_out;  /* subtree bounds tested; of these out of the open view */
    uint32_t polygons;          /* polygons reached: front-facing, in a subtree that was not skipped */
    uint32_t polygons_seen;     /* of these, with at least one pixel */
    uint32_t vertices;          /* vertices transformed */
    uint32_t clipped;           /* polygons that met the near plane or the guard band */
    uint32_t folded;            /* polygons that rounding made non-monotone, drawn as triangles */
    uint32_t lines;             /* lines of polygons that were stepped */
    uint32_t pixels_painted;    /* pixels written by polygons; nearest first: each pixel at most once */
    uint32_t pixels_background; /* pixels filled with the background; convex: those that no face has painted, about */
    uint32_t bands;             /* extra walks because a pool was exhausted; convex: faces' lines without room */
    uint16_t retained_cells_max, gaps_max, active_max; /* most used of each pool in one walk; convex: faces on a line */
};

#endif
