/* SPDX-License-Identifier: MIT
 *
 * An entry of LIM_NEWELL's list is a polygon of the scene, or a piece of one: its record, and its plane. */
#ifndef LIM_ENTRY_H
#define LIM_ENTRY_H

#include "orders.h"
#include "view/pass.h"

static inline const LIM_FLASH lim_index *lim_entry_record(const struct lim_sorter *sorter, uint16_t entry)
{
    return &sorter->pass->scene->polygons[sorter->list[entry].record];
}

/* Whether it is a part of a polygon that was split. */
static inline bool lim_entry_is_cut(const struct lim_sorter *sorter, uint16_t entry)
{
    return sorter->newell->polygons[entry].cuts != LIM_NONE;
}

/* The same of an entry of any method's list; others' are whole. */
static inline bool lim_entry_is_split(const struct lim_sorter *sorter, uint16_t entry)
{
    return LIM_IS_NEWELL(&sorter->pass->target) && lim_entry_is_cut(sorter, entry);
}

/* The plane of an entry: of its record, or of the node in whose run that is. */
const LIM_FLASH struct lim_plane_ref *lim_plane_of(const struct lim_sorter *sorter, uint16_t entry);
void lim_plane_load(struct lim_plane_unpacked *plane, const struct lim_sorter *sorter, uint16_t entry);

#endif
