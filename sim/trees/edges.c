/* SPDX-License-Identifier: MIT
 *
 * The table of edges and the order of the points along them. Points of one edge lie exactly on
 * its line, so their order along the line's longest axis is their order. */
#include "trees/edges.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>

#define ABSENT UINT32_MAX

static uint64_t pair_key(uint32_t high, uint32_t low)
{
    return (uint64_t)high << 32 | low;
}

uint32_t edges_add_cut(struct edges *edges, uint32_t a, uint32_t b)
{
    edges->items = grow(edges->items, edges->count, &edges->capacity, sizeof *edges->items);
    edges->items[edges->count] = (struct mesh_edge){{a, b}, true};
    return (uint32_t)edges->count++;
}

uint32_t edges_between(struct edges *edges, uint32_t a, uint32_t b)
{
    uint32_t low = a < b ? a : b, high = a < b ? b : a;
    uint32_t *edge = map_at(&edges->by_ends, pair_key(high, low), ABSENT);
    if (*edge == ABSENT) {
        *edge = edges_add_cut(edges, low, high);
        edges->items[*edge].hidden = false;
    }
    return *edge;
}

/* Cut from the whole edge, not from the part that a piece has: numerators stay short. */
uint32_t edges_cut(struct edges *edges, uint32_t edge, const struct plane *plane, uint32_t plane_index)
{
    uint32_t *point = map_at(&edges->by_plane, pair_key(edge, plane_index), ABSENT);
    if (*point != ABSENT) return *point;
    const uint32_t *ends = edges->items[edge].ends;
    *point = exact_add_crossing(edges->points, ends[0], ends[1], plane);
    edges->cuts = grow(edges->cuts, edges->cut_count, &edges->cut_capacity, sizeof *edges->cuts);
    edges->cuts[edges->cut_count++] = (struct edge_cut){edge, *point, NULL};
    return *point;
}

/* Negative if a comes before b on the way from ends[0] to ends[1]. */
static int along_edge(const struct edges *edges, uint32_t edge, uint32_t a, uint32_t b)
{
    const uint32_t *ends = edges->items[edge].ends;
    const double *from = edges->points->approx[ends[0]], *to = edges->points->approx[ends[1]];
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (fabs(to[k] - from[k]) > fabs(to[axis] - from[axis])) axis = k;
    int order = exact_compare(edges->points, a, b, axis);
    return exact_compare(edges->points, ends[0], ends[1], axis) < 0 ? order : -order;
}

/* For qsort(). Points in the same place, cut by different planes, keep the order of their making. */
static int cut_order(const void *left, const void *right)
{
    const struct edge_cut *a = left, *b = right;
    if (a->edge != b->edge) return a->edge < b->edge ? -1 : 1;
    int order = along_edge(a->edges, a->edge, a->point, b->point);
    if (order) return order;
    return (a->point > b->point) - (a->point < b->point);
}

void edges_sort(struct edges *edges)
{
    for (size_t i = 0; i < edges->cut_count; i++)
        edges->cuts[i].edges = edges;
    if (edges->cut_count) qsort(edges->cuts, edges->cut_count, sizeof *edges->cuts, cut_order);
}

/* The first cut whose edge is not below `edge`. */
static size_t first_cut(const struct edges *edges, uint32_t edge)
{
    size_t low = 0, high = edges->cut_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (edges->cuts[middle].edge < edge)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Twice the place of a point among the cuts first .. end - 1, plus one; the ends come before and
 * after all of them. */
static size_t place_of(const struct edges *edges, uint32_t edge, size_t first, size_t end, uint32_t point)
{
    if (point == edges->items[edge].ends[0]) return 2 * first;
    for (size_t i = first; i < end; i++)
        if (edges->cuts[i].point == point) return 2 * i + 1;
    return 2 * end;
}

struct edge_range edges_between_ends(const struct edges *edges, uint32_t edge, uint32_t a, uint32_t b)
{
    size_t first = first_cut(edges, edge), end = first_cut(edges, edge + 1);
    size_t from = place_of(edges, edge, first, end, a), to = place_of(edges, edge, first, end, b);
    /* Cut i has place 2i + 1: strictly between p < q lie the cuts (p + 1) / 2 .. q / 2 - 1. */
    if (from <= to) return (struct edge_range){(from + 1) / 2, to / 2 - (from + 1) / 2, 1};
    return (struct edge_range){from / 2 - 1, from / 2 - (to + 1) / 2, -1};
}

void edges_free(struct edges *edges)
{
    free(edges->items);
    free(edges->cuts);
    map_free(&edges->by_ends);
    map_free(&edges->by_plane);
    *edges = (struct edges){0};
}
