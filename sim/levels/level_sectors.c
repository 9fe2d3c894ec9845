/* SPDX-License-Identifier: MIT
 *
 * The map's vertices become points, its lines edges between them (level_triangles.h), and each triangle gets a sector
 * (level_regions.h). Those of a sector are joined as long as what comes out is convex (Hertel and Mehlhorn 1983). */
#include "levels/level_sectors.h"

#include "base/grow.h"
#include "levels/level_regions.h"

#include <stdlib.h>
#include <string.h>

/* Points ------------------------------------------------------------------------------------- */

struct place {
    int16_t at[2];
    uint32_t vertex;
};

static int by_place(const void *left, const void *right)
{
    const struct place *a = left, *b = right;
    if (a->at[0] != b->at[0]) return a->at[0] < b->at[0] ? -1 : 1;
    if (a->at[1] != b->at[1]) return a->at[1] < b->at[1] ? -1 : 1;
    return (a->vertex > b->vertex) - (a->vertex < b->vertex);
}

/* Of the vertices that lines have: builders of nodes add others. */
static size_t find_places(const struct level *level, struct place *places)
{
    bool *is_used = grow_zeroed(level->vertex_count, sizeof *is_used);
    size_t count = 0;
    for (size_t i = 0; i < level->line_count; i++)
        is_used[level->lines[i].from] = is_used[level->lines[i].to] = true;
    for (uint32_t i = 0; i < level->vertex_count; i++)
        if (is_used[i])
            places[count++] = (struct place){{(int16_t)level->vertices[i].x, (int16_t)level->vertices[i].y}, i};
    free(is_used);
    qsort(places, count, sizeof *places, by_place);
    return count;
}

/* Vertices at one place are one point. Points are numbered as their vertices are, so that neighbours come one after the
 * other. */
static void make_points(const struct level *level, struct level_sectors *sectors)
{
    struct place *places = grow_zeroed(level->vertex_count, sizeof *places);
    int16_t(*points)[2] = grow_zeroed(level->vertex_count, sizeof *points);
    uint32_t *same = grow_zeroed(level->vertex_count, sizeof *same), count = 0;
    const size_t place_count = find_places(level, places);
    for (size_t i = 0; i < level->vertex_count; i++)
        same[i] = TRIANGLES_NONE;
    for (size_t i = 0; i < place_count; i++) {
        const bool is_again = i > 0 && memcmp(places[i].at, places[i - 1].at, sizeof places[i].at) == 0;
        same[places[i].vertex] = is_again ? same[places[i - 1].vertex] : places[i].vertex;
    }
    for (uint32_t i = 0; i < level->vertex_count; i++) {
        sectors->points[i] = TRIANGLES_NONE;
        if (same[i] != i) continue;
        points[count][0] = (int16_t)level->vertices[i].x;
        points[count][1] = (int16_t)level->vertices[i].y;
        sectors->points[i] = triangles_point(count++);
    }
    for (uint32_t i = 0; i < level->vertex_count; i++)
        if (same[i] != TRIANGLES_NONE) sectors->points[i] = sectors->points[same[i]];
    triangles_make(&sectors->triangles, (const int16_t(*)[2])points, count);
    free(places);
    free(points);
    free(same);
}

/* Lines -------------------------------------------------------------------------------------- */

static void fix_lines(const struct level *level, struct level_sectors *sectors)
{
    for (uint32_t i = 0; i < level->line_count; i++) {
        const struct level_line *line = &level->lines[i];
        if (triangles_fix(&sectors->triangles, sectors->points[line->from], sectors->points[line->to])) continue;
        if (!sectors->crossing_count++) sectors->first_crossing = i;
    }
    triangles_settle(&sectors->triangles);
}

/* Polygons ----------------------------------------------------------------------------------- */

static uint32_t point_behind(const struct level_sectors *sectors, uint32_t half)
{
    return sectors->triangles.origin[sectors->next[half]];
}

/* Where an edge goes, at the point where it begins: from what comes before it, on to what its twin's side goes on
 * with. */
static bool is_convex_without(const struct level_sectors *sectors, uint32_t half, uint32_t twin)
{
    const struct triangles *triangles = &sectors->triangles;
    return triangles_side(triangles, triangles->origin[sectors->before[half]], triangles->origin[half],
                          point_behind(sectors, sectors->next[twin])) >= 0;
}

static void take_out(struct level_sectors *sectors, uint32_t half)
{
    const uint32_t twin = sectors->triangles.twin[half];
    const uint32_t next = sectors->next[half], before = sectors->before[half];
    const uint32_t twin_next = sectors->next[twin], twin_before = sectors->before[twin];
    sectors->next[before] = twin_next;
    sectors->before[twin_next] = before;
    sectors->next[twin_before] = next;
    sectors->before[next] = twin_before;
    sectors->is_inside[half] = sectors->is_inside[twin] = true;
}

/* Two polygons may share more than one edge, on a straight line: of these all stay. */
static bool is_needless(const struct level_sectors *sectors, uint32_t half)
{
    const uint32_t twin = sectors->triangles.twin[half];
    if (twin == TRIANGLES_NONE || sectors->sector_of[half / 3] != sectors->sector_of[twin / 3]) return false;
    const uint32_t *twins = sectors->triangles.twin;
    if (twins[sectors->next[half]] == sectors->before[twin] || twins[sectors->before[half]] == sectors->next[twin])
        return false;
    return is_convex_without(sectors, half, twin) && is_convex_without(sectors, twin, half);
}

struct long_edge {
    int64_t length2;
    uint32_t half;
};

static int by_length(const void *left, const void *right)
{
    const struct long_edge *a = left, *b = right;
    if (a->length2 != b->length2) return a->length2 < b->length2 ? 1 : -1;
    return (a->half > b->half) - (a->half < b->half);
}

static size_t list_edges(const struct level_sectors *sectors, struct long_edge *edges)
{
    const struct triangles *triangles = &sectors->triangles;
    size_t count = 0;
    for (uint32_t half = 0; half < triangles->half_count; half++) {
        if (triangles->twin[half] == TRIANGLES_NONE || half > triangles->twin[half]) continue;
        const int32_t *p = triangles->points[triangles->origin[half]],
                      *q = triangles->points[triangles->origin[half_next(half)]];
        const int64_t dx = q[0] - p[0], dy = q[1] - p[1];
        edges[count++] = (struct long_edge){dx * dx + dy * dy, half};
    }
    qsort(edges, count, sizeof *edges, by_length);
    return count;
}

static void join_triangles(struct level_sectors *sectors)
{
    const uint32_t halves = sectors->triangles.half_count;
    struct long_edge *edges = grow_zeroed(halves, sizeof *edges);
    sectors->next = grow_zeroed(halves, sizeof *sectors->next);
    sectors->before = grow_zeroed(halves, sizeof *sectors->before);
    sectors->is_inside = grow_zeroed(halves, sizeof *sectors->is_inside);
    for (uint32_t half = 0; half < halves; half++) {
        sectors->next[half] = half_next(half);
        sectors->before[half] = half_before(half);
    }
    const size_t count = list_edges(sectors, edges);
    for (size_t i = 0; i < count; i++)
        if (sectors->sector_of[edges[i].half / 3] != LEVEL_VOID && is_needless(sectors, edges[i].half))
            take_out(sectors, edges[i].half);
    free(edges);
}

void level_sectors_each(const struct level_sectors *sectors, level_polygon_sink *take, void *context)
{
    const struct triangles *triangles = &sectors->triangles;
    bool *is_done = grow_zeroed(triangles->half_count, sizeof *is_done);
    int32_t(*corners)[2] = grow_zeroed(triangles->half_count, sizeof *corners);
    for (uint32_t half = 0; half < triangles->half_count; half++) {
        const uint32_t sector = sectors->sector_of[half / 3];
        size_t count = 0;
        if (sector == LEVEL_VOID || sectors->is_inside[half] || is_done[half]) continue;
        for (uint32_t at = half; !is_done[at]; at = sectors->next[at]) {
            is_done[at] = true;
            memcpy(corners[count++], triangles->points[triangles->origin[at]], sizeof *corners);
        }
        take(context, (const int32_t(*)[2])corners, count, sector);
    }
    free(is_done);
    free(corners);
}

/* -------------------------------------------------------------------------------------------- */

bool level_sectors_make(const struct level *level, struct level_sectors *out, struct error *err)
{
    *out = (struct level_sectors){.points = grow_zeroed(level->vertex_count, sizeof *out->points)};
    make_points(level, out);
    fix_lines(level, out);
    level_regions_find(level, out);
    join_triangles(out);
    for (uint32_t i = 0; i < out->triangles.half_count / 3; i++)
        if (out->sector_of[i] != LEVEL_VOID) return true;
    level_sectors_free(out);
    return error_set(err, "%s: LINEDEFS: its lines enclose nothing", level->name);
}

void level_sectors_free(struct level_sectors *sectors)
{
    triangles_free(&sectors->triangles);
    free(sectors->sector_of);
    free(sectors->next);
    free(sectors->before);
    free(sectors->is_inside);
    free(sectors->points);
    *sectors = (struct level_sectors){0};
}

uint32_t level_sector_at(const struct level_sectors *sectors, int x, int y)
{
    const uint32_t triangle = triangles_at(&sectors->triangles, x, y);
    return triangle == TRIANGLES_NONE ? LEVEL_VOID : sectors->sector_of[triangle];
}
