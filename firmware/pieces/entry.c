/* SPDX-License-Identifier: MIT
 *
 * Planes of entries: of a record, of a node, or of corners that move. */
#include "pieces/entry.h"

#include "movers/deform.h"

#if LIM_HAS_PIECES

static const LIM_FLASH struct lim_plane_ref no_plane = {LIM_NO_INDEX, 0};

/* Of a mesh leaf, and not the plane of a node. */
static bool is_of_mesh_leaf(const struct lim_sorter *sorter, uint16_t entry)
{
    const lim_index node = sorter->newell->polygons[entry].node;

    return sorter->list[entry].record != LIM_NO_INDEX && node != LIM_NO_INDEX &&
           lim_node_is_leaf(&lim_entry_scene(sorter, entry)->nodes[node]) &&
           !(lim_entry_record(sorter, entry)[0] & LIM_POLYGON_PLANE);
}

bool lim_plane_is_of_corners(const struct lim_sorter *sorter, uint16_t entry)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);

    if (LIM_HAS_DEFORM && owner != LIM_NONE && lim_deforms(&sorter->movers->instances[owner])) return true;
    return LIM_HAS_MESH_LEAVES && LIM_HAS_MOVERS && is_of_mesh_leaf(sorter, entry);
}

const LIM_FLASH struct lim_plane_ref *lim_plane_of(const struct lim_sorter *sorter, uint16_t entry)
{
    const struct lim_scene *scene = lim_entry_scene(sorter, entry);

    if (LIM_HAS_CORNER_PLANES && lim_plane_is_of_corners(sorter, entry)) return &no_plane;
    if (!LIM_HAS_MOVERS || sorter->list[entry].record != LIM_NO_INDEX) {
        const LIM_FLASH lim_index *record = lim_entry_record(sorter, entry);
        if (LIM_HAS_LEAVES && record[0] & LIM_POLYGON_PLANE) return lim_record_plane(record);
    }
    return &scene->nodes[sorter->newell->polygons[entry].node].split;
}

void lim_plane_load_own(struct lim_plane_unpacked *plane, const struct lim_sorter *sorter, uint16_t entry)
{
    if (LIM_HAS_CORNER_PLANES && lim_plane_is_of_corners(sorter, entry))
        (void)lim_deform_plane(plane, lim_entry_scene(sorter, entry), lim_entry_record(sorter, entry));
    else
        lim_plane_unpack(plane, lim_entry_scene(sorter, entry), lim_plane_of(sorter, entry));
}

void lim_plane_load(struct lim_plane_unpacked *plane, const struct lim_sorter *sorter, uint16_t entry)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);

    if (LIM_HAS_FAR_MOVERS && owner == LIM_NONE && lim_movers_are_far(sorter->movers)) {
        lim_plane_unpack_far(plane, *sorter->movers->far, lim_plane_of(sorter, entry));
        return;
    }
    if (!LIM_HAS_MOVERS || owner == LIM_NONE) {
        lim_plane_load_own(plane, sorter, entry);
    } else if (LIM_OPTIMISE_SIZE || (LIM_HAS_CORNER_PLANES && lim_plane_is_of_corners(sorter, entry))) {
        lim_plane_load_own(plane, sorter, entry);
        lim_mover_turn(sorter->movers, owner, plane);
    } else {
        *plane = *lim_mover_plane(sorter->movers, owner, lim_plane_of(sorter, entry), entry);
    }
}

#endif
