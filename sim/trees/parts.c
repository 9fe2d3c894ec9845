/* SPDX-License-Identifier: MIT
 *
 * Opaque polygons are joined point by point. A room's walls are large against the room, a statue's faces are small
 * against the statue: what divides well by planes is left to the tree. */
#include "trees/parts.h"

#include "base/grow.h"
#include "trees/parts_gather.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double HELD_SHARE = 0.5;   /* of the polygons of other parts */
static const double ROUND_SHARE = 0.75; /* of the diagonal of the mesh's box */

static void join(uint32_t *leaders, uint32_t a, uint32_t b)
{
    const uint32_t p = parts_leader(leaders, a), q = parts_leader(leaders, b);
    leaders[p > q ? p : q] = p < q ? p : q;
}

static uint32_t *find_leaders(const struct mesh *mesh)
{
    uint32_t *leaders = grow_zeroed(mesh->polygon_count, sizeof *leaders);
    uint32_t *met = grow_zeroed(mesh->point_count, sizeof *met); /* a polygon at each point, from 1 */
    for (uint32_t i = 0; i < mesh->polygon_count; i++) {
        const struct mesh_polygon *polygon = &mesh->polygons[i];
        leaders[i] = i;
        for (uint32_t k = 0; !polygon->transparency && k < polygon->count; k++) {
            uint32_t *other = &met[mesh->corners[polygon->first + k]];
            if (*other) join(leaders, *other - 1, i);
            *other = i + 1;
        }
    }
    free(met);
    return leaders;
}

static void survey_add(struct survey *survey, const struct mesh *mesh, const struct mesh_polygon *polygon,
                       double (*points)[3])
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t c = polygon->first; c < polygon->first + polygon->count; c++)
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], points[mesh->corners[c]][k]);
            high[k] = fmax(high[k], points[mesh->corners[c]][k]);
        }
    const bool is_first = survey->part.polygons++ == 0;
    if (is_first) survey->part.face = polygon->face;
    for (int k = 0; k < 3; k++) {
        survey->part.low[k] = is_first ? low[k] : fmin(survey->part.low[k], low[k]);
        survey->part.high[k] = is_first ? high[k] : fmax(survey->part.high[k], high[k]);
    }
    survey->largest = fmax(survey->largest, parts_diagonal(low, high));
    survey->records += polygon->two_sided ? 2 : 1;
}

static bool is_dense(const struct survey *survey)
{
    return survey->part.polygons >= PART_POLYGONS_MIN && survey->records <= PART_RECORDS_MAX &&
           survey->largest <= PARTS_LARGEST_SHARE * parts_diagonal(survey->part.low, survey->part.high);
}

/* Where the middle of a polygon's corners is. */
static void middle_of(const struct mesh *mesh, const struct mesh_polygon *polygon, double (*points)[3], double out[3])
{
    out[0] = out[1] = out[2] = 0.0;
    for (uint32_t c = polygon->first; c < polygon->first + polygon->count; c++)
        for (int k = 0; k < 3; k++)
            out[k] += points[mesh->corners[c]][k] / polygon->count;
}

/* Walls round all else, or the ground below it: no axis plane could part it from what its box holds. */
static bool is_round_others(const struct mesh *mesh, double (*points)[3], uint32_t *leaders, uint32_t leader,
                            const struct part *part, double mesh_diagonal)
{
    size_t held = 0;
    if (parts_diagonal(part->low, part->high) < ROUND_SHARE * mesh_diagonal) return false;
    for (uint32_t i = 0; i < mesh->polygon_count; i++) {
        double at[3];
        if (parts_leader(leaders, i) == leader) continue;
        middle_of(mesh, &mesh->polygons[i], points, at);
        held += at[0] > part->low[0] && at[0] < part->high[0] && at[1] > part->low[1] && at[1] < part->high[1] &&
                at[2] > part->low[2] && at[2] < part->high[2];
    }
    return (double)held > HELD_SHARE * (double)(mesh->polygon_count - part->polygons);
}

static double diagonal_of_all(const struct survey *surveys, size_t count)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (size_t i = 0; i < count; i++)
        for (int k = 0; surveys[i].part.polygons && k < 3; k++) {
            low[k] = fmin(low[k], surveys[i].part.low[k]);
            high[k] = fmax(high[k], surveys[i].part.high[k]);
        }
    return parts_diagonal(low, high);
}

static void take(struct parts *out, const struct survey *surveys, const struct mesh *mesh, double (*points)[3],
                 uint32_t *leaders)
{
    const double all = diagonal_of_all(surveys, mesh->polygon_count);
    for (uint32_t i = 0; i < mesh->polygon_count; i++) {
        const uint32_t leader = parts_leader(leaders, i);
        if (leader != i)
            out->of[i] = out->of[leader];
        else if (!mesh->polygons[i].transparency && is_dense(&surveys[i]) &&
                 !is_round_others(mesh, points, leaders, i, &surveys[i].part, all)) {
            out->items[out->count++] = surveys[i].part;
            out->of[i] = (uint32_t)out->count;
        }
    }
}

void parts_find(const struct mesh *mesh, double (*points)[3], struct parts *out)
{
    uint32_t *leaders = find_leaders(mesh);
    struct survey *surveys = grow_zeroed(mesh->polygon_count, sizeof *surveys);
    *out = (struct parts){.of = grow_zeroed(mesh->polygon_count, sizeof *out->of),
                          .items = grow_zeroed(mesh->polygon_count / PART_POLYGONS_MIN + 1, sizeof *out->items)};
    for (uint32_t i = 0; i < mesh->polygon_count; i++)
        if (!mesh->polygons[i].transparency)
            survey_add(&surveys[parts_leader(leaders, i)], mesh, &mesh->polygons[i], points);
    parts_gather(surveys, leaders, mesh->polygon_count);
    take(out, surveys, mesh, points, leaders);
    free(surveys);
    free(leaders);
}

void parts_leave_out(struct parts *parts, const struct mesh *mesh, size_t i)
{
    for (size_t k = 0; k < mesh->polygon_count; k++)
        if (parts->of[k] == i + 1) parts->of[k] = 0;
    parts->items[i].polygons = 0;
}

void parts_unite(struct parts *parts, const struct mesh *mesh)
{
    size_t records = 0, polygons = 0;
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        records += mesh->polygons[i].two_sided ? 2 : 1;
        polygons += parts->of[i] > 0;
    }
    const bool fits = polygons == mesh->polygon_count && records <= PART_RECORDS_MAX;
    for (size_t i = 0; i < mesh->polygon_count; i++)
        parts->of[i] = fits;
    for (size_t i = 1; i < parts->count; i++)
        for (int k = 0; k < 3; k++) {
            parts->items[0].low[k] = fmin(parts->items[0].low[k], parts->items[i].low[k]);
            parts->items[0].high[k] = fmax(parts->items[0].high[k], parts->items[i].high[k]);
        }
    if (fits) parts->items[0].polygons = polygons;
    parts->count = fits;
}

size_t parts_taken(const struct parts *parts)
{
    size_t taken = 0;
    for (size_t i = 0; i < parts->count; i++)
        taken += parts->items[i].polygons > 0;
    return taken;
}

void parts_free(struct parts *parts)
{
    free(parts->of);
    free(parts->items);
    *parts = (struct parts){0};
}
