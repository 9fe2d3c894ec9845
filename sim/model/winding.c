/* SPDX-License-Identifier: MIT
 *
 * The volume is a sum of tetrahedra between a point and the triangles of all faces. What is not closed has none. */
#include "model/winding.h"

#include "base/grow.h"
#include "base/map.h"
#include "base/vec3.h"

#include <stdlib.h>
#include <string.h>

struct placed {
    double at_m[3];
    uint32_t point;
};

static int compare_places(const void *a, const void *b)
{
    const double *p = ((const struct placed *)a)->at_m, *q = ((const struct placed *)b)->at_m;
    for (int axis = 0; axis < 3; axis++)
        if (p[axis] != q[axis]) return p[axis] < q[axis] ? -1 : 1;
    return 0;
}

/* For each point a number that those at the same place share. */
static uint32_t *places_of(const struct model *model)
{
    struct placed *placed = grow_zeroed(model->point_count, sizeof *placed);
    uint32_t *places = grow_zeroed(model->point_count, sizeof *places), place = 0;
    for (size_t i = 0; i < model->point_count; i++) {
        memcpy(placed[i].at_m, model->points[i], sizeof placed[i].at_m);
        placed[i].point = (uint32_t)i;
    }
    qsort(placed, model->point_count, sizeof *placed, compare_places);
    for (size_t i = 0; i < model->point_count; i++) {
        if (i && compare_places(&placed[i - 1], &placed[i]) != 0) place++;
        places[placed[i].point] = place;
    }
    free(placed);
    return places;
}

/* Adds 1 for the direction from the lower number to the higher one, and takes it off for the other. */
static void count_edge(struct map *edges, uint32_t from, uint32_t to)
{
    const uint64_t low = from < to ? from : to, high = from < to ? to : from;
    if (from != to) *map_at(edges, low << 32 | high, 0) += from < to ? 1u : UINT32_MAX;
}

static bool is_closed(const struct model *model)
{
    uint32_t *places = places_of(model);
    struct map edges = {0};
    bool closed = true;
    for (size_t i = 0; i < model->face_count; i++) {
        const struct model_face *face = &model->faces[i];
        for (uint32_t k = 0; k < face->count; k++)
            count_edge(&edges, places[model->corners[face->first + k]],
                       places[model->corners[face->first + (k + 1) % face->count]]);
    }
    for (size_t i = 0; i < edges.capacity && closed; i++)
        closed = !edges.entries[i].used || edges.entries[i].value == 0;
    map_free(&edges);
    free(places);
    return closed;
}

static double volume6_m3(const struct model *model)
{
    const double *from = model->points[model->corners[0]];
    double sum = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        const uint32_t *corners = &model->corners[model->faces[i].first];
        for (uint32_t k = 2; k < model->faces[i].count; k++) {
            double a[3], b[3], c[3];
            vec3_sub(a, model->points[corners[0]], from);
            vec3_sub(b, model->points[corners[k - 1]], from);
            vec3_sub(c, model->points[corners[k]], from);
            sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
    }
    return sum;
}

static bool has_two_sided(const struct model *model)
{
    for (size_t i = 0; i < model->face_count; i++)
        if (model->faces[i].two_sided) return true;
    return false;
}

bool winding_is_clockwise(const struct model *model)
{
    return model->corner_count && !has_two_sided(model) && volume6_m3(model) < 0 && is_closed(model);
}
