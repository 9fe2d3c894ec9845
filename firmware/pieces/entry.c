/* SPDX-License-Identifier: MIT
 *
 * Records in leaves name their planes, those in nodes lie in the node's. */
#include "pieces/entry.h"

#include "view/plane_unpacked.h"

#if LIM_HAS_NEWELL

const LIM_FLASH struct lim_plane_ref *lim_plane_of(const struct lim_sorter *sorter, uint16_t entry)
{
    const LIM_FLASH lim_index *record = lim_entry_record(sorter, entry);

    if (LIM_HAS_LEAVES && record[0] & LIM_POLYGON_PLANE) return lim_record_plane(record);
    return &sorter->pass->scene->nodes[sorter->newell->polygons[entry].node].split;
}

void lim_plane_load(struct lim_plane_unpacked *plane, const struct lim_sorter *sorter, uint16_t entry)
{
    lim_plane_unpack(plane, sorter->pass->scene, lim_plane_of(sorter, entry));
}

#endif
