/* SPDX-License-Identifier: MIT
 *
 * Coplanar neighbours joined, the longest shared edge first. T-vertices are put in before, so that
 * neighbours share whole edges, and straight corners are dropped after: those that another polygon
 * needs come back as T-vertices, for they lie within near_m of the side that lost them. */
#include "base/deadline.h"
#include "base/grow.h"
#include "base/map.h"
#include "base/progress.h"
#include "base/vec3.h"
#include "model/inner.h"
#include "model/loop.h"
#include "model/mapping.h"
#include "model/mesh.h"
#include "model/polygon_list.h"

#include "model/grid.h"
#include <stdlib.h>
#include <string.h>

struct part {
    uint32_t *corners;
    size_t count;  /* 0: it is in another part now */
    uint32_t into; /* which one, or itself */
};

struct shared_edge {
    double length2;
    uint32_t a, b; /* from a to b for `left`, from b to a for `right` */
    uint32_t left, right;
};

struct merging {
    struct mesh *mesh;
    double near_m, flat_m;
    struct part *parts; /* one a polygon */
    struct shared_edge *edges;
    size_t edge_count, edge_capacity;
    uint32_t *joined; /* room for a union */
    size_t joined_capacity;
};

static uint64_t edge_key(uint32_t from, uint32_t to)
{
    return (uint64_t)from << 32 | to;
}

static int by_length(const void *left, const void *right)
{
    const struct shared_edge *a = left, *b = right;
    if (a->length2 != b->length2) return a->length2 < b->length2 ? 1 : -1;
    if (a->a != b->a) return a->a > b->a ? 1 : -1;
    return (a->b > b->b) - (a->b < b->b);
}

static void add_shared_edge(struct merging *merging, uint32_t a, uint32_t b, uint32_t left, uint32_t right)
{
    double(*points)[3] = merging->mesh->points;
    merging->edges = grow(merging->edges, merging->edge_count, &merging->edge_capacity, sizeof *merging->edges);
    merging->edges[merging->edge_count++] =
        (struct shared_edge){vec3_distance2(points[a], points[b]), a, b, left, right};
}

/* Pairs each edge with its reverse; where more than two polygons meet, the first two of them. */
static void find_shared_edges(struct merging *merging)
{
    const struct mesh *mesh = merging->mesh;
    struct map polygon_of = {0};
    for (uint32_t i = 0; i < mesh->polygon_count; i++) {
        const struct part *part = &merging->parts[i];
        for (size_t k = 0; k < part->count; k++)
            map_at(&polygon_of, edge_key(part->corners[k], part->corners[(k + 1) % part->count]), i);
    }
    for (uint32_t i = 0; i < mesh->polygon_count; i++) {
        const struct part *part = &merging->parts[i];
        for (size_t k = 0; k < part->count; k++) {
            uint32_t a = part->corners[k], b = part->corners[(k + 1) % part->count];
            const uint32_t *left = map_find(&polygon_of, edge_key(a, b));
            const uint32_t *right = map_find(&polygon_of, edge_key(b, a));
            if (a < b && *left == i && right && *right != i) add_shared_edge(merging, a, b, i, *right);
        }
    }
    map_free(&polygon_of);
    if (merging->edge_count > 0) qsort(merging->edges, merging->edge_count, sizeof *merging->edges, by_length);
}

static uint32_t part_of(struct part *parts, uint32_t polygon)
{
    while (parts[polygon].into != polygon)
        polygon = parts[polygon].into = parts[parts[polygon].into].into;
    return polygon;
}

static size_t position_of(const struct part *part, uint32_t from, uint32_t to)
{
    for (size_t k = 0; k < part->count; k++)
        if (part->corners[k] == from && part->corners[(k + 1) % part->count] == to) return k;
    return part->count;
}

/* All of `part` but the inner of the edge from its corner k: from k + 1 round to k. */
static void append_from(uint32_t *out, const struct part *part, size_t k, size_t count)
{
    for (size_t i = 0; i < count; i++)
        out[i] = part->corners[(k + 1 + i) % part->count];
}

/* The loop round both parts; 0 if one of them has lost the edge. */
static size_t join(struct merging *merging, const struct shared_edge *edge, const struct part *p, const struct part *q)
{
    size_t in_p = position_of(p, edge->a, edge->b), in_q = position_of(q, edge->b, edge->a);
    if (in_p == p->count || in_q == q->count) return 0;
    size_t count = p->count + q->count - 2;
    while (count > merging->joined_capacity)
        merging->joined =
            grow(merging->joined, merging->joined_capacity, &merging->joined_capacity, sizeof *merging->joined);
    append_from(merging->joined, p, in_p, p->count);
    append_from(&merging->joined[p->count], q, (in_q + 1) % q->count, q->count - 2);
    return count;
}

/* Leaves the union in merging->joined and returns its corners; 0 if it would not be a flat convex
 * polygon. Flatness is judged before tidying, while all corners of both are there. */
static size_t union_of(struct merging *merging, const struct shared_edge *edge, const struct part *p,
                       const struct part *q)
{
    struct loop loop = {merging->mesh->points, NULL, join(merging, edge, p, q)};
    loop.corners = merging->joined;
    if (loop.count == 0 || !loop_has_area(&loop, merging->near_m)) return 0;
    const struct loop_plane plane = loop_plane_of(&loop);
    if (loop_off_plane_m(&loop, &plane) > merging->flat_m) return 0;
    loop.count = loop_tidy(loop.points, merging->joined, loop.count, merging->near_m);
    return loop.count >= 3 && loop_is_convex(&loop, &plane, merging->near_m) ? loop.count : 0;
}

static uint32_t *copy_of(const uint32_t *corners, size_t count)
{
    uint32_t *copy = grow_zeroed(count, sizeof *copy);
    memcpy(copy, corners, count * sizeof *copy);
    return copy;
}

/* Is either's texture right on the other one, too? */
static bool show_the_same(const struct merging *merging, uint32_t left, uint32_t right)
{
    const struct mesh *mesh = merging->mesh;
    const uint32_t a = mesh->polygons[left].mapping, b = mesh->polygons[right].mapping;
    const struct part *p = &merging->parts[left], *q = &merging->parts[right];
    return mapping_agree(mesh, a, b, p->corners, p->count) && mapping_agree(mesh, a, b, q->corners, q->count);
}

static bool try_merge(struct merging *merging, const struct shared_edge *edge)
{
    struct mesh *mesh = merging->mesh;
    uint32_t left = part_of(merging->parts, edge->left), right = part_of(merging->parts, edge->right);
    const struct mesh_polygon *p = &mesh->polygons[left], *q = &mesh->polygons[right];
    if (left == right || p->colour != q->colour || p->transparency != q->transparency || p->two_sided != q->two_sided)
        return false;
    if (!show_the_same(merging, left, right)) return false;
    size_t count = union_of(merging, edge, &merging->parts[left], &merging->parts[right]);
    if (count == 0) return false;
    struct part *kept = &merging->parts[left < right ? left : right];
    struct part *gone = &merging->parts[left < right ? right : left];
    free(kept->corners);
    free(gone->corners);
    *gone = (struct part){.into = left < right ? left : right};
    kept->corners = copy_of(merging->joined, count);
    kept->count = count;
    mesh->counts.merged++;
    return true;
}

static bool is_straight(const struct merging *merging, uint32_t from, uint32_t to, uint32_t corner)
{
    double(*points)[3] = merging->mesh->points;
    double distance2 = vec3_segment_distance2(points[from], points[to], points[corner]);
    return distance2 < merging->near_m * merging->near_m / 4; /* half: rounding cannot keep it from coming back */
}

/* Is every corner strictly between corners i and j of the part on the side from i to j? */
static bool is_side(const struct merging *merging, const struct part *part, size_t i, size_t j)
{
    for (size_t k = (i + 1) % part->count; k != j; k = (k + 1) % part->count)
        if (!is_straight(merging, part->corners[i], part->corners[j], part->corners[k])) return false;
    return true;
}

/* No face has any edge of that side. */
static bool is_inner_side(const struct merging *merging, const struct part *part, size_t i, size_t j)
{
    for (size_t k = i; k != j; k = (k + 1) % part->count)
        if (!inner_has(merging->mesh, part->corners[k], part->corners[(k + 1) % part->count])) return false;
    return true;
}

/* Marks the corners where the part bends. Returns how many. */
static size_t mark_bends(const struct merging *merging, const struct part *part, bool *bends)
{
    size_t count = 0;
    for (size_t k = 0; k < part->count; k++) {
        uint32_t before = part->corners[(k + part->count - 1) % part->count];
        bends[k] = !is_straight(merging, before, part->corners[(k + 1) % part->count], part->corners[k]);
        count += bends[k];
    }
    return count;
}

/* Drops the corners between two bends if they are all on the side from one to the other: otherwise
 * they are a curve of many slight bends. */
static void straighten(const struct merging *merging, struct part *part)
{
    bool *bends = grow_zeroed(part->count, sizeof *bends);
    uint32_t *kept = grow_zeroed(part->count, sizeof *kept);
    size_t kept_count = 0;
    bool whole = mark_bends(merging, part, bends) < 3;
    for (size_t i = 0; !whole && i < part->count; i++) {
        if (!bends[i]) continue;
        size_t j = (i + 1) % part->count;
        while (!bends[j])
            j = (j + 1) % part->count;
        bool drop = is_side(merging, part, i, j);
        if (drop && is_inner_side(merging, part, i, j)) inner_add(merging->mesh, part->corners[i], part->corners[j]);
        kept[kept_count++] = part->corners[i];
        for (size_t k = (i + 1) % part->count; !drop && k != j; k = (k + 1) % part->count)
            kept[kept_count++] = part->corners[k];
    }
    free(bends);
    free(whole ? kept : part->corners);
    if (whole) return;
    part->corners = kept;
    part->count = kept_count;
}

static void start(struct merging *merging)
{
    const struct mesh *mesh = merging->mesh;
    merging->parts = grow_zeroed(mesh->polygon_count, sizeof *merging->parts);
    for (uint32_t i = 0; i < mesh->polygon_count; i++) {
        const struct mesh_polygon *polygon = &mesh->polygons[i];
        merging->parts[i] = (struct part){copy_of(&mesh->corners[polygon->first], polygon->count), polygon->count, i};
    }
    find_shared_edges(merging);
}

static const double MERGE_SHARE = 0.25; /* of the time: the trees need more */

/* Joins until nothing more can be joined: a union may fit a neighbour that its parts did not. */
static void merge_all(struct merging *merging)
{
    for (bool again = true; again;) {
        again = false;
        for (size_t i = 0; i < merging->edge_count && !deadline_passed(); i++) {
            progress_bar(i, merging->edge_count, "merging faces");
            again |= try_merge(merging, &merging->edges[i]);
        }
    }
    progress_end();
}

static void note_parts(struct merging *merging)
{
    struct mesh *mesh = merging->mesh;
    for (uint32_t i = (uint32_t)mesh->polygon_count; i-- > 0;) /* backwards: a face's first piece has the last word */
        mesh->merged_into[mesh->polygons[i].face] = mesh->polygons[part_of(merging->parts, i)].face;
    for (uint32_t i = 0; i < mesh->polygon_count; i++) {
        const uint32_t face = mesh->polygons[i].face, into = mesh->polygons[part_of(merging->parts, i)].face;
        if (into == mesh->merged_into[face]) continue;
        mesh->pieces = grow(mesh->pieces, mesh->piece_count, &mesh->piece_capacity, sizeof *mesh->pieces);
        mesh->pieces[mesh->piece_count++] = (struct mesh_piece){face, into};
    }
}

static bool finish(struct merging *merging, struct error *err)
{
    struct mesh *mesh = merging->mesh;
    struct polygon_list list = {0};
    note_parts(merging);
    for (uint32_t i = 0; i < mesh->polygon_count; i++) {
        struct part *part = &merging->parts[i];
        if (part->into == i) {
            straighten(merging, part);
            polygon_list_add(&list, part->corners, part->count, &mesh->polygons[i]);
        }
        free(part->corners);
    }
    free(merging->parts);
    free(merging->edges);
    free(merging->joined);
    return polygon_list_move(&list, mesh, err);
}

bool mesh_merge(struct mesh *mesh, struct error *err)
{
    if (!mesh_insert_t_vertices(mesh, err)) return false;
    struct merging merging = {.mesh = mesh, .near_m = grid_near_m(&mesh->grid), .flat_m = grid_flat_m(&mesh->grid)};
    mesh->counts.t_vertices = 0;
    start(&merging);
    const struct deadline_end whole = deadline_share(MERGE_SHARE);
    merge_all(&merging);
    deadline_say("a mesh whose faces are merged in part");
    deadline_restore(whole);
    return finish(&merging, err);
}
