/* SPDX-License-Identifier: MIT
 *
 * Every candidate is tried on the list; then, from the one that the splitter's weights alone find cheapest, what it
 * leaves in rings is found as well, until these weights alone are dearer than the best so far. What is in no ring of
 * the list is in none of a part of it, and is left out from the beginning. */
#include "trees/cluster_cut.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "trees/axis_cut.h"
#include "trees/sides.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

enum { CUTS_AN_AXIS = 24, PLANES_MAX = 96, CROSSING_SHARE = 8 };

/* Of a polygon left in a ring, in polygons of imbalance: more makes smaller trees that draw more behind walls. */
static const double RING_COST = 4.0;

/* A plane, what it costs by the splitter's weights alone, and its place among the candidates. */
struct candidate {
    double cost;
    uint32_t group, at;
};

/* What trying needs: the candidates with the sides that pieces have, the best so far, the list's pieces in rings, and a
 * set of polygons for each side. */
struct trial {
    struct bsp *bsp;
    const struct splitter *splitter;
    struct rings *rings;
    const uint32_t *list;
    size_t count, candidate_count;
    struct candidate candidates[3 * CUTS_AN_AXIS + PLANES_MAX];
    struct sides sides;
    uint8_t *filed; /* `count` for each candidate */
    uint32_t *ringed;
    size_t ringed_count;
    uint64_t *front, *back;
    const struct candidate *best;
    double least;
};

/* A cut must take something from either side; a polygon's plane takes that polygon. */
static bool ends(const struct trial *trial, const struct splitter_tally *tally)
{
    if (tally->on) return true;
    return tally->front && tally->back && tally->splits * CROSSING_SHARE <= trial->count;
}

static void add(struct trial *trial, uint32_t group)
{
    const uint32_t at = (uint32_t)trial->candidate_count;
    uint8_t *filed = trial->filed + at * trial->count;
    size_t with[BSP_BOTH + 1] = {0};
    sides_find(&trial->sides, group, filed);
    for (size_t i = 0; i < trial->count; i++)
        with[filed[i]]++;
    const struct splitter_tally tally = {
        .splits = with[BSP_BOTH], .front = with[BSP_FRONT], .back = with[BSP_BACK], .on = with[BSP_ON]};
    if (!ends(trial, &tally)) return;
    const enum plane_kind kind = bsp_plane(trial->bsp, group)->kind;
    trial->candidates[trial->candidate_count++] =
        (struct candidate){splitter_cost(trial->splitter, kind, &tally, trial->count), group, at};
}

static void add_cuts(struct trial *trial, int axis)
{
    int32_t at[CUTS_AN_AXIS];
    const size_t tries = axis_cut_candidates(trial->bsp, trial->list, trial->count, axis, CUTS_AN_AXIS, at);
    for (size_t i = 0; i < tries && !deadline_passed(); i++)
        if (!i || at[i] != at[i - 1]) add(trial, bsp_cut(trial->bsp, (enum plane_kind)(PLANE_X + axis), at[i]));
}

static int compare_candidates(const void *a, const void *b)
{
    const struct candidate *x = a, *y = b;
    if (x->cost != y->cost) return x->cost < y->cost ? -1 : 1;
    return x->at < y->at ? -1 : 1;
}

/* What a candidate leaves in rings on either side. */
static size_t rings_beside(const struct trial *trial, const struct candidate *candidate)
{
    const struct hiding *hiding = &trial->rings->hiding;
    const uint8_t *filed = trial->filed + candidate->at * trial->count;
    memset(trial->front, 0, hiding->words * sizeof *trial->front);
    memset(trial->back, 0, hiding->words * sizeof *trial->back);
    for (size_t i = 0; i < trial->ringed_count; i++) {
        const uint32_t at = trial->ringed[i], polygon = trial->bsp->pieces[trial->list[at]].polygon;
        if (filed[at] & BSP_FRONT) hiding_add(hiding, trial->front, polygon);
        if (filed[at] & BSP_BACK) hiding_add(hiding, trial->back, polygon);
    }
    return rings_left(trial->rings, trial->front) + rings_left(trial->rings, trial->back);
}

/* Of two that cost the same the first candidate. */
static void look_closer(struct trial *trial, const struct candidate *candidate)
{
    const double cost = candidate->cost + RING_COST * (double)rings_beside(trial, candidate);
    if (cost > trial->least || (cost == trial->least && candidate->at > trial->best->at)) return;
    trial->least = cost;
    trial->best = candidate;
}

static void find_ringed(struct trial *trial)
{
    const struct hiding *hiding = &trial->rings->hiding;
    for (size_t i = 0; i < trial->count; i++)
        hiding_add(hiding, trial->front, trial->bsp->pieces[trial->list[i]].polygon);
    rings_prepare(trial->rings, trial->front);
    for (size_t i = 0; i < trial->count; i++)
        if (hiding_has(hiding, trial->front, trial->bsp->pieces[trial->list[i]].polygon))
            trial->ringed[trial->ringed_count++] = (uint32_t)i;
}

static void add_candidates(struct trial *trial)
{
    for (int axis = 0; axis < 3; axis++)
        add_cuts(trial, axis);
    const size_t tries = trial->count < PLANES_MAX ? trial->count : PLANES_MAX;
    for (size_t i = 0; i < tries && !(i && deadline_passed()); i++)
        add(trial, trial->bsp->coplanar->group[trial->bsp->pieces[trial->list[i * trial->count / tries]].polygon]);
    qsort(trial->candidates, trial->candidate_count, sizeof *trial->candidates, compare_candidates);
}

static void trial_begin(struct trial *trial)
{
    sides_begin(&trial->sides, trial->bsp, trial->list, trial->count);
    trial->filed = grow_zeroed((3 * CUTS_AN_AXIS + PLANES_MAX) * trial->count, 1);
    trial->ringed = grow_zeroed(trial->count, sizeof *trial->ringed);
    trial->front = grow_zeroed(trial->rings->hiding.words, sizeof *trial->front);
    trial->back = grow_zeroed(trial->rings->hiding.words, sizeof *trial->back);
    find_ringed(trial);
}

static void trial_end(struct trial *trial)
{
    sides_end(&trial->sides);
    free(trial->filed);
    free(trial->ringed);
    free(trial->front);
    free(trial->back);
}

uint32_t cluster_cut_best(struct bsp *bsp, const struct splitter *splitter, struct rings *rings, const uint32_t *list,
                          size_t count)
{
    struct trial trial = {
        .bsp = bsp, .splitter = splitter, .rings = rings, .list = list, .count = count, .least = DBL_MAX};
    trial_begin(&trial);
    add_candidates(&trial);
    for (size_t i = 0; i < trial.candidate_count && trial.candidates[i].cost <= trial.least; i++)
        if (!i || !deadline_passed()) look_closer(&trial, &trial.candidates[i]);
    trial_end(&trial);
    return trial.best->group;
}
