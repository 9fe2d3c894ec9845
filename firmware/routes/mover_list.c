/* SPDX-License-Identifier: MIT
 *
 * Lists of one instance's polygons keep the order of its own tree, nearest first. Nothing is given back before the next
 * walk. */
#include "routes/mover_list.h"

#include "eye.h"
#include "movers/deform.h"
#include "movers/mover_long.h"
#include "pieces/entry.h"
#include "pieces/mesh_leaf.h"
#include "routes/mover_part.h"
#include "routes/route.h"
#include "view/cull.h"

#if LIM_HAS_MOVERS

void lim_movers_note_entries(struct lim_sorter *sorter)
{
    const uint16_t used = sorter->used > sorter->newell->cuts_used ? sorter->used : sorter->newell->cuts_used;

    if (LIM_HAS_STATS && used > lim_stats_of(sorter->pass)->movers.entries)
        lim_stats_of(sorter->pass)->movers.entries = used;
}

uint16_t lim_entry_new(struct lim_sorter *sorter, lim_index record, uint16_t owner, lim_index node)
{

    if (sorter->used == sorter->size) return LIM_NONE;
    sorter->list[sorter->used] = (struct lim_sorted){.record = record, .next = LIM_NONE};
    sorter->newell->polygons[sorter->used] =
        (struct lim_newell_polygon){.node = node, .cuts = LIM_NONE, .owner = owner};
    sorter->used++;
    lim_movers_note_entries(sorter);
    return (uint16_t)(sorter->used - 1);
}

/* Whether the box around it, as far as the grid reaches, is in view. */
static bool is_in_view(const struct lim_mover *mover, const struct lim_cull *open, bool is_far)
{
    struct lim_box box;

    if (!LIM_HAS_CULL) return true;
    if (LIM_HAS_FAR_MOVERS && is_far) {
        lim_mover_far_box(mover, &box);
        return lim_cull_sees(open, &box);
    }
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t centre = mover->centre_q12[i] >> 12, half = (mover->half_q12[i] >> 12) + 2;
        if (centre < -32768 || centre > 32767 || half > 32768) return true;
        box.centre[i] = (int16_t)centre;
        box.half[i] = (uint16_t)half;
    }
    return lim_cull_sees(open, &box);
}

uint16_t lim_movers_list(struct lim_sorter *sorter, const struct lim_cull *open)
{
    struct lim_movers *movers = sorter->movers;
    uint16_t head;
    struct lim_queue queue = lim_queue_begin(sorter, &head);
    const bool is_far = LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers);

    sorter->used = 0;
    sorter->newell->cuts_used = 0;
    lim_mover_forget_pieces(movers);
    for (uint16_t i = 0; i < movers->count; i++) {
        if (movers->movers[i].radius_q12 < 0) continue;
        if (is_in_view(&movers->movers[i], open, is_far)) {
            const uint16_t entry = lim_entry_new(sorter, LIM_NO_INDEX, i, LIM_NO_INDEX);
            LIM_DEBUG_ASSERT(entry != LIM_NONE); /* there are as many as instances */
            if (entry != LIM_NONE) lim_queue_add(&queue, entry);
        } else if (LIM_HAS_STATS) {
            lim_stats_of(sorter->pass)->movers.hidden++;
        }
    }
    return head;
}

/* Polygons ----------------------------------------------------------------------------------- */

/* What of a record that faces the eye belongs to a part; NULL: all does. false: no room. */
static bool add_share(struct lim_sorter *sorter, struct lim_queue *queue, const struct lim_part *part, lim_index record,
                      uint16_t mover, lim_index node, bool eye_in_front)
{
    const uint16_t entry = lim_entry_new(sorter, record, mover, node);

    if (entry == LIM_NONE) return false;
    sorter->newell->polygons[entry].eye_in_front = eye_in_front;
    if (part && part->cuts != LIM_NONE && lim_part_take(part, sorter, entry) == LIM_PART_NOTHING)
        sorter->used--;
    else
        lim_queue_add(queue, entry);
    lim_movers_note_entries(sorter);
    return true;
}

/* A mesh leaf: its planes are of corners, which face the eye. */
static LIM_IF_CALLED bool add_mesh_leaf(struct lim_sorter *sorter, struct lim_queue *queue,
                                        const struct lim_route *route, const struct lim_part *part, uint16_t mover,
                                        lim_index run)
{
    const struct lim_mesh_leaf_seen seen = {route->scene, lim_mover_view(sorter->movers, mover), false};
    struct lim_mesh_leaf *const leaf = sorter->movers->leaf;
    const LIM_FLASH lim_index *record;

    lim_mesh_leaf_sort(leaf, &seen, &route->scene->polygons[run]);
    while ((record = lim_mesh_leaf_next(leaf)) != NULL)
        if (!add_share(sorter, queue, part, (lim_index)(record - route->scene->polygons), mover, route->node, true))
            return false;
    return true;
}

/* false: no room. */
static bool add_run(struct lim_sorter *sorter, struct lim_queue *queue, const struct lim_route *route,
                    const struct lim_part *part, uint16_t mover, lim_index at)
{
    if (LIM_HAS_MESH_LEAVES && lim_is_mesh_leaf(&route->scene->polygons[at]))
        return add_mesh_leaf(sorter, queue, route, part, mover, at);
    for (;;) {
        const LIM_FLASH lim_index *record = &route->scene->polygons[at];
        const lim_index head = record[0];
        const bool eye_in_front =
            LIM_HAS_LEAVES && head & LIM_POLYGON_PLANE ? !(head & LIM_POLYGON_BACK) : route->side > 0;
        if (lim_record_is_seen(route->eye, record) &&
            !add_share(sorter, queue, part, at, mover, route->node, eye_in_front))
            return false;
        if (head & LIM_POLYGON_LAST) return true;
        at = (lim_index)(at + lim_record_words(head));
    }
}

/* Every record, wherever in the tree it is: it knows its own plane. */
static LIM_IF_CALLED bool add_deformed(struct lim_sorter *sorter, struct lim_queue *queue, const struct lim_part *part,
                                       uint16_t mover)
{
    const struct lim_scene *object = sorter->movers->instances[mover].object;

    for (lim_index at = 0; at < object->polygon_words;) {
        const LIM_FLASH lim_index *record = &object->polygons[at];
        if (lim_deform_is_seen(&sorter->movers->movers[mover].eye, record) &&
            !add_share(sorter, queue, part, at, mover, 0, true))
            return false;
        at = (lim_index)(at + lim_record_words(record[0]));
    }
    return true;
}

static bool add_by_tree(struct lim_sorter *sorter, struct lim_queue *queue, const struct lim_part *part, uint16_t mover)
{
    const struct lim_rect screen = {0, 0, sorter->pass->target.w_px, sorter->pass->target.h_px};
    struct lim_route route;
    lim_index run;

    lim_route_object(&route, sorter, mover, &screen, false);
    while ((run = lim_route_next_alone(&route)) != LIM_NO_INDEX)
        if (!add_run(sorter, queue, &route, part, mover, run)) return false;
    return true;
}

bool lim_mover_burst(struct lim_sorter *sorter, uint16_t entry, uint16_t *list)
{
    const uint16_t used = sorter->used, cuts_used = sorter->newell->cuts_used, rest = sorter->list[entry].next;
    const uint16_t mover = lim_entry_owner(sorter, entry);
    const bool deforms = lim_deforms(&sorter->movers->instances[mover]);
    uint16_t head;
    struct lim_part part;
    struct lim_queue queue = lim_queue_begin(sorter, &head);

    lim_part_begin(&part, sorter, entry);
    const bool has_room = LIM_HAS_DEFORM && deforms ? add_deformed(sorter, &queue, &part, mover)
                                                    : add_by_tree(sorter, &queue, &part, mover);

    if (!has_room) {
        sorter->used = used;
        sorter->newell->cuts_used = cuts_used;
        return false;
    }
    *(queue.last == LIM_NONE ? &head : &sorter->list[queue.last].next) = rest;
    *list = head;
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.divided++;
    return true;
}

static bool has_centres(const struct lim_sorter *sorter, uint16_t list)
{
    for (; list != LIM_NONE; list = sorter->list[list].next)
        if (lim_mover_is_whole(sorter, list) && sorter->movers->instances[lim_entry_owner(sorter, list)].by_centre)
            return true;
    return false;
}

bool lim_movers_join(struct lim_sorter *sorter, lim_index run, uint16_t list)
{
    const struct lim_route leaf = {.scene = sorter->pass->scene, .eye = lim_eye_of(sorter->pass), .node = LIM_NO_INDEX};
    const uint16_t used = sorter->used;
    uint16_t head, last = list;
    struct lim_queue queue = lim_queue_begin(sorter, &head);

    if (has_centres(sorter, list)) return false;
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(sorter->movers)) return false; /* these have no frame */
    if (!add_run(sorter, &queue, &leaf, NULL, LIM_NONE, run)) {
        sorter->used = used;
        return false;
    }
    while (sorter->list[last].next != LIM_NONE)
        last = sorter->list[last].next;
    sorter->list[last].next = head;
    return true;
}

#endif
