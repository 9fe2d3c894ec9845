/* SPDX-License-Identifier: MIT
 *
 * The volume is a sum of tetrahedra between the corners' mean and the triangles of all faces. Where a few edges are
 * open, as at the eyes of an animal, it is nearly that of the closed thing: a large one tells as much. */
#include "model/winding.h"

#include "base/grow.h"
#include "base/map.h"
#include "base/vec3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double MOST_OPEN = 0.1;     /* of the edges of what is nearly closed */
static const double LEAST_FILLED = 0.05; /* of the box round it, that its volume must be */

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

/* The share of its edges that faces do not run along as often in one direction as in the other. */
static double open_share(const struct model *model)
{
    uint32_t *places = places_of(model);
    struct map edges = {0};
    size_t all = 0, open = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        const struct model_face *face = &model->faces[i];
        for (uint32_t k = 0; k < face->count; k++)
            count_edge(&edges, places[model->corners[face->first + k]],
                       places[model->corners[face->first + (k + 1) % face->count]]);
    }
    for (size_t i = 0; i < edges.capacity; i++) {
        all += edges.entries[i].used;
        open += edges.entries[i].used && edges.entries[i].value != 0;
    }
    map_free(&edges);
    free(places);
    return all ? (double)open / (double)all : 1;
}

/* The corners' mean, and the volume of the box round them. */
static double middle_of(const struct model *model, double middle[3])
{
    double box_m3 = 1;
    for (int axis = 0; axis < 3; axis++) {
        double least = INFINITY, most = -INFINITY, sum = 0;
        for (size_t i = 0; i < model->corner_count; i++) {
            const double at = model->points[model->corners[i]][axis];
            least = fmin(least, at);
            most = fmax(most, at);
            sum += at;
        }
        middle[axis] = sum / (double)model->corner_count;
        box_m3 *= most - least;
    }
    return box_m3;
}

static double volume_m3(const struct model *model, const double middle[3])
{
    double sum = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        const uint32_t *corners = &model->corners[model->faces[i].first];
        for (uint32_t k = 2; k < model->faces[i].count; k++) {
            double a[3], b[3], c[3];
            vec3_sub(a, model->points[corners[0]], middle);
            vec3_sub(b, model->points[corners[k - 1]], middle);
            vec3_sub(c, model->points[corners[k]], middle);
            sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
    }
    return sum / 6;
}

static size_t two_sided_count(const struct model *model)
{
    size_t count = 0;
    for (size_t i = 0; i < model->face_count; i++)
        count += model->faces[i].two_sided;
    return count;
}

bool winding_is_clockwise(const struct model *model)
{
    const size_t two_sided = two_sided_count(model);
    const bool all_two_sided = two_sided == model->face_count;
    double middle[3];
    if (!model->corner_count || (two_sided && !all_two_sided)) return false;
    const double box_m3 = middle_of(model, middle), volume = volume_m3(model, middle);
    if (!(volume < 0)) return false;
    const double open = open_share(model);
    return open == 0 || (all_two_sided && open <= MOST_OPEN && -volume >= LEAST_FILLED * box_m3);
}
