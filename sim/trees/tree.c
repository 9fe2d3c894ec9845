/* SPDX-License-Identifier: MIT
 *
 * A cut that would leave one side as long as the list was gives way to the plane of a polygon, which takes
 * that polygon out of the list: so every tree ends. */
#include "trees/tree.h"

#include "base/choice.h"

#include "trees/axis_cut.h"
#include "trees/cluster.h"
#include "trees/cluster_cut.h"
#include "trees/dense_cut.h"

#include <stdio.h>
#include <string.h>

/* Without rings a cluster's planes are compared pair by pair; small ones serve where the tree itself shall do the
 * sorting. */
enum { CLUSTER_PIECES_MAX = 4096, CELL_PIECES_MAX = 16 };

/* Of longer lists no relation is found: half a byte for each pair. */
enum { RINGS_PIECES_MAX = 16384 };

const char *const tree_names[TREE_KINDS + 1] = {"auto", "bsp", "clusters", "axis", "octree", "none", "mesh", NULL};

bool tree_kind_parse(const char *text, enum tree_kind *out, struct error *err)
{
    size_t index;
    if (!choice_find(&(struct choice){"--tree", "tree", choice_in_array, tree_names}, text, &index, err)) return false;
    *out = (enum tree_kind)index;
    return true;
}

bool tree_ends(const struct bsp *bsp, enum tree_kind kind, struct rings *rings, const uint32_t *list, size_t count,
               uint32_t *order)
{
    switch (kind) {
    case TREE_NONE:
        memcpy(order, list, count * sizeof *list);
        return true;
    case TREE_CLUSTERS:
        if (rings->hiding.count)
            return !rings_hold(rings, bsp, list, count) && cluster_order(bsp, &rings->hiding, list, count, order);
        return count <= CLUSTER_PIECES_MAX && cluster_order(bsp, NULL, list, count, order);
    case TREE_AXIS:
    case TREE_OCTREE:
        return count <= CELL_PIECES_MAX && cluster_order(bsp, NULL, list, count, order);
    default:
        return false;
    }
}

bool tree_ends_dense(struct bsp *bsp, const struct tree_plan *plan, const uint32_t *list, size_t count)
{
    return dense_count(bsp, plan->parts, list, count) == count && dense_fits(bsp, list, count) &&
           dense_cut_apart(bsp, plan->parts, list, count) == BSP_NONE;
}

/* A polygon's own plane where that is cheaper. */
static uint32_t cut_or_polygon(struct bsp *bsp, const struct splitter *splitter, const uint32_t *list, size_t count)
{
    double cut_cost, polygon_cost;
    const uint32_t cut = axis_cut_best(bsp, splitter, list, count, &cut_cost);
    const uint32_t polygon = splitter_choose(splitter, bsp, list, count, &polygon_cost);
    return cut == BSP_NONE || polygon_cost < cut_cost ? polygon : cut;
}

/* The first polygon and a few at random are heuristics for their own sake. */
bool tree_wants_rings(const struct tree_plan *plan, size_t pieces)
{
    return plan->kind == TREE_CLUSTERS && plan->splitter != &splitters[0] && !plan->splitter->samples &&
           pieces <= RINGS_PIECES_MAX;
}

uint32_t tree_divider(struct bsp *bsp, const struct tree_plan *plan, struct rings *rings, struct bsp_place place,
                      const uint32_t *list, size_t count)
{
    double cost;
    const size_t dense = dense_count(bsp, plan->parts, list, count);
    if (dense && dense < count) return dense_cut_best(bsp, plan->splitter, plan->parts, list, count);
    if (dense) {
        const uint32_t cut = dense_cut_apart(bsp, plan->parts, list, count);
        if (cut != BSP_NONE) return cut; /* else too many for a leaf */
    }
    if (rings->hiding.count) return cluster_cut_best(bsp, plan->splitter, rings, list, count);
    if (plan->kind == TREE_AXIS) return cut_or_polygon(bsp, plan->splitter, list, count);
    if (plan->kind == TREE_OCTREE) {
        const uint32_t cut = axis_cut_halving(bsp, place, list, count);
        if (cut != BSP_NONE) return cut;
    }
    return splitter_choose(plan->splitter, bsp, list, count, &cost);
}
