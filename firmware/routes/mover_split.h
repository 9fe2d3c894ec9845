/* SPDX-License-Identifier: MIT
 *
 * Lists of movers on their way down a tree: whole instances, polygons of these, pieces. Planes of the static scene
 * divide a list. In: posed movers. Memory: the sorter's entries. */
#ifndef LIM_MOVER_SPLIT_H
#define LIM_MOVER_SPLIT_H

#include "orders.h"

/* The list of all movers that `open` may show, from scratch: pieces of an earlier walk are gone. */
uint16_t lim_movers_list(struct lim_sorter *sorter, const struct lim_cull *open);

/* Whether an entry is a whole instance. */
static inline bool lim_mover_is_whole(const struct lim_sorter *sorter, uint16_t entry)
{
    return sorter->list[entry].record == LIM_NO_INDEX;
}

/* The polygons of a whole instance that face the eye, nearest first, as a list that ends in `rest`. LIM_NONE: there is
 * no room for them. */
bool lim_mover_burst(struct lim_sorter *sorter, uint16_t entry, uint16_t *list);

/* Counts the entries in use, or the cuts, whichever are more: there is room for as many. */
void lim_movers_note_entries(struct lim_sorter *sorter);

/* Adds the polygons of a leaf that face the eye to the list that has come there. false: there is no room, or one of it
 * is to go by its centre; nothing has changed. */
bool lim_movers_join(struct lim_sorter *sorter, lim_index run, uint16_t list);

/* Divides a list by the plane of a node of the static scene; what lies in it goes to the eye's side. */
void lim_movers_divide(struct lim_sorter *sorter, lim_index node, int32_t eye_side, uint16_t list, uint16_t *front,
                       uint16_t *back);

#endif
