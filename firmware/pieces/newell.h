/* SPDX-License-Identifier: MIT
 *
 * The depth sort of Newell, Newell and Sancha: from farthest to nearest, each polygon P is compared with every Q
 * that its extent in z overlaps, until it is certain that P may be painted before all of them; else Q goes
 * first, and where that goes round in a circle, or the two pass through each other, they are split.
 *
 * "Behind a plane" is the side on which the eye is not. A vertex within |n0| + |n1| + |n2| of a plane n . p = d
 * is on it, and counts for either side: rounding to units moves it by half of that, and the compiler's tolerance by
 * as much. A polygon is never split twice by one plane: its pieces remember. */
#ifndef LIM_NEWELL_H
#define LIM_NEWELL_H

#include "scene.h"
#include "view/cull.h"

/* Zero is the default; either gives a right picture. */
struct lim_newell_options {
    bool planes_first; /* tests 3 and 4 before 1 and 2 */
    bool split_one;    /* only P, by Q's plane, where that does */
    uint32_t most;     /* comparisons of a list, after which it is painted as it is; 0: LIM_NEWELL_EFFORT (config.h) */
};

/* What LIM_NEWELL has to know of an entry of the sorted list beside its farthest point. */
struct lim_newell_polygon {
    int32_t near_qv;      /* view-space z of its nearest vertex */
    struct lim_rect rect; /* holds every pixel of it */
    lim_index node;       /* whose run it is in */
    uint16_t cuts;        /* the last cut that made this piece, or LIM_NONE: it is whole */
    bool eye_in_front;    /* of its plane */
    bool swapped : 1;     /* it goes before a P already */
    bool last : 1;        /* of its part of the list: what follows may be painted after all of that */
    uint16_t owner;       /* the mover that it belongs to, or LIM_NONE */
};

/* A piece lies on one side of the plane of another entry. */
struct lim_cut {
    uint16_t next; /* the cut before it, or LIM_NONE */
    uint16_t by;   /* that entry, and LIM_CUT_FRONT */
};
#define LIM_CUT_FRONT 0x8000u
#define LIM_SORTED_MAX 0x7FFFu /* entries of a list */

struct lim_newell {
    struct lim_newell_polygon *polygons; /* one an entry */
    struct lim_cut *cuts;
    uint16_t cut_size, cuts_used;
    struct lim_newell_options options;
    uint32_t left; /* comparisons of this list */
};

struct lim_sorter;

/* What LIM_NEWELL knows of a polygon of the scene, which is an entry of the list already: its nearest point, where its
 * plane is, and which pixels it may have. false: nothing of it can be seen. */
bool lim_newell_add(struct lim_sorter *sorter, uint16_t entry, int32_t near_qv, lim_index node, bool eye_in_front);

/* From a list sorted by farthest points, farthest first, to the right order, nearest first. */
void lim_newell_order(struct lim_sorter *sorter);

#endif
