/* SPDX-License-Identifier: MIT
 *
 * Importers repeat points, so that neighbours are found by place: points nearer than 1/4096 unit are one here, far
 * below what the mesh welds. */
#include "model/original.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/map.h"
#include "base/vec3.h"
#include "model/grid.h"
#include "model/loop.h"
#include "model/mesh.h"
#include "model/weld.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { INVISIBLE = 255, FINER = 256 /* than the mesh's weld */ };
static const double NO_AREA = 1e-6;             /* of a face's size */
static const double BEND = 0.70710678118654752; /* cosine */

/* Faces put together: forests, each tree's root its lowest index. */
struct joining {
    struct original *out;
    const struct model *model;
    uint32_t *same; /* for each point of the model: one number a place */
    size_t places;
    uint32_t *patch, *thing;
};

static uint32_t root_of(uint32_t *parents, uint32_t face)
{
    while (parents[face] != face)
        face = parents[face] = parents[parents[face]];
    return face;
}

static void unite(uint32_t *parents, uint32_t a, uint32_t b)
{
    a = root_of(parents, a);
    b = root_of(parents, b);
    parents[a > b ? a : b] = a < b ? a : b;
}

static double longest(const double low[3], const double high[3])
{
    return fmax(high[0] - low[0], fmax(high[1] - low[1], high[2] - low[2]));
}

static void widen(double low[3], double high[3], const double at[3])
{
    for (int i = 0; i < 3; i++) {
        low[i] = fmin(low[i], at[i]);
        high[i] = fmax(high[i], at[i]);
    }
}

/* How far corners leave the line through the first and the one that is farthest from it. */
static double width_of(double (*corners)[3], uint32_t count)
{
    uint32_t far = 0;
    double width2 = 0;
    for (uint32_t k = 1; k < count; k++)
        if (vec3_distance2(corners[k], corners[0]) > vec3_distance2(corners[far], corners[0])) far = k;
    for (uint32_t k = 1; k < count; k++)
        width2 = fmax(width2, vec3_segment_distance2(corners[0], corners[far], corners[k]));
    return sqrt(width2);
}

static void face_set(struct joining *joining, size_t index, const uint32_t *welded)
{
    const struct model *model = joining->model;
    const struct model_face *from = &model->faces[index];
    struct original *out = joining->out;
    struct original_face *face = &out->faces[index];
    const struct loop loop = {model->points, &model->corners[from->first], from->count};
    double low[3] = {DBL_MAX, DBL_MAX, DBL_MAX}, high[3] = {-DBL_MAX, -DBL_MAX, -DBL_MAX};
    *face = (struct original_face){.first = (uint32_t)out->corner_count, .number = model_face_number(model, index)};
    joining->patch[index] = joining->thing[index] = (uint32_t)index;
    for (uint32_t k = 0; k < from->count; k++)
        widen(low, high, model->points[loop.corners[k]]);
    if (from->transparency == INVISIBLE || from->count < 3 || !loop_has_area(&loop, longest(low, high) * NO_AREA))
        return;
    for (uint32_t k = 0; k < from->count; k++) {
        memcpy(out->corners_m[out->corner_count], model->points[loop.corners[k]], sizeof *out->corners_m);
        out->points[out->corner_count++] = welded[loop.corners[k]];
    }
    const struct loop_plane plane = loop_plane_of(&loop);
    memcpy(face->centre_m, plane.centre, sizeof face->centre_m);
    memcpy(face->normal, plane.normal, sizeof face->normal);
    face->count = from->count;
    for (uint32_t k = 0; k < face->count; k++)
        face->radius_m = fmax(face->radius_m, sqrt(vec3_distance2(face->centre_m, out->corners_m[face->first + k])));
    face->width_m = width_of(&out->corners_m[face->first], face->count);
}

/* Along edges to the last face there, and by corners to the first. */
static void join(struct joining *joining)
{
    struct original *out = joining->out;
    uint32_t *first = grow_zeroed(joining->places, sizeof *first); /* from 1 */
    struct map edges = {0};
    for (uint32_t i = 0; i < out->face_count; i++) {
        const struct original_face *face = &out->faces[i];
        const uint32_t *corners = &joining->model->corners[joining->model->faces[i].first];
        for (uint32_t k = 0; k < face->count; k++) {
            const uint32_t a = joining->same[corners[k]], b = joining->same[corners[k + 1 < face->count ? k + 1 : 0]];
            if (!first[a]) first[a] = i + 1;
            unite(joining->thing, first[a] - 1, i);
            if (a == b) continue;
            uint32_t *last = map_at(&edges, (uint64_t)(a < b ? a : b) << 32 | (a < b ? b : a), i);
            if (fabs(vec3_dot(out->faces[*last].normal, face->normal)) > BEND) unite(joining->patch, *last, i);
            *last = i;
        }
    }
    map_free(&edges);
    free(first);
}

static void measure_patches(struct joining *joining)
{
    struct original *out = joining->out;
    double(*bounds)[2][3] = grow_zeroed(out->face_count, sizeof *bounds);
    for (size_t i = 0; i < out->face_count; i++)
        for (int axis = 0; axis < 3; axis++) {
            bounds[i][0][axis] = DBL_MAX;
            bounds[i][1][axis] = -DBL_MAX;
        }
    for (uint32_t i = 0; i < out->face_count; i++) {
        struct original_face *face = &out->faces[i];
        face->patch = root_of(joining->patch, i);
        face->thing = root_of(joining->thing, i);
        for (uint32_t k = 0; k < face->count; k++)
            widen(bounds[face->patch][0], bounds[face->patch][1], out->corners_m[face->first + k]);
    }
    for (size_t i = 0; i < out->face_count; i++)
        if (out->faces[i].count)
            out->faces[i].size_m = longest(bounds[out->faces[i].patch][0], bounds[out->faces[i].patch][1]);
    free(bounds);
}

struct sized {
    double size_m;
    uint32_t face;
};

static int by_size(const void *left, const void *right)
{
    const struct sized *a = left, *b = right;
    const int larger = (a->size_m > b->size_m) - (a->size_m < b->size_m);
    return larger ? larger : (a->face > b->face) - (a->face < b->face);
}

static void sort_by_size(struct original *out)
{
    struct sized *sizes = grow_zeroed(out->face_count, sizeof *sizes);
    for (uint32_t i = 0; i < out->face_count; i++)
        if (out->faces[i].count) sizes[out->seen_count++] = (struct sized){out->faces[i].size_m, i};
    qsort(sizes, out->seen_count, sizeof *sizes, by_size);
    for (size_t i = 0; i < out->seen_count; i++)
        out->by_size[i] = sizes[i].face;
    free(sizes);
}

static void make_faces(struct joining *joining, const uint32_t *welded)
{
    for (size_t i = 0; i < joining->model->face_count; i++)
        face_set(joining, i, welded);
    join(joining);
    measure_patches(joining);
    sort_by_size(joining->out);
}

struct original *original_make(const struct model *model, const struct grid *grid, const uint32_t *welded)
{
    struct original *out = grow_zeroed(1, sizeof *out);
    struct mesh places = {0};
    *out = (struct original){.faces = grow_zeroed(model->face_count, sizeof *out->faces),
                             .face_count = model->face_count,
                             .corners_m = grow_zeroed(model->corner_count, sizeof *out->corners_m),
                             .points = grow_zeroed(model->corner_count, sizeof *out->points),
                             .by_size = grow_zeroed(model->face_count, sizeof *out->by_size)};
    struct joining joining = {.out = out,
                              .model = model,
                              .same = weld_points(model, grid_weld_m(grid) / FINER, &places),
                              .patch = grow_zeroed(model->face_count, sizeof *joining.patch),
                              .thing = grow_zeroed(model->face_count, sizeof *joining.thing)};
    joining.places = places.point_count;
    const bool ok = !deadline_passed(); /* else not all points are welded */
    if (ok) make_faces(&joining, welded);
    free(places.points);
    free(joining.same);
    free(joining.patch);
    free(joining.thing);
    if (ok) return out;
    original_free(out);
    return NULL;
}

struct original *original_share(struct original *original)
{
    if (original) original->more_owners++;
    return original;
}

void original_free(struct original *original)
{
    if (!original || original->more_owners-- > 0) return;
    free(original->faces);
    free(original->corners_m);
    free(original->points);
    free(original->by_size);
    free(original);
}
