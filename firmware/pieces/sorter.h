/* SPDX-License-Identifier: MIT
 *
 * Lists of polygons, of pieces of split ones, and of movers: entries linked by their places, which are lent by the
 * caller. Sorted by merging, longer and longer stretches. */
#ifndef LIM_SORTER_H
#define LIM_SORTER_H

#include "movers/mover.h"
#include "view/pass.h"

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

/* An entry of the list. */
struct lim_sorted {
    int32_t far_qv;   /* view-space z of its farthest vertex, as rows.c scales it */
    lim_index record; /* in scene->polygons */
    uint16_t next;    /* in the list, or LIM_NONE */
};

/* A list of the scene's polygons, once a frame; or of movers and their pieces, in the walk through a tree. */
struct lim_sorter {
    struct lim_pass *pass;
    struct lim_movers *movers; /* whose parts entries may be */
    struct lim_sorted *list;
    uint16_t size, used;
    uint16_t first; /* of the list; once the frame is ordered, the nearest */
    bool comparing; /* movers by newell.c: what it wants to know of pieces is kept up */
    LIM_OPTIONAL(struct lim_newell, newell, LIM_HAS_PIECES);
};

/* Whether the frame has movers. */
static inline bool lim_moves(const struct lim_sorter *sorter)
{
    return LIM_HAS_MOVERS && sorter->movers->count > 0;
}

/* Sorts a list by far_qv, farthest first, entries that tie by descending record: nearest first, that is the order
 * in which a scene has them. Returns its first entry. */
uint16_t lim_sorted_sort(struct lim_sorted *list, uint16_t first);

/* Turns the list round. */
void lim_sorted_reverse(struct lim_sorter *sorter);

/* Whether a is to be painted before b. */
static inline bool lim_sorted_precedes(const struct lim_sorted *a, const struct lim_sorted *b)
{
    return a->far_qv > b->far_qv || (a->far_qv == b->far_qv && a->record > b->record);
}

#endif
