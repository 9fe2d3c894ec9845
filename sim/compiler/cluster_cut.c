/* SPDX-License-Identifier: MIT
 *
 * Every candidate is tried on the list; those that the splitter's weights alone find dearer than the best so far are
 * not looked at any closer. */
#include "compiler/cluster_cut.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "compiler/axis_cut.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

enum { CUTS_AN_AXIS = 24, PLANES_MAX = 96, CROSSING_SHARE = 8 };

/* Of a polygon left in a ring, in polygons of imbalance: more makes smaller trees that draw more behind walls. */
static const double RING_COST = 4.0;

/* What trying needs: the best so far, and a set of polygons for each side. */
struct trial {
    struct bsp *bsp;
    const struct splitter *splitter;
    const struct rings *rings;
    const uint32_t *list;
    size_t count;
    uint64_t *front, *back;
    uint32_t best;
    double least;
};

static void add(uint64_t *set, uint32_t polygon)
{
    set[polygon / 64] |= UINT64_C(1) << polygon % 64;
}

/* Fills the sets. */
static struct splitter_tally divide(const struct trial *trial, uint32_t group)
{
    const struct bsp *bsp = trial->bsp;
    const struct plane *plane = bsp_plane(bsp, group);
    struct splitter_tally tally = {0};
    memset(trial->front, 0, trial->rings->words * sizeof *trial->front);
    memset(trial->back, 0, trial->rings->words * sizeof *trial->back);
    for (size_t i = 0; i < trial->count; i++) {
        const struct bsp_piece *piece = &bsp->pieces[trial->list[i]];
        if (bsp->coplanar->group[piece->polygon] == group) {
            tally.on++;
            continue;
        }
        const int sides = bsp_piece_filed(bsp, piece, plane);
        if (sides & BSP_FRONT) add(trial->front, piece->polygon);
        if (sides & BSP_BACK) add(trial->back, piece->polygon);
        tally.front += sides == BSP_FRONT;
        tally.back += sides == BSP_BACK;
        tally.splits += sides == BSP_BOTH;
    }
    return tally;
}

/* A cut must take something from either side; a polygon's plane takes that polygon. */
static bool ends(const struct trial *trial, const struct splitter_tally *tally)
{
    if (tally->on) return true;
    return tally->front && tally->back && tally->splits * CROSSING_SHARE <= trial->count;
}

static void try(struct trial *trial, uint32_t group)
{
    const struct splitter_tally tally = divide(trial, group);
    double cost = splitter_cost(trial->splitter, bsp_plane(trial->bsp, group)->kind, &tally, trial->count);
    if (!ends(trial, &tally) || cost >= trial->least) return;
    cost += RING_COST * (double)(rings_left(trial->rings, trial->front) + rings_left(trial->rings, trial->back));
    if (cost >= trial->least) return;
    trial->least = cost;
    trial->best = group;
}

static void try_cuts(struct trial *trial, int axis)
{
    int32_t at[CUTS_AN_AXIS];
    const size_t tries = axis_cut_candidates(trial->bsp, trial->list, trial->count, axis, CUTS_AN_AXIS, at);
    for (size_t i = 0; i < tries && !deadline_passed(); i++)
        if (!i || at[i] != at[i - 1]) try(trial, bsp_cut(trial->bsp, (enum plane_kind)(PLANE_X + axis), at[i]));
}

uint32_t cluster_cut_best(struct bsp *bsp, const struct splitter *splitter, const struct rings *rings,
                          const uint32_t *list, size_t count)
{
    struct trial trial = {bsp, splitter, rings, list, count, NULL, NULL, BSP_NONE, DBL_MAX};
    trial.front = grow_zeroed(rings->words, sizeof *trial.front);
    trial.back = grow_zeroed(rings->words, sizeof *trial.back);
    for (int axis = 0; axis < 3; axis++)
        try_cuts(&trial, axis);
    const size_t tries = count < PLANES_MAX ? count : PLANES_MAX;
    for (size_t i = 0; i < tries && !(i && deadline_passed()); i++)
        try(&trial, bsp->coplanar->group[bsp->pieces[list[i * count / tries]].polygon]);
    free(trial.front);
    free(trial.back);
    return trial.best;
}
