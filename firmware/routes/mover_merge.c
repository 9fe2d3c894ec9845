/* SPDX-License-Identifier: MIT
 *
 * Newell's sort compares all polygons of two objects with each other; a tree asks each plane once. */
#include "routes/mover_merge.h"

#include "movers/deform.h"
#include "movers/mover_long.h"
#include "pieces/entry.h"
#include "routes/mover_list.h"
#include "routes/mover_route.h"
#include "routes/route.h"

#if LIM_HAS_MOVERS

/* More nodes cut the others into too many parts. */
enum { NODES_MAX = 24 };

/* Whether all of an object is in its nodes' planes. */
static bool has_leaves(const struct lim_scene *object)
{
    for (lim_index i = 0; LIM_HAS_LEAVES && i < object->node_count; i++)
        if (lim_node_is_leaf(&object->nodes[i])) return true;
    return false;
}

/* The one with the fewest nodes; LIM_NONE: none. What deforms is sorted by its polygons, and is best left as a whole.
 */
static uint16_t choose_one(const struct lim_sorter *sorter, uint16_t list)
{
    uint16_t chosen = LIM_NONE;
    lim_index least = NODES_MAX + 1;

    for (; list != LIM_NONE; list = sorter->list[list].next) {
        const struct lim_instance *instance = &sorter->movers->instances[lim_entry_owner(sorter, list)];
        if (instance->by_centre || lim_deforms(instance)) return LIM_NONE;
        if (instance->object->node_count >= least || has_leaves(instance->object)) continue;
        if (LIM_HAS_FAR_MOVERS && lim_mover_is_remote(&sorter->movers->movers[lim_entry_owner(sorter, list)])) continue;
        chosen = list;
        least = instance->object->node_count;
    }
    return chosen;
}

static uint16_t last_entry(const struct lim_sorter *sorter, uint16_t list)
{
    while (sorter->list[list].next != LIM_NONE)
        list = sorter->list[list].next;
    return list;
}

/* Moves what lies in a node's plane from one list to the end of another. */
static void move_run(struct lim_sorter *sorter, uint16_t *from, lim_index node, struct lim_queue *to)
{
    while (*from != LIM_NONE && sorter->newell->polygons[*from].node == node) {
        const uint16_t entry = *from;
        *from = sorter->list[entry].next;
        lim_queue_add(to, entry);
    }
}

static void append(struct lim_sorter *sorter, struct lim_queue *to, uint16_t list)
{
    if (list == LIM_NONE) return;
    const uint16_t last = last_entry(sorter, list);
    *(to->last == LIM_NONE ? to->head : &sorter->list[to->last].next) = list;
    to->last = last;
}

bool lim_movers_merge(struct lim_sorter *sorter, uint16_t *list)
{
    const struct lim_rect screen = {0, 0, sorter->pass->target.w_px, sorter->pass->target.h_px};
    const uint16_t one = choose_one(sorter, *list);
    uint16_t others, polygons = one, merged;
    struct lim_queue queue = lim_queue_begin(sorter, &others), ordered = lim_queue_begin(sorter, &merged);
    struct lim_route route;
    lim_index what;

    if (one == LIM_NONE) return false;
    const uint16_t after = sorter->list[one].next;
    sorter->list[one].next = LIM_NONE;
    if (!lim_mover_burst(sorter, one, &polygons)) {
        sorter->list[one].next = after;
        return false;
    }
    sorter->list[one].next = after;
    for (uint16_t at = *list, next; at != LIM_NONE; at = next) {
        next = sorter->list[at].next;
        if (at != one) lim_queue_add(&queue, at);
    }
    lim_route_object(&route, sorter, lim_entry_owner(sorter, one), &screen, false);
    lim_route_begin(&route, others);
    for (enum lim_route_event event; (event = lim_route_next(&route, &what)) != LIM_ROUTE_END;) {
        if (event == LIM_ROUTE_RUN) {
            move_run(sorter, &polygons, route.node, &ordered);
            continue;
        }
        append(sorter, &ordered, (uint16_t)what);
        sorter->newell->polygons[ordered.last].last = true;
    }
    append(sorter, &ordered, polygons);
    *list = merged;
    return true;
}

#endif
