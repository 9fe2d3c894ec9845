/* SPDX-License-Identifier: MIT
 *
 * What lists of movers are made of: whole instances, polygons of these, and polygons of a leaf of the static scene. In:
 * posed movers. Memory: the sorter's entries. */
#ifndef LIM_MOVER_LIST_H
#define LIM_MOVER_LIST_H

#include "orders.h"

/* A list that grows at its end. */
struct lim_queue {
    struct lim_sorted *list;
    uint16_t *head;
    uint16_t last;
};

static inline struct lim_queue lim_queue_begin(struct lim_sorter *sorter, uint16_t *head)
{
    *head = LIM_NONE;
    return (struct lim_queue){sorter->list, head, LIM_NONE};
}

static inline void lim_queue_add(struct lim_queue *queue, uint16_t entry)
{
    *(queue->last == LIM_NONE ? queue->head : &queue->list[queue->last].next) = entry;
    queue->list[entry].next = LIM_NONE;
    queue->last = entry;
}

/* LIM_NONE: there is no room. */
uint16_t lim_entry_new(struct lim_sorter *sorter, lim_index record, uint16_t owner, lim_index node);

/* The list of all movers that `open` may show, from scratch: pieces of an earlier walk are gone. */
uint16_t lim_movers_list(struct lim_sorter *sorter, const struct lim_cull *open);

/* Whether an entry is an instance, or a part of one. */
static inline bool lim_mover_is_whole(const struct lim_sorter *sorter, uint16_t entry)
{
    return sorter->list[entry].record == LIM_NO_INDEX;
}

/* The polygons of an instance, or of a part of one, that face the eye, nearest first, take its place in a list. false:
 * there is no room for them. */
bool lim_mover_burst(struct lim_sorter *sorter, uint16_t entry, uint16_t *list);

/* Counts the entries in use, or the cuts, whichever are more: there is room for as many. */
void lim_movers_note_entries(struct lim_sorter *sorter);

/* Adds the polygons of a leaf that face the eye to the list that has come there. false: there is no room, or one of it
 * is to go by its centre; nothing has changed. */
bool lim_movers_join(struct lim_sorter *sorter, lim_index run, uint16_t list);

#endif
