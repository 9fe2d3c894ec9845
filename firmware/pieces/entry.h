/* SPDX-License-Identifier: MIT
 *
 * An entry of the sorted list is a polygon of the scene or of an object that moves in it. Here is where its record,
 * its plane and its view are; without movers that is always the scene's, and nothing is asked. */
#ifndef LIM_ENTRY_H
#define LIM_ENTRY_H

#include "movers/mover.h"
#include "movers/mover_long.h"
#include "view/pass.h"

/* The mover that an entry is a part of, or LIM_NONE. */
static inline uint16_t lim_entry_owner(const struct lim_sorter *sorter, uint16_t entry)
{
    return LIM_HAS_MOVERS ? sorter->newell->polygons[entry].owner : (uint16_t)LIM_NONE;
}

/* In a long scene, for what is asked of a mover's corners: brings the plane of entry `by` to the frame of mover `to`.
 */
static inline void lim_plane_load_far(struct lim_plane_unpacked *plane, const struct lim_sorter *sorter, uint16_t by,
                                      uint16_t to)
{
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(sorter->movers))
        lim_plane_bring(plane, sorter->movers, lim_entry_owner(sorter, by), to);
}

/* What its record is one of. */
static inline const struct lim_scene *lim_entry_scene(const struct lim_sorter *sorter, uint16_t entry)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);

    return LIM_HAS_MOVERS && owner != LIM_NONE ? sorter->movers->instances[owner].object : sorter->pass->scene;
}

static inline const LIM_FLASH lim_index *lim_entry_record(const struct lim_sorter *sorter, uint16_t entry)
{
    return &lim_entry_scene(sorter, entry)->polygons[sorter->list[entry].record];
}

/* To transform its vertices. */
static inline const struct lim_view *lim_entry_rows(const struct lim_sorter *sorter, uint16_t entry)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);

    return LIM_HAS_MOVERS && owner != LIM_NONE ? &sorter->movers->movers[owner].view : &sorter->pass->view;
}

/* To project it: the cache holds no others' vertices. */
static inline struct lim_view *lim_entry_view(const struct lim_sorter *sorter, uint16_t entry)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);

    return LIM_HAS_MOVERS && owner != LIM_NONE ? lim_mover_view(sorter->movers, owner) : &sorter->pass->view;
}

/* Whether it is a part of a polygon that was split. */
static inline bool lim_entry_is_cut(const struct lim_sorter *sorter, uint16_t entry)
{
    return sorter->newell->polygons[entry].cuts != LIM_NONE;
}

/* The same of an entry of LIM_NEWELL's list; others' are whole. */
static inline bool lim_entry_is_split(const struct lim_sorter *sorter, uint16_t entry)
{
    return LIM_IS_NEWELL(&sorter->pass->target) && lim_entry_is_cut(sorter, entry);
}

#endif
