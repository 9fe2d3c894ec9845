/* SPDX-License-Identifier: MIT
 *
 * Along each ray, polygons that face the eye are put in order by distance; each hides the next one. */
#include "compiler/sampled_order.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/progress.h"
#include "cameras/sample.h"
#include "compiler/bsp.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WORD_BITS = 64 };

struct hit {
    double distance;
    uint32_t polygon;
};

/* The hits of one ray, nearest first. */
struct hits {
    struct hit *items;
    size_t count, capacity;
};

/* A polygon's plane as seen from an eye. */
struct face {
    double n[3], away; /* n . (corner - eye) */
};

static struct face face_of(const struct mesh *mesh, const struct mesh_polygon *polygon, const double eye[3])
{
    const uint32_t *corners = &mesh->corners[polygon->first];
    const double *o = mesh->points[corners[0]];
    struct face face = {{0.0, 0.0, 0.0}, 0.0};
    for (uint32_t k = 1; k + 1 < polygon->count; k++) {
        const double *a = mesh->points[corners[k]], *b = mesh->points[corners[k + 1]];
        for (int i = 0; i < 3; i++) {
            const int u = (i + 1) % 3, v = (i + 2) % 3;
            face.n[i] += (a[u] - o[u]) * (b[v] - o[v]) - (a[v] - o[v]) * (b[u] - o[u]);
        }
    }
    for (int i = 0; i < 3; i++)
        face.away += face.n[i] * (o[i] - eye[i]);
    return face;
}

static bool is_inside(const struct mesh *mesh, const struct mesh_polygon *polygon, const struct face *face,
                      const double at[3])
{
    const uint32_t *corners = &mesh->corners[polygon->first];
    for (uint32_t k = 0; k < polygon->count; k++) {
        const double *a = mesh->points[corners[k]], *b = mesh->points[corners[(k + 1) % polygon->count]];
        double turn = 0.0;
        for (int i = 0; i < 3; i++) {
            const int u = (i + 1) % 3, v = (i + 2) % 3;
            turn += face->n[i] * ((b[u] - a[u]) * (at[v] - a[v]) - (b[v] - a[v]) * (at[u] - a[u]));
        }
        if (turn < 0.0) return false;
    }
    return true;
}

static void insert(struct hits *hits, struct hit hit)
{
    hits->items = grow(hits->items, hits->count, &hits->capacity, sizeof *hits->items);
    size_t at = hits->count++;
    for (; at && hits->items[at - 1].distance > hit.distance; at--)
        hits->items[at] = hits->items[at - 1];
    hits->items[at] = hit;
}

/* All front faces on a ray from the eye. */
static void shoot(const struct mesh *mesh, const struct face *faces, const double eye[3], const double way[3],
                  struct hits *hits)
{
    hits->count = 0;
    for (uint32_t p = 0; p < mesh->polygon_count; p++) {
        const struct mesh_polygon *polygon = &mesh->polygons[p];
        if (faces[p].away >= 0.0 && !polygon->two_sided) continue;
        double climb = 0.0, at[3];
        for (int i = 0; i < 3; i++)
            climb += faces[p].n[i] * way[i];
        const double t = faces[p].away / climb;
        if (!(t > 0.0 && t < 1e9)) continue;
        for (int i = 0; i < 3; i++)
            at[i] = eye[i] + t * way[i];
        if (is_inside(mesh, polygon, &faces[p], at)) insert(hits, (struct hit){t, p});
    }
}

static void note(struct rings *rings, const struct hits *hits)
{
    for (size_t i = 0; i + 1 < hits->count; i++)
        for (size_t k = i + 1; k < hits->count; k++) {
            if (hits->items[k].distance <= hits->items[i].distance * (1.0 + 1e-9)) continue; /* in one plane */
            const uint32_t p = hits->items[i].polygon, q = hits->items[k].polygon;
            rings->hides[p * rings->words + q / WORD_BITS] |= UINT64_C(1) << q % WORD_BITS;
            rings->hidden_by[q * rings->words + p / WORD_BITS] |= UINT64_C(1) << p % WORD_BITS;
        }
}

/* 90 degrees wide and high about the target; rays shifted by a part of their distance from view to view. */
static void look(struct rings *rings, const struct mesh *mesh, const struct viewpoint *viewpoint, int view,
                 struct face *faces, struct hits *hits)
{
    const double shift_x = fmod(view * 0.618, 1.0), shift_y = fmod(view * 0.382, 1.0);
    struct view_axes axes;
    viewpoint_axes(viewpoint, &axes);
    for (size_t p = 0; p < mesh->polygon_count; p++)
        faces[p] = face_of(mesh, &mesh->polygons[p], viewpoint->eye_m);
    for (int ray = 0; ray < SAMPLED_SIDE * SAMPLED_SIDE; ray++) {
        const double x = 2.0 * (ray % SAMPLED_SIDE + shift_x) / SAMPLED_SIDE - 1.0;
        const double y = 2.0 * (ray / SAMPLED_SIDE + shift_y) / SAMPLED_SIDE - 1.0;
        double way[3];
        for (int i = 0; i < 3; i++)
            way[i] = axes.forward[i] + x * axes.right[i] + y * axes.up[i];
        shoot(mesh, faces, viewpoint->eye_m, way, hits);
        note(rings, hits);
    }
}

void sampled_order_find(struct rings *rings, const struct mesh *mesh, const struct compiled *scene)
{
    const size_t count = mesh->polygon_count;
    struct face *faces = grow_zeroed(count, sizeof *faces);
    struct hits hits = {0};
    struct sampler sampler;
    rings_make(rings, count);
    sampler_init(&sampler, scene);
    for (int view = 0; view < SAMPLED_VIEWS && !deadline_passed(); view++) {
        const struct viewpoint viewpoint = sampler_next(&sampler);
        progress_bar((size_t)view, SAMPLED_VIEWS, "sampled views");
        look(rings, mesh, &viewpoint, view, faces, &hits);
    }
    free(faces);
    free(hits.items);
}

/* Sorting ------------------------------------------------------------------------------------ */

static bool meets(const uint64_t *a, const uint64_t *b, size_t words)
{
    for (size_t i = 0; i < words; i++)
        if (a[i] & b[i]) return true;
    return false;
}

/* All pieces of the first polygon in the list that none left hides. Returns how many; 0: there is none. */
static size_t take_next(const struct bsp *bsp, const uint32_t *list, size_t count, uint64_t *left, uint32_t *order)
{
    const struct rings *rings = &bsp->rings;
    for (size_t i = 0; i < count; i++) {
        const uint32_t p = bsp->pieces[list[i]].polygon;
        const uint64_t bit = UINT64_C(1) << p % WORD_BITS;
        if (!(left[p / WORD_BITS] & bit) || meets(rings->hidden_by + p * rings->words, left, rings->words)) continue;
        size_t taken = 0;
        for (size_t k = i; k < count; k++)
            if (bsp->pieces[list[k]].polygon == p) order[taken++] = list[k];
        left[p / WORD_BITS] &= ~bit;
        return taken;
    }
    return 0;
}

bool sampled_order_sort(const struct bsp *bsp, const uint32_t *list, size_t count, uint32_t *order)
{
    uint64_t *left = grow_zeroed(bsp->rings.words, sizeof *left);
    for (size_t i = 0; i < count; i++) {
        const uint32_t p = bsp->pieces[list[i]].polygon;
        left[p / WORD_BITS] |= UINT64_C(1) << p % WORD_BITS;
    }
    size_t done = 0;
    for (size_t taken = 1; taken && done < count; done += taken)
        taken = take_next(bsp, list, count, left, order + done);
    free(left);
    return done == count;
}
