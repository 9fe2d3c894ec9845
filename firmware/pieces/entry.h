/* SPDX-License-Identifier: MIT
 *
 * An entry of the sorted list is a polygon of the scene or of an object that moves in it. Here is where its record,
 * its plane and its view are; without movers that is always the scene's, and nothing is asked. */
#ifndef LIM_ENTRY_H
#define LIM_ENTRY_H

#include "orders/order.h"

#if LIM_HAS_PIECES

/* The mover that an entry is a part of, or LIM_NONE. */
static inline uint16_t lim_entry_owner(const struct lim *lim, uint16_t entry)
{
#if LIM_HAS_MOVERS
    return lim->sorter.newell.polygons[entry].owner;
#else
    (void)lim;
    (void)entry;
    return LIM_NONE;
#endif
}

/* What its record is one of. */
static inline const struct lim_scene *lim_entry_scene(const struct lim *lim, uint16_t entry)
{
#if LIM_HAS_MOVERS
    const uint16_t owner = lim_entry_owner(lim, entry);

    if (owner != LIM_NONE) return lim->movers.instances[owner].object;
#else
    (void)entry;
#endif
    return lim->scene;
}

static inline const LIM_FLASH lim_index *lim_entry_record(const struct lim *lim, uint16_t entry)
{
    return &lim_entry_scene(lim, entry)->polygons[lim->sorter.list[entry].record];
}

/* To transform its vertices. */
static inline const struct lim_view *lim_entry_rows(const struct lim *lim, uint16_t entry)
{
#if LIM_HAS_MOVERS
    const uint16_t owner = lim_entry_owner(lim, entry);

    if (owner != LIM_NONE) return &lim->movers.movers[owner].view;
#else
    (void)entry;
#endif
    return &lim->view;
}

/* To project it: the cache holds no others' vertices. */
static inline struct lim_view *lim_entry_view(struct lim *lim, uint16_t entry)
{
#if LIM_HAS_MOVERS
    const uint16_t owner = lim_entry_owner(lim, entry);

    if (owner != LIM_NONE) return lim_mover_view(lim, owner);
#else
    (void)entry;
#endif
    return &lim->view;
}

#endif

#endif
