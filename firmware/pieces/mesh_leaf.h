/* SPDX-License-Identifier: MIT
 *
 * MESH LEAF: a dense part of a tree that no planes divide (SCENE.md), or a dense object that moves. Its vertices are
 * projected once; polygons whose corners run counter-clockwise on the screen are sorted by the mean nearness of these;
 * then they come one by one, in the order of drawing. That is not exact, as LIM_MESH is not; edges are, as everywhere.
 * In: a mesh leaf's run, a view. Memory: LIM_MESH_LEAF_MEM_B(), lent. */
#ifndef LIM_MESH_LEAF_H
#define LIM_MESH_LEAF_H

#include "orders.h"
#include "view/view.h"

static inline size_t lim_mesh_leaf_mem_b(const struct lim_limits *limits)
{
    return LIM_HAS_MESH_LEAVES ? LIM_MESH_LEAF_MEM_B(limits->leaf_vertices, limits->leaf_polygons) : 0;
}

void lim_mesh_leaf_lend(struct lim_mesh_leaf *leaf, void *mem, const struct lim_limits *limits);

/* Sorts the leaf whose run begins with this record; `seen` is copied. Where entries are too few for all that faces the
 * eye, it is sorted in parts, while it is drawn: dearer, and the same order. */
void lim_mesh_leaf_sort(struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                        const LIM_FLASH lim_index *run);

/* The record that is next in the order of drawing, or NULL. */
const LIM_FLASH lim_index *lim_mesh_leaf_next(struct lim_mesh_leaf *leaf);

/* A record's n corners on the screen. false: some of it has to be clipped, or may have to be; lim_project() can tell.
 */
static inline bool lim_mesh_leaf_corners(const struct lim_mesh_leaf *leaf, const LIM_FLASH lim_index *record, uint8_t n,
                                         struct lim_point *at)
{
    const LIM_FLASH lim_index *corners = record + LIM_POLYGON_HEAD_WORDS;

    for (uint_fast8_t k = 0; k < n; k++) {
        const lim_index vertex = (lim_index)(corners[k] - leaf->first);
        if (leaf->extent == LIM_VIEW_CLIPPED && !leaf->nearness[vertex]) return false;
        at[k] = leaf->points[vertex];
    }
    return true;
}

/* A record's polygon, as lim_project() has it. false: nothing of it can be inside `open`. */
bool lim_mesh_leaf_project(struct lim_screen_polygon *out, const struct lim_mesh_leaf *leaf,
                           const LIM_FLASH lim_index *record, const struct lim_rect *open, struct lim_stats *stats);

#endif
