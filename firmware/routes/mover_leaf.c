/* SPDX-License-Identifier: MIT
 *
 * Polygons of a leaf, whose order knows nothing of movers, are sorted together with them (mover_order.c). A mesh leaf
 * has too many for that. There each mover comes before or after all of the leaf, as a plane between both boxes tells;
 * where there is none, as their middles do. */
#include "routes/mover_leaf.h"

#include "movers/mover.h"
#include "pieces/entry.h"
#include "routes/mover_list.h"
#include "routes/route.h"

#if LIM_HAS_MOVERS

static void count_unsorted(struct lim_sorter *sorter)
{
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.unsorted++;
}

/* Both sorted together, or else movers are taken for nearer. */
static void join(struct lim_route *route, lim_index run)
{
    const uint16_t list = route->list;

    if (lim_movers_join(route->sorter, run, list)) {
        route->next = LIM_NO_INDEX;
        return;
    }
    count_unsorted(route->sorter);
    if (route->back_to_front) route->list = LIM_NONE;
    lim_route_go_through_leaf(route, route->back_to_front ? list : (uint16_t)LIM_NONE);
}

/* Mesh leaves ------------------------------------------------------------------------------------------------------ */

/* Along the static scene's axes. */
struct span_q12 {
    int32_t low, high;
};

static struct span_q12 leaf_span(const LIM_FLASH struct lim_box *box, uint_fast8_t axis)
{
    return (struct span_q12){(box->centre[axis] - (int32_t)box->half[axis]) * INT32_C(4096),
                             (box->centre[axis] + (int32_t)box->half[axis]) * INT32_C(4096)};
}

/* One that enters by its centre is a point. */
static struct span_q12 mover_span(const struct lim_movers *movers, uint16_t mover, uint_fast8_t axis)
{
    const int32_t centre = movers->movers[mover].centre_q12[axis];
    const int32_t half = movers->instances[mover].by_centre ? 0 : movers->movers[mover].half_q12[axis];

    return (struct span_q12){centre - half, centre + half};
}

static bool middle_is_nearer(const struct lim_movers *movers, uint16_t mover, const LIM_FLASH struct lim_box *box)
{
    const int32_t at_q12[3] = {box->centre[0] * INT32_C(4096), box->centre[1] * INT32_C(4096),
                               box->centre[2] * INT32_C(4096)};

    return lim_mover_depth(movers, movers->movers[mover].centre_q12) <= lim_mover_depth(movers, at_q12);
}

/* Whether the mover comes before the leaf, nearest first. An eye between two planes is on both sides: either may. */
static bool is_before_leaf(struct lim_sorter *sorter, uint16_t mover, const LIM_FLASH struct lim_box *box)
{
    const struct lim_movers *movers = sorter->movers;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const struct span_q12 leaf = leaf_span(box, i), own = mover_span(movers, mover, i);
        const int32_t eye_q8 = movers->camera.eye_q8[i];
        if (own.low >= leaf.high) return eye_q8 >= leaf.high >> 4;
        if (own.high <= leaf.low) return eye_q8 <= leaf.low >> 4;
    }
    count_unsorted(sorter);
    return middle_is_nearer(movers, mover, box);
}

static LIM_IF_CALLED void part_from_mesh_leaf(struct lim_route *route, const LIM_FLASH lim_index *run)
{
    struct lim_sorter *const sorter = route->sorter;
    const LIM_FLASH struct lim_box *box = &route->scene->boxes[lim_mesh_leaf_words(run)[LIM_MESH_LEAF_BOX]];
    uint16_t list = route->list, near, far;
    struct lim_queue nearer = lim_queue_begin(sorter, &near), farther = lim_queue_begin(sorter, &far);

    while (list != LIM_NONE) {
        const uint16_t entry = list;
        list = sorter->list[entry].next;
        lim_queue_add(is_before_leaf(sorter, lim_entry_owner(sorter, entry), box) ? &nearer : &farther, entry);
    }
    route->list = route->back_to_front ? far : near;
    lim_route_go_through_leaf(route, route->back_to_front ? near : far);
}

void lim_movers_enter_leaf(struct lim_route *route, lim_index run)
{
    const LIM_FLASH lim_index *first = &route->scene->polygons[run];

    if (LIM_HAS_MESH_LEAVES && lim_is_mesh_leaf(first))
        part_from_mesh_leaf(route, first);
    else
        join(route, run);
}

#endif
