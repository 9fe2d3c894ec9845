/* SPDX-License-Identifier: MIT
 *
 * SORT takes WALK's place where there is no tree, or none is wanted: every polygon that faces the eye, listed
 * by its farthest point. In: the scene, the eye, the view. Out: polygons, nearest first, for the same SPAN and
 * PAINT. Memory: an entry a polygon, lent by the caller; for LIM_NEWELL more, and room for pieces. Once a frame,
 * however many bands it takes. */
#ifndef LIM_SORTED_H
#define LIM_SORTED_H

#include "movers/mover.h"
#include "pieces/newell.h"
#include "view/pass.h"

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

/* Lists and orders. The camera is taken in. */
void lim_sorted_order(struct lim_sorter *sorter);

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
