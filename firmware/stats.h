/* SPDX-License-Identifier: MIT
 *
 * What a frame did, counted. */
#ifndef LIM_STATS_H
#define LIM_STATS_H

#include "config.h"

/* The tests of LIM_NEWELL in their textbook order, and where they are tried swapped. */
enum lim_newell_test {
    LIM_TEST_X,          /* 1: the extents in x do not overlap, in whole pixels */
    LIM_TEST_Y,          /* 2: nor those in y */
    LIM_TEST_P_BEHIND,   /* 3: P lies behind Q's plane */
    LIM_TEST_Q_IN_FRONT, /* 4: Q lies in front of P's plane */
    LIM_TEST_APART,      /* 5: the projections do not overlap */
    LIM_TEST_Q_BEHIND,   /* 3': Q lies behind P's plane */
    LIM_TEST_P_IN_FRONT, /* 4': P lies in front of Q's plane */
    LIM_TEST_P_PART,     /* 6: that part of P which lies in front of Q's plane does not overlap Q on the screen */
    LIM_TEST_P_REST,     /* 6': nor does that part which lies behind it */
    LIM_TESTS
};

/* Why an entry was left to its farthest point, in LIM_NEWELL and where movers meet. */
enum lim_forced {
    LIM_FORCED_ROOM,    /* no memory for another piece */
    LIM_FORCED_CORNERS, /* a piece would have too many corners */
    LIM_FORCED_EFFORT,  /* no comparisons left */
    LIM_FORCED_REASONS
};

/* What it took to order a frame's polygons. */
struct lim_newell_stats {
    uint32_t comparisons;                   /* pairs whose extents in z overlap */
    uint32_t decided[LIM_TESTS];            /* which test settled how many of them */
    uint32_t swaps;                         /* a Q that goes before its P */
    uint32_t splits;                        /* polygons or pieces cut in two */
    uint32_t divisions;                     /* parts of the list that a plane divided */
    uint32_t stuck;                         /* of these: comparing found neither an order nor a polygon to split */
    uint32_t forced;                        /* entries left to their farthest points: the picture may be wrong there */
    uint32_t forced_by[LIM_FORCED_REASONS]; /* the same, by reason */
};

/* What became of a frame's instances. */
struct lim_mover_stats {
    uint32_t
        left_out;    /* without a mesh, beyond the declared number, too far away, or drawn by a method without a tree */
    uint32_t hidden; /* out of view */
    uint32_t divided;  /* that reached through a plane: their polygons were taken one by one */
    uint32_t pieces;   /* cuts by planes of the scene */
    uint32_t forced;   /* left to their centres, because there was no room: perhaps wrong */
    uint32_t entries;  /* most in use in one walk, of entries or of cuts */
    uint32_t unsorted; /* lists that met a leaf's polygons without being sorted with them: perhaps wrong */
};

/* What delta output sent of a frame. */
struct lim_delta_stats {
    uint32_t pixels;      /* sent */
    uint32_t windows;     /* opened for them; with pages, pieces of pages */
    uint16_t runs_max;    /* most of the runs that were kept at a time */
    uint16_t lines_whole; /* lines that were sent whole because the last frame's, or their own, were not kept */
};

/* What a frame did; all zero when LIM_HAS_STATS is 0. Lines that nearest first leaves to the painter's order, for want
 * of memory, have no background that is counted. */
struct lim_stats {
    uint32_t nodes;            /* nodes visited */
    uint32_t records;          /* records of leaves, each of which has a plane to test */
    uint32_t boxes, boxes_out; /* subtree bounds tested; of these out of the open view */
    uint32_t hidden;           /* subtrees that cannot be seen from where the eye is */
    uint32_t polygons;         /* polygons reached: front-facing, in a subtree that was not skipped */
    uint32_t polygons_seen;    /* of these, with at least one pixel */
    uint32_t vertices;         /* vertices transformed */
    uint32_t clipped;          /* polygons that met the near plane or the guard band */
    uint32_t non_monotone;     /* polygons that rounding made non-monotone, drawn as triangles */
    uint32_t lines;            /* lines of polygons that were stepped */
    uint32_t pixels_painted;   /* pixels written by polygons, as often as they are; not of pictures that targets keep */
    uint32_t pixels_background; /* pixels filled with the background; convex: those that no face has painted, about */
#if LIM_HAS_TEXTURE
    uint32_t divisions; /* for the perspective of textures */
#endif
    uint32_t bands; /* extra walks because a pool was exhausted; convex: faces' lines without room */
#if LIM_HAS_SORTED
    uint32_t sorted; /* entries of the sorted list, pieces included */
#endif
#if LIM_HAS_PIECES
    struct lim_newell_stats newell;
#endif
#if LIM_HAS_MOVERS
    struct lim_mover_stats movers;
#endif
#if LIM_HAS_DELTA
    struct lim_delta_stats delta;
#endif
    uint16_t retained_cells_max, gaps_max, active_max; /* most used of each pool in one walk; convex: faces on a line */
    uint16_t layers_max;                               /* most transparent pieces of one line, nearest first */
};

#endif
