/* SPDX-License-Identifier: MIT
 *
 * Every record that faces the eye becomes an entry, whatever the tree says. */
#include "pieces/sorted.h"

#include "eye.h"
#include "pieces/newell.h"
#include "pieces/sorter.h"
#include "view/pass.h"
#include "view/transform.h"

#if LIM_HAS_SORTED

/* What bounds a record along z: the row of z alone, before a long lens's bits are shifted out. */
static void depth_bounds(const struct lim_pass *pass, const LIM_FLASH lim_index *record, int32_t *near_qv,
                         int32_t *far_qv)
{
    const LIM_FLASH lim_index *corners = record + LIM_POLYGON_HEAD_WORDS;

    *near_qv = INT32_MAX;
    *far_qv = INT32_MIN;
    for (uint_fast8_t k = 0; k < (record[0] & LIM_POLYGON_COUNT); k++) {
        const struct lim_vertex at = pass->scene->vertices[corners[k]];
        const int32_t z_qv = transform_row(&pass->view.rows.row[2], &at);
        if (z_qv < *near_qv) *near_qv = z_qv;
        if (z_qv > *far_qv) *far_qv = z_qv;
    }
}

static void add(struct lim_sorter *sorter, lim_index at, lim_index node, bool eye_in_front)
{
    const struct lim_rows *rows = &sorter->pass->view.rows;
    struct lim_sorted *entry = &sorter->list[sorter->used];
    int32_t near_qv;

    LIM_DEBUG_ASSERT(sorter->used < sorter->size);
    *entry = (struct lim_sorted){.record = at, .next = sorter->first};
    depth_bounds(sorter->pass, &sorter->pass->scene->polygons[at], &near_qv, &entry->far_qv);
    if ((LIM_HAS_LIMBS ? entry->far_qv : entry->far_qv >> rows->tele_bits) < rows->near_qv) return;
    if (LIM_HAS_NEWELL && LIM_IS_NEWELL(&sorter->pass->target) &&
        !lim_newell_add(sorter, sorter->used, near_qv, node, eye_in_front))
        return;
    sorter->first = sorter->used++;
}

static void sorted_add_run(struct lim_sorter *sorter, lim_index at, lim_index node, bool eye_in_front)
{
    for (;;) {
        const LIM_FLASH lim_index *record = &sorter->pass->scene->polygons[at];
        const lim_index head = record[0];
        if (lim_record_is_seen(lim_eye_of(sorter->pass), record))
            add(sorter, at, node, head & LIM_POLYGON_PLANE ? !(head & LIM_POLYGON_BACK) : eye_in_front);
        if (head & LIM_POLYGON_LAST) return;
        at = (lim_index)(at + lim_record_words(head));
    }
}

static void add_all(struct lim_sorter *sorter)
{
    for (lim_index i = 0; i < sorter->pass->scene->node_count; i++) {
        const LIM_FLASH struct lim_node *node = &sorter->pass->scene->nodes[i];
        const bool is_leaf = lim_node_is_leaf(node);
        const int32_t side = is_leaf ? 1 : lim_eye_side(lim_eye_of(sorter->pass), &node->split);
        const lim_index run = side > 0 ? node->front_run : side < 0 ? node->back_run : (lim_index)LIM_NO_INDEX;
        if (run != LIM_NO_INDEX) sorted_add_run(sorter, run, i, side > 0);
    }
}

void lim_sorted_order(struct lim_sorter *sorter)
{
    const bool is_newell = LIM_IS_NEWELL(&sorter->pass->target);

    sorter->used = 0;
    sorter->first = LIM_NONE;
    if (LIM_HAS_NEWELL) sorter->newell->cuts_used = 0;
    add_all(sorter);
    sorter->first = lim_sorted_sort(sorter->list, sorter->first);
    if (LIM_HAS_NEWELL && is_newell)
        lim_newell_order(sorter);
    else
        lim_sorted_reverse(sorter);
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->sorted = sorter->used;
}

#endif
