/* SPDX-License-Identifier: MIT
 *
 * Greedy grouping: polygons come largest first, and each joins the first group of its direction
 * whose plane holds all its corners, or starts a group. Directions are hashed into cells, so that
 * only planes of about the same direction are tried; the order is the same on every run. */
#include "trees/coplanar.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/map.h"
#include "base/progress.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS_A_UNIT = 64 };
#define NO_GROUP UINT32_MAX

struct face_plane {
    double normal[3], d; /* unit length; units */
    double area;         /* twice, in square units */
    uint32_t polygon;
};

struct grouping {
    const struct mesh *mesh;
    double (*points)[3];
    double tolerance_units;
    struct face_plane *faces; /* the largest first */
    struct face_plane *heads; /* of the groups: their first members */
    size_t head_count;
    uint32_t *next;   /* of each group: the next one in its direction cell */
    struct map cells; /* direction key -> first group */
};

static const double *corner_at(const struct grouping *work, const struct mesh_polygon *polygon, uint32_t i)
{
    return work->points[work->mesh->corners[polygon->first + i % polygon->count]];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Newell's sum, taken from the first corner so that far-off polygons lose no digits. */
static void newell(const struct grouping *work, const struct mesh_polygon *polygon, double normal[3])
{
    const double *origin = corner_at(work, polygon, 0);
    memset(normal, 0, 3 * sizeof *normal);
    for (uint32_t i = 0; i < polygon->count; i++) {
        const double *p = corner_at(work, polygon, i), *q = corner_at(work, polygon, i + 1);
        for (int k = 0; k < 3; k++) {
            int a = (k + 1) % 3, b = (k + 2) % 3;
            normal[k] += (p[a] - origin[a]) * (q[b] - origin[b]) - (p[b] - origin[b]) * (q[a] - origin[a]);
        }
    }
}

static void face_plane_set(const struct grouping *work, uint32_t index, struct face_plane *face)
{
    const struct mesh_polygon *polygon = &work->mesh->polygons[index];
    double low = INFINITY, high = -INFINITY;
    newell(work, polygon, face->normal);
    face->polygon = index;
    face->area = sqrt(dot(face->normal, face->normal));
    for (int k = 0; k < 3; k++)
        face->normal[k] = face->area > 0.0 ? face->normal[k] / face->area : k == 1;
    for (uint32_t i = 0; i < polygon->count; i++) {
        double along = dot(face->normal, corner_at(work, polygon, i));
        low = fmin(low, along);
        high = fmax(high, along);
    }
    face->d = low + (high - low) / 2.0;
}

static int larger_first(const void *a, const void *b)
{
    const struct face_plane *left = a, *right = b;
    if (left->area != right->area) return left->area > right->area ? -1 : 1;
    return left->polygon < right->polygon ? -1 : 1;
}

static uint64_t cell_key(const double direction[3], const int step[3])
{
    uint64_t key = 0;
    for (int k = 0; k < 3; k++) {
        int64_t cell = (int64_t)floor(direction[k] * CELLS_A_UNIT) + step[k] + 4 * CELLS_A_UNIT;
        key = key << 16 | (uint64_t)cell;
    }
    return key;
}

/* A group that may take a polygon in, and how far the polygon's farthest corner is off its plane. */
struct place {
    uint32_t group;
    double off_units;
};

/* How far the farthest corner is off a group's plane; no farther is looked for than `most_units`. */
static double off_group(const struct grouping *work, const struct face_plane *head, const struct face_plane *face,
                        double most_units)
{
    const struct mesh_polygon *polygon = &work->mesh->polygons[face->polygon];
    double most = 0;
    for (uint32_t i = 0; i < polygon->count && most <= most_units; i++)
        most = fmax(most, fabs(dot(head->normal, corner_at(work, polygon, i)) - head->d));
    return most;
}

/* The first that holds the polygon, or the one whose plane is nearest. */
static void cell_search(const struct grouping *work, uint64_t key, const struct face_plane *face, bool nearest,
                        struct place *best)
{
    const uint32_t *first = map_find(&work->cells, key);
    for (uint32_t group = first ? *first : NO_GROUP; group != NO_GROUP; group = work->next[group]) {
        const double off_units = off_group(work, &work->heads[group], face, work->tolerance_units);
        if (off_units > work->tolerance_units || off_units >= best->off_units) continue;
        *best = (struct place){group, off_units};
        if (!nearest) return;
    }
}

/* Looks at the direction's cell and its neighbours, then at those of the opposite direction. */
static uint32_t group_search(const struct grouping *work, const struct face_plane *face, bool nearest)
{
    struct place best = {NO_GROUP, INFINITY};
    for (int k = 0; k < 54 && (nearest || best.group == NO_GROUP); k++) {
        double sign = k < 27 ? 1.0 : -1.0;
        double direction[3] = {sign * face->normal[0], sign * face->normal[1], sign * face->normal[2]};
        const int step[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 % 3 - 1};
        cell_search(work, cell_key(direction, step), face, nearest, &best);
    }
    return best.group;
}

static uint32_t group_start(struct grouping *work, const struct face_plane *face)
{
    uint32_t group = (uint32_t)work->head_count++;
    uint32_t *first = map_at(&work->cells, cell_key(face->normal, (const int[3]){0, 0, 0}), NO_GROUP);
    work->heads[group] = *face;
    work->next[group] = *first;
    *first = group;
    return group;
}

static void group_polygons(struct grouping *work, uint32_t *group_of)
{
    size_t count = work->mesh->polygon_count;
    for (size_t i = 0; i < count; i++)
        face_plane_set(work, (uint32_t)i, &work->faces[i]);
    qsort(work->faces, count, sizeof *work->faces, larger_first);
    for (size_t i = 0; i < count && !(i && deadline_passed()); i++) {
        progress_bar(i, count, "grouping %zu polygons by plane", count);
        uint32_t group = group_search(work, &work->faces[i], false);
        group_of[work->faces[i].polygon] = group == NO_GROUP ? group_start(work, &work->faces[i]) : group;
    }
}

/* Of sheets that lie over one another each goes to the group that is nearest, so that none of another group lies
 * between two of one group: no tree could draw that. */
static void regroup_layers(const struct grouping *work, const struct layers *layers, uint32_t *group_of)
{
    for (size_t i = 0; i < work->mesh->polygon_count && !deadline_passed(); i++) {
        const uint32_t polygon = work->faces[i].polygon;
        size_t count;
        layers_of(layers, polygon, &count);
        const uint32_t group = count ? group_search(work, &work->faces[i], true) : NO_GROUP;
        if (group != NO_GROUP) group_of[polygon] = group; /* one that is bent has its own */
    }
}

/* The corners of all groups, group by group: group g's are at corners[starts[g] .. starts[g+1]). */
static void gather_corners(const struct grouping *work, const uint32_t *group_of, size_t *starts, double (*corners)[3])
{
    const struct mesh *mesh = work->mesh;
    for (size_t i = 0; i < mesh->polygon_count; i++)
        starts[group_of[i] + 1] += mesh->polygons[i].count;
    for (size_t g = 0; g < work->head_count; g++)
        starts[g + 1] += starts[g];
    size_t *fill = grow_zeroed(work->head_count, sizeof *fill);
    for (size_t i = 0; i < mesh->polygon_count; i++)
        for (uint32_t k = 0; k < mesh->polygons[i].count; k++) {
            size_t to = starts[group_of[i]] + fill[group_of[i]]++;
            memcpy(corners[to], corner_at(work, &mesh->polygons[i], k), sizeof corners[to]);
        }
    free(fill);
}

static void store_planes(const struct grouping *work, struct coplanar *out, double tolerance_units)
{
    size_t *starts = grow_zeroed(work->head_count + 1, sizeof *starts);
    double(*corners)[3] = grow_zeroed(work->mesh->corner_count, sizeof *corners);
    struct point_blocks blocks;
    gather_corners(work, out->group, starts, corners);
    point_blocks_build(&blocks, work->points, work->mesh->point_count);
    for (size_t g = 0; g < out->count && !deadline_passed(); g++) {
        progress_bar(g, out->count, "compiling: %zu polygons, planes", work->mesh->polygon_count);
        struct plane_fit fit = {.corners = corners + starts[g],
                                .corner_count = starts[g + 1] - starts[g],
                                .blocks = &blocks,
                                .tolerance_units = tolerance_units,
                                .is_long = work->mesh->grid.is_long};
        memcpy(fit.normal, work->heads[g].normal, sizeof fit.normal);
        plane_store(&fit, &out->planes[g]);
    }
    point_blocks_free(&blocks);
    free(corners);
    free(starts);
}

/* A face that just fits the group's plane may face either way of the stored one. */
static void decide_facings(const struct grouping *work, struct coplanar *out)
{
    for (size_t i = 0; i < work->mesh->polygon_count; i++) {
        const struct face_plane *face = &work->faces[i];
        const struct plane *plane = &out->planes[out->group[face->polygon]];
        const double n[3] = {(double)plane->n[0], (double)plane->n[1], (double)plane->n[2]};
        out->faces_back[face->polygon] = dot(face->normal, n) < 0.0;
    }
}

void coplanar_find(const struct mesh *mesh, double (*points)[3], double tolerance_units, struct coplanar *out)
{
    struct grouping work = {.mesh = mesh, .points = points};
    work.tolerance_units = fmax(tolerance_units - PLANE_STORAGE_ERROR_UNITS, PLANE_STORAGE_ERROR_UNITS);
    work.faces = grow_zeroed(mesh->polygon_count, sizeof *work.faces);
    work.heads = grow_zeroed(mesh->polygon_count, sizeof *work.heads);
    work.next = grow_zeroed(mesh->polygon_count, sizeof *work.next);
    out->group = grow_zeroed(mesh->polygon_count, sizeof *out->group);
    out->faces_back = grow_zeroed(mesh->polygon_count, sizeof *out->faces_back);
    layers_find(mesh, tolerance_units, &out->layers);
    group_polygons(&work, out->group);
    regroup_layers(&work, &out->layers, out->group);
    out->count = work.head_count;
    out->planes = grow_zeroed(out->count, sizeof *out->planes);
    store_planes(&work, out, tolerance_units);
    decide_facings(&work, out);
    map_free(&work.cells);
    free(work.next);
    free(work.heads);
    free(work.faces);
}

void coplanar_free(struct coplanar *coplanar)
{
    free(coplanar->planes);
    free(coplanar->group);
    free(coplanar->faces_back);
    layers_free(&coplanar->layers);
    *coplanar = (struct coplanar){0};
}
