/* SPDX-License-Identifier: MIT
 *
 * T-vertices: corners of other polygons that lie within an edge. Each edge is divided in the
 * direction from its lower point to its higher one, so that all polygons along it get the same
 * vertices. The parts are divided again, since they are a trifle off the whole; that ends because
 * points are at least weld_m apart, near_m is half of that, and so every part is shorter. */
#include "base/deadline.h"
#include "base/grow.h"
#include "base/point_tree.h"
#include "base/progress.h"
#include "base/vec3.h"
#include "model/inner.h"
#include "model/loop.h"
#include "model/mesh.h"
#include "model/polygon_list.h"

#include "model/grid.h"
#include <stdlib.h>
#include <string.h>

struct hit {
    double at; /* along the edge, 0..1 */
    uint32_t point;
};

struct inserting {
    struct mesh *mesh;
    struct point_tree tree;
    double near_m;
    uint32_t a, b;    /* the edge being searched */
    struct hit *hits; /* a stack: nested edges put theirs on top */
    size_t hit_count, hit_capacity;
    uint32_t *loop; /* the polygon as it will be */
    size_t loop_count, loop_capacity;
};

static void add_hit(void *context, uint32_t point)
{
    struct inserting *inserting = context;
    double(*points)[3] = inserting->mesh->points;
    if (point == inserting->a || point == inserting->b) return;
    double at = vec3_foot(points[inserting->a], points[inserting->b], points[point]);
    if (at <= 0 || at >= 1) return;
    inserting->hits = grow(inserting->hits, inserting->hit_count, &inserting->hit_capacity, sizeof *inserting->hits);
    inserting->hits[inserting->hit_count++] = (struct hit){at, point};
}

static int by_position(const void *left, const void *right)
{
    const struct hit *a = left, *b = right;
    int order = (a->at > b->at) - (a->at < b->at);
    return order ? order : (a->point > b->point) - (a->point < b->point);
}

static void add_to_loop(struct inserting *inserting, uint32_t point)
{
    inserting->loop = grow(inserting->loop, inserting->loop_count, &inserting->loop_capacity, sizeof *inserting->loop);
    inserting->loop[inserting->loop_count++] = point;
}

/* Appends the points strictly between a and b. */
static void divide(struct inserting *inserting, uint32_t a, uint32_t b)
{
    double(*points)[3] = inserting->mesh->points;
    size_t base = inserting->hit_count;
    inserting->a = a, inserting->b = b;
    point_tree_near(&inserting->tree, points[a], points[b], inserting->near_m, add_hit, inserting);
    size_t count = inserting->hit_count - base;
    if (count == 0) return;
    qsort(&inserting->hits[base], count, sizeof *inserting->hits, by_position);
    uint32_t from = a;
    for (size_t i = 0; i < count; i++) {
        uint32_t point = inserting->hits[base + i].point;
        inner_divide(inserting->mesh, from, point, b);
        divide(inserting, from, point);
        add_to_loop(inserting, point);
        from = point;
    }
    divide(inserting, from, b);
    inserting->hit_count = base;
}

static void reverse(uint32_t *items, size_t count)
{
    for (size_t i = 0; i < count / 2; i++) {
        uint32_t kept = items[i];
        items[i] = items[count - 1 - i];
        items[count - 1 - i] = kept;
    }
}

static void split_edge(struct inserting *inserting, uint32_t a, uint32_t b)
{
    add_to_loop(inserting, a);
    size_t first = inserting->loop_count;
    divide(inserting, a < b ? a : b, a < b ? b : a);
    if (a > b) reverse(&inserting->loop[first], inserting->loop_count - first);
}

/* Where a polygon is a needle, both its sides may get the same vertex: the tip beyond falls away,
 * as the neighbours on either side have it between themselves now. */
static size_t drop_needle_tips(uint32_t *loop, size_t count)
{
    for (size_t i = 0; i < count && count >= 3;) {
        size_t next = (i + 1) % count;
        if (loop[(i + count - 1) % count] != loop[next]) {
            i++;
            continue;
        }
        size_t low = i < next ? i : next, high = i < next ? next : i;
        memmove(&loop[high], &loop[high + 1], (count - high - 1) * sizeof *loop);
        memmove(&loop[low], &loop[low + 1], (count - low - 2) * sizeof *loop);
        count -= 2;
        i = 0;
    }
    return count;
}

static void insert_into(struct inserting *inserting, const struct mesh_polygon *polygon, struct polygon_list *list)
{
    const uint32_t *corners = &inserting->mesh->corners[polygon->first];
    inserting->loop_count = 0;
    for (uint32_t k = 0; k < polygon->count; k++)
        split_edge(inserting, corners[k], corners[(k + 1) % polygon->count]);
    inserting->mesh->counts.t_vertices += inserting->loop_count - polygon->count;
    size_t count = drop_needle_tips(inserting->loop, inserting->loop_count);
    if (count >= 3) polygon_list_add(list, inserting->loop, count, polygon);
}

/* Only corners count: a point that welding or merging left over needs no vertex. */
static void build_tree(struct inserting *inserting)
{
    const struct mesh *mesh = inserting->mesh;
    bool *is_corner = grow_zeroed(mesh->point_count, sizeof *is_corner);
    uint32_t *chosen = grow_zeroed(mesh->point_count, sizeof *chosen);
    size_t count = 0;
    for (size_t i = 0; i < mesh->corner_count; i++)
        is_corner[mesh->corners[i]] = true;
    for (size_t i = 0; i < mesh->point_count; i++)
        if (is_corner[i]) chosen[count++] = (uint32_t)i;
    point_tree_build(&inserting->tree, mesh->points, chosen, count);
    free(is_corner);
    free(chosen);
}

bool mesh_insert_t_vertices(struct mesh *mesh, struct error *err)
{
    struct inserting inserting = {.mesh = mesh, .near_m = grid_near_m(&mesh->grid)};
    struct polygon_list list = {0};
    mesh->counts.t_vertices = 0;
    build_tree(&inserting);
    for (size_t i = 0; i < mesh->polygon_count && !deadline_passed(); i++) {
        progress_bar(i, mesh->polygon_count, "vertices on edges");
        insert_into(&inserting, &mesh->polygons[i], &list);
    }
    progress_end();
    point_tree_free(&inserting.tree);
    free(inserting.hits);
    free(inserting.loop);
    return polygon_list_move(&list, mesh, err) && deadline_check(err, "vertices were still sought on edges");
}
