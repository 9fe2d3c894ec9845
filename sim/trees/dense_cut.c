/* SPDX-License-Identifier: MIT
 *
 * A part counts as one piece, however many polygons it has: the leaf that it becomes is one. A cut at a side of its box
 * is at a whole coordinate, and so splits nothing of it. */
#include "trees/dense_cut.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "trees/sides.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PLANES_MAX = 96, PLANES_MIN = 8, CUTS_MAX = 192, CROSSING_SHARE = 8, CORNERS_MAX = 60000 };
enum { TRIALS_A_NODE = 500000 }; /* pieces tried against planes */

/* In polygons of imbalance: a part in two leaves has vertices in both; a piece of it that is split is one more to draw.
 */
static const double PARTED_COST = 64.0, SPLIT_COST = 64.0;

/* A part as the list has it. */
struct extent {
    double low[3], high[3];
    uint32_t part; /* from 1 */
};

static uint32_t part_of(const struct bsp *bsp, const struct parts *parts, uint32_t piece)
{
    return parts->of[bsp->pieces[piece].polygon];
}

size_t dense_count(const struct bsp *bsp, const struct parts *parts, const uint32_t *list, size_t count)
{
    size_t dense = 0;
    for (size_t i = 0; parts && i < count; i++)
        dense += part_of(bsp, parts, list[i]) > 0;
    return dense;
}

bool dense_fits(const struct bsp *bsp, const uint32_t *list, size_t count)
{
    size_t records = 0, corners = 0;
    for (size_t i = 0; i < count; i++) {
        const struct bsp_piece *piece = &bsp->pieces[list[i]];
        records += bsp->mesh->polygons[piece->polygon].two_sided ? 2 : 1;
        corners += piece->count;
    }
    return records <= PART_RECORDS_MAX && corners <= CORNERS_MAX;
}

/* Extents --------------------------------------------------------------------------------------- */

static void extent_add(struct extent *extent, const struct bsp *bsp, const struct bsp_piece *piece)
{
    for (size_t c = 0; c < piece->count; c++) {
        const double *at = bsp->edges.points->approx[bsp->corners[piece->first + c].point];
        for (int k = 0; k < 3; k++) {
            extent->low[k] = fmin(extent->low[k], at[k]);
            extent->high[k] = fmax(extent->high[k], at[k]);
        }
    }
}

/* Of the parts in the list. The caller frees them. */
static struct extent *extents_find(const struct bsp *bsp, const struct parts *parts, const uint32_t *list, size_t count,
                                   size_t *found)
{
    struct extent *extents = grow_zeroed(parts->count, sizeof *extents);
    for (size_t i = 0; i < parts->count; i++)
        for (int k = 0; k < 3; k++) {
            extents[i].low[k] = DBL_MAX;
            extents[i].high[k] = -DBL_MAX;
        }
    for (size_t i = 0; i < count; i++) {
        const uint32_t part = part_of(bsp, parts, list[i]);
        if (!part) continue;
        extents[part - 1].part = part;
        extent_add(&extents[part - 1], bsp, &bsp->pieces[list[i]]);
    }
    *found = 0;
    for (size_t i = 0; i < parts->count; i++)
        if (extents[i].part) extents[(*found)++] = extents[i];
    return extents;
}

/* The best cut of a mixed list ------------------------------------------------------------------ */

struct trial {
    struct bsp *bsp;
    const struct splitter *splitter;
    const struct parts *parts;
    const uint32_t *list;
    size_t count;
    struct sides sides;
    uint8_t *filed, *of_parts; /* where each piece is, and each part */
    uint32_t best;
    double least;
};

static bool ends(const struct trial *trial, const struct splitter_tally *tally)
{
    if (tally->on) return true;
    return tally->front && tally->back && tally->splits * CROSSING_SHARE <= trial->count;
}

/* Pieces of no part as they are, and each part as one. Returns what parts cost beside that. */
static double tally_of(struct trial *trial, struct splitter_tally *tally)
{
    double cost = 0.0;
    *tally = (struct splitter_tally){0};
    memset(trial->of_parts, 0, trial->parts->count);
    for (size_t i = 0; i < trial->count; i++) {
        const uint32_t part = part_of(trial->bsp, trial->parts, trial->list[i]);
        if (part) {
            trial->of_parts[part - 1] |= trial->filed[i];
            cost += trial->filed[i] == BSP_BOTH ? SPLIT_COST : 0.0;
            continue;
        }
        tally->on += trial->filed[i] == BSP_ON;
        tally->front += trial->filed[i] == BSP_FRONT;
        tally->back += trial->filed[i] == BSP_BACK;
        tally->splits += trial->filed[i] == BSP_BOTH;
    }
    for (size_t i = 0; i < trial->parts->count; i++) {
        tally->front += (trial->of_parts[i] & BSP_FRONT) != 0;
        tally->back += (trial->of_parts[i] & BSP_BACK) != 0;
        cost += trial->of_parts[i] == BSP_BOTH ? PARTED_COST : 0.0;
    }
    return cost;
}

static void try_group(struct trial *trial, uint32_t group)
{
    struct splitter_tally tally;
    sides_find(&trial->sides, group, trial->filed);
    const double beside = tally_of(trial, &tally);
    if (!ends(trial, &tally)) return;
    const enum plane_kind kind = bsp_plane(trial->bsp, group)->kind;
    const size_t weight = tally.on + tally.front + tally.back + tally.splits;
    const double cost = beside + splitter_cost(trial->splitter, kind, &tally, weight);
    if (cost >= trial->least) return;
    trial->least = cost;
    trial->best = group;
}

/* Planes of the pieces that belong to no part: evenly chosen, so many of them at most. */
static void try_planes(struct trial *trial, size_t others)
{
    const size_t affordable = TRIALS_A_NODE / trial->count, most = affordable < PLANES_MAX ? affordable : PLANES_MAX;
    const size_t wanted = most > PLANES_MIN ? most : PLANES_MIN, tries = others < wanted ? others : wanted;
    uint32_t before = BSP_NONE;
    for (size_t i = 0, at = 0, tried = 0; i < trial->count; i++) {
        const uint32_t polygon = trial->bsp->pieces[trial->list[i]].polygon;
        if (trial->parts->of[polygon]) continue;
        const uint32_t group = trial->bsp->coplanar->group[polygon];
        if (at++ != tried * others / tries) continue;
        if (tried++ && (deadline_passed() || group == before)) continue;
        try_group(trial, group);
        before = group;
    }
}

static void try_cuts(struct trial *trial)
{
    size_t count;
    struct extent *extents = extents_find(trial->bsp, trial->parts, trial->list, trial->count, &count);
    const size_t all = 6 * count, tries = all < CUTS_MAX ? all : CUTS_MAX;
    for (size_t i = 0; i < tries && !deadline_passed(); i++) {
        const size_t at = i * all / tries, axis = at % 3;
        const struct extent *extent = &extents[at / 6];
        const double d = at % 6 < 3 ? floor(extent->low[axis]) : ceil(extent->high[axis]);
        try_group(trial, bsp_cut(trial->bsp, (enum plane_kind)(PLANE_X + (int)axis), (int32_t)d));
    }
    free(extents);
}

uint32_t dense_cut_best(struct bsp *bsp, const struct splitter *splitter, const struct parts *parts,
                        const uint32_t *list, size_t count)
{
    struct trial trial = {.bsp = bsp,
                          .splitter = splitter,
                          .parts = parts,
                          .list = list,
                          .count = count,
                          .filed = grow_zeroed(count, 1),
                          .of_parts = grow_zeroed(parts->count, 1),
                          .best = BSP_NONE,
                          .least = DBL_MAX};
    sides_begin(&trial.sides, bsp, list, count);
    try_planes(&trial, count - dense_count(bsp, parts, list, count));
    try_cuts(&trial);
    sides_end(&trial.sides);
    free(trial.filed);
    free(trial.of_parts);
    return trial.best;
}

/* Cuts between parts ---------------------------------------------------------------------------- */

/* The way that extents are compared in: qsort() knows of no axis. */
static int compare_lows(const struct extent *a, const struct extent *b, int axis)
{
    return (a->low[axis] > b->low[axis]) - (a->low[axis] < b->low[axis]);
}
static int compare_x(const void *a, const void *b)
{
    return compare_lows(a, b, 0);
}
static int compare_y(const void *a, const void *b)
{
    return compare_lows(a, b, 1);
}
static int compare_z(const void *a, const void *b)
{
    return compare_lows(a, b, 2);
}

/* Whether the cut has pieces on both sides, and splits none. */
static bool parts_list(const struct bsp *bsp, const uint32_t *list, size_t count, uint32_t group)
{
    int met = BSP_ON;
    for (size_t i = 0; i < count; i++) {
        const int filed = bsp_piece_filed(bsp, &bsp->pieces[list[i]], group);
        if (filed == BSP_BOTH) return false;
        met |= filed;
    }
    return met == BSP_BOTH;
}

/* Halfway between `high`, where the extents so far end, and `low`, where the next one begins. false: one of them
 * reaches across. */
static bool gap_at(const struct bsp *bsp, double high, double low, int32_t *d)
{
    *d = (int32_t)lround((high + low) / 2.0);
    return high <= *d + bsp->tolerance_units && low >= *d - bsp->tolerance_units;
}

uint32_t dense_cut_apart(struct bsp *bsp, const struct parts *parts, const uint32_t *list, size_t count)
{
    static int (*const compare[])(const void *, const void *) = {compare_x, compare_y, compare_z};
    uint32_t best = BSP_NONE;
    size_t found, most = 0;
    struct extent *extents = extents_find(bsp, parts, list, count, &found);
    for (int axis = 0; axis < 3; axis++) {
        qsort(extents, found, sizeof *extents, compare[axis]);
        double high = -DBL_MAX;
        for (size_t i = 1; i < found; i++) {
            const size_t fewer = i < found - i ? i : found - i;
            int32_t d;
            high = fmax(high, extents[i - 1].high[axis]);
            if (fewer <= most || !gap_at(bsp, high, extents[i].low[axis], &d)) continue;
            const uint32_t cut = bsp_cut(bsp, (enum plane_kind)(PLANE_X + axis), d);
            if (!parts_list(bsp, list, count, cut)) continue;
            best = cut;
            most = fewer;
        }
    }
    free(extents);
    return best;
}
