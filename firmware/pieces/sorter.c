/* SPDX-License-Identifier: MIT
 *
 * No recursion, and no array beside the links. */
#include "pieces/sorter.h"

#if LIM_HAS_SORTED

/* Ends a stretch after at most `length` entries. Returns what follows. */
static uint16_t cut_after(struct lim_sorted *list, uint16_t at, uint16_t length)
{
    while (at != LIM_NONE && --length)
        at = list[at].next;
    if (at == LIM_NONE) return LIM_NONE;
    const uint16_t rest = list[at].next;
    list[at].next = LIM_NONE;
    return rest;
}

/* Appends two sorted stretches to *tail, merged. Returns the new tail. */
static uint16_t *merge(struct lim_sorted *list, uint16_t a, uint16_t b, uint16_t *tail)
{
    while (a != LIM_NONE || b != LIM_NONE) {
        const bool from_b = a == LIM_NONE || (b != LIM_NONE && lim_sorted_precedes(&list[b], &list[a]));
        uint16_t *const from = from_b ? &b : &a;
        *tail = *from;
        tail = &list[*from].next;
        *from = *tail;
    }
    return tail;
}

uint16_t lim_sorted_sort(struct lim_sorted *list, uint16_t first)
{
    for (uint16_t length = 1;; length = (uint16_t)(2 * length)) {
        uint16_t rest = first, *tail = &first;
        uint16_t merged = 0;
        for (first = LIM_NONE; rest != LIM_NONE; merged++) {
            const uint16_t a = rest, b = cut_after(list, a, length);
            rest = cut_after(list, b, length);
            tail = merge(list, a, b, tail);
        }
        if (merged <= 1) return first;
    }
}

void lim_sorted_reverse(struct lim_sorter *sorter)
{
    uint16_t first = sorter->first;

    sorter->first = LIM_NONE;
    while (first != LIM_NONE) {
        const uint16_t next = sorter->list[first].next;
        sorter->list[first].next = sorter->first;
        sorter->first = first;
        first = next;
    }
}

#endif
