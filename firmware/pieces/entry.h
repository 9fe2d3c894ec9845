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

/* Whether no plane of an entry is stored: it is that of its corners, and no other entry's but of its own pieces. */
bool lim_plane_is_of_corners(const struct lim_sorter *sorter, uint16_t entry);

/* The plane of an entry of the list, in its own scene. Entries without a record stand for the plane of a node. Where it
 * is that of corners the first names none. */
const LIM_FLASH struct lim_plane_ref *lim_plane_of(const struct lim_sorter *sorter, uint16_t entry);
void lim_plane_load_own(struct lim_plane_unpacked *plane, const struct lim_sorter *sorter, uint16_t entry);

/* The same in the static scene. */
void lim_plane_load(struct lim_plane_unpacked *plane, const struct lim_sorter *sorter, uint16_t entry);

/* Brings the plane of entry `by` to the frame of the mover `owner`, or of the scene: LIM_NONE. Only long scenes have
 * such frames. */
static inline void lim_plane_bring_for(struct lim_plane_unpacked *plane, const struct lim_sorter *sorter, uint16_t by,
                                       uint16_t owner)
{
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(sorter->movers))
        lim_plane_bring(plane, sorter->movers, lim_entry_owner(sorter, by), owner);
}

/* The plane of entry `by`, for corners of another entry. */
static inline void lim_plane_load_for(struct lim_plane_unpacked *plane, const struct lim_sorter *sorter, uint16_t by,
                                      uint16_t entry)
{
    lim_plane_load(plane, sorter, by);
    if (LIM_HAS_FAR_MOVERS) lim_plane_bring_for(plane, sorter, by, lim_entry_owner(sorter, entry));
}

#endif
