/* SPDX-License-Identifier: MIT
 *
 * A k-d tree that is nothing but an order of the points: the middle of a range divides it along the
 * axis of its depth (x, y, z, x, ...), smaller coordinates before it. Ties are broken by index, so
 * the order depends on the points alone. */
#include "base/point_tree.h"

#include "base/grow.h"
#include "base/vec3.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { LEAF = 8 }; /* ranges this short are searched through */

static bool comes_before(double (*points)[3], int axis, uint32_t p, uint32_t q)
{
    double a = points[p][axis], b = points[q][axis];
    return a < b || (a == b && p < q);
}

static void swap(uint32_t *a, uint32_t *b)
{
    uint32_t kept = *a;
    *a = *b;
    *b = kept;
}

/* Puts the median of the first, middle and last point into the middle. */
static void choose_pivot(double (*points)[3], int axis, uint32_t *first, uint32_t *middle, uint32_t *last)
{
    if (comes_before(points, axis, *middle, *first)) swap(middle, first);
    if (comes_before(points, axis, *last, *middle)) swap(last, middle);
    if (comes_before(points, axis, *middle, *first)) swap(middle, first);
}

/* Hoare's selection: afterwards order[middle] is where sorting would put it, smaller ones before. */
static void select_middle(const struct point_tree *tree, int axis, size_t low, size_t high, size_t middle)
{
    uint32_t *order = tree->order;
    while (high - low > 1) {
        uint32_t *pivot_at = &order[low + (high - low) / 2];
        choose_pivot(tree->points, axis, &order[low], pivot_at, &order[high - 1]);
        uint32_t pivot = *pivot_at;
        size_t i = low, end = high; /* order[low..i) <= pivot <= order[end..high) */
        while (i < end) {
            while (comes_before(tree->points, axis, order[i], pivot))
                i++;
            while (comes_before(tree->points, axis, pivot, order[end - 1]))
                end--;
            if (i < end) swap(&order[i++], &order[--end]);
        }
        if (middle < end)
            high = end;
        else if (middle >= i)
            low = i;
        else
            return; /* a single point between the two parts: it is in its place */
    }
}

static void build(const struct point_tree *tree, int axis, size_t low, size_t high)
{
    if (high - low <= LEAF) return;
    size_t middle = low + (high - low) / 2;
    select_middle(tree, axis, low, high, middle);
    build(tree, (axis + 1) % 3, low, middle);
    build(tree, (axis + 1) % 3, middle + 1, high);
}

void point_tree_build(struct point_tree *tree, double (*points)[3], const uint32_t *chosen, size_t count)
{
    *tree = (struct point_tree){.points = points, .order = grow_zeroed(count, sizeof *chosen), .count = count};
    memcpy(tree->order, chosen, count * sizeof *chosen);
    build(tree, 0, 0, count);
}

void point_tree_free(struct point_tree *tree)
{
    free(tree->order);
    *tree = (struct point_tree){0};
}

struct search {
    const struct point_tree *tree;
    const double *a, *b; /* the segment */
    double radius;
    point_tree_visitor *visit;
    void *context;
};

static void try_point(const struct search *search, uint32_t point)
{
    const double *p = search->tree->points[point];
    if (vec3_segment_distance2(search->a, search->b, p) < search->radius * search->radius)
        search->visit(search->context, point);
}

/* Narrows the part t[0]..t[1] of the segment to where it may see points below (or above) `limit` on
 * one axis. Twice the radius, so that rounding cannot lose a point. false: nothing is left. */
static bool narrow(const struct search *search, int axis, double limit, bool below, double t[2])
{
    double from = search->a[axis], along = search->b[axis] - from;
    double reach = limit + (below ? 2 : -2) * search->radius;
    if (along == 0) return below ? from <= reach : from >= reach;
    double at = (reach - from) / along;
    if (below == (along > 0)) {
        if (at < t[1]) t[1] = at;
    } else {
        if (at > t[0]) t[0] = at;
    }
    return t[0] <= t[1];
}

static void near(const struct search *search, int axis, size_t low, size_t high, double t0, double t1)
{
    const uint32_t *order = search->tree->order;
    if (high - low <= LEAF) {
        for (size_t i = low; i < high; i++)
            try_point(search, order[i]);
        return;
    }
    size_t middle = low + (high - low) / 2;
    double limit = search->tree->points[order[middle]][axis];
    double lower[2] = {t0, t1}, upper[2] = {t0, t1};
    try_point(search, order[middle]);
    if (narrow(search, axis, limit, true, lower)) near(search, (axis + 1) % 3, low, middle, lower[0], lower[1]);
    if (narrow(search, axis, limit, false, upper)) near(search, (axis + 1) % 3, middle + 1, high, upper[0], upper[1]);
}

void point_tree_near(const struct point_tree *tree, const double a[3], const double b[3], double radius,
                     point_tree_visitor *visit, void *context)
{
    const struct search search = {tree, a, b, radius, visit, context};
    near(&search, 0, 0, tree->count, 0, 1);
}
