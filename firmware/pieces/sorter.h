/* SPDX-License-Identifier: MIT
 *
 * Lists of polygons and of pieces of split ones: entries linked by their places, which are lent by the caller. Sorted
 * by merging, longer and longer stretches. */
#ifndef LIM_SORTER_H
#define LIM_SORTER_H

#include "orders.h"

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
