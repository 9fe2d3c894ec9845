/* SPDX-License-Identifier: MIT
 *
 * SORT takes WALK's place where there is no tree, or none is wanted: every polygon that faces the eye, listed
 * by its farthest point. In: the scene, the eye, the view. Out: polygons, nearest first, for the same SPAN and
 * PAINT. Memory: an entry a polygon, lent by the caller; for LIM_NEWELL more, and room for pieces. Once a frame,
 * however many bands it takes. */
#ifndef LIM_SORTED_H
#define LIM_SORTED_H

#include "pieces/newell.h"
#include "scene.h"

/* An entry of the list. */
struct lim_sorted {
    int32_t far_qv;   /* view-space z of its farthest vertex, as rows.c scales it */
    lim_index record; /* in scene->polygons */
    uint16_t next;    /* in the list, or LIM_NONE */
};

struct lim_sorter {
    struct lim_sorted *list;
    uint16_t size, used;
    uint16_t first; /* of the list; once the frame is ordered, the nearest */
#if LIM_HAS_PIECES
    struct lim_newell newell;
#endif
};

struct lim;

/* Lists and orders. The camera is taken in. */
void lim_sorted_order(struct lim *lim);

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
