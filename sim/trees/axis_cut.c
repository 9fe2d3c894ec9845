/* SPDX-License-Identifier: MIT
 *
 * Candidates are whole units: the polygons' coordinates are rounded to them in the end, and a plane through
 * vertices splits nothing at them. */
#include "trees/axis_cut.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "long.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { CROSSING_SHARE = 8, CANDIDATES_MAX = 48, CUBE_END = 32768, CELL_MIN_UNITS = 16 };

static struct splitter_tally tally_of(const struct bsp *bsp, const uint32_t *list, size_t count, uint32_t group)
{
    struct splitter_tally tally = {0};
    for (size_t i = 0; i < count; i++) {
        const int sides = bsp_piece_filed(bsp, &bsp->pieces[list[i]], group);
        tally.front += sides == BSP_FRONT;
        tally.back += sides == BSP_BACK;
        tally.splits += sides == BSP_BOTH;
    }
    return tally;
}

/* Where many pieces lie across a cut, their own planes divide them better; and one side must not keep nearly all:
 * otherwise lists would grow faster than they are divided. */
static bool pays(struct splitter_tally tally, size_t count)
{
    const size_t larger = (tally.front > tally.back ? tally.front : tally.back) + tally.splits;
    return tally.splits * CROSSING_SHARE <= count && larger * 4 <= count * 3;
}

/* Best cut ----------------------------------------------------------------------------------- */

static int compare_s32(const void *a, const void *b)
{
    const int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;
    return (x > y) - (x < y);
}

/* Both ends of each piece along an axis, rounded and in order. The caller frees them. */
static int32_t *ends_along(const struct bsp *bsp, const uint32_t *list, size_t count, int axis)
{
    int32_t *ends = grow_zeroed(2 * count, sizeof *ends);
    for (size_t i = 0; i < count; i++) {
        const struct bsp_piece *piece = &bsp->pieces[list[i]];
        double low = DBL_MAX, high = -DBL_MAX;
        for (size_t k = 0; k < piece->count; k++) {
            const double at = bsp->edges.points->approx[bsp->corners[piece->first + k].point][axis];
            low = fmin(low, at);
            high = fmax(high, at);
        }
        ends[2 * i] = (int32_t)lround(low);
        ends[2 * i + 1] = (int32_t)lround(high);
    }
    qsort(ends, 2 * count, sizeof *ends, compare_s32);
    return ends;
}

size_t axis_cut_candidates(const struct bsp *bsp, const uint32_t *list, size_t count, int axis, size_t most,
                           int32_t *out)
{
    int32_t *ends = ends_along(bsp, list, count, axis);
    const size_t tries = 2 * count < most ? 2 * count : most;
    for (size_t i = 0; i < tries; i++)
        out[i] = ends[i * 2 * count / tries];
    free(ends);
    return tries;
}

uint32_t axis_cut_best(struct bsp *bsp, const struct splitter *splitter, const uint32_t *list, size_t count,
                       double *least)
{
    uint32_t best = BSP_NONE;
    *least = DBL_MAX;
    for (int axis = 0; axis < 3; axis++) {
        int32_t at[CANDIDATES_MAX];
        const size_t tries = axis_cut_candidates(bsp, list, count, axis, CANDIDATES_MAX, at);
        for (size_t i = 0; i < tries && !deadline_passed(); i++) {
            const uint32_t cut = bsp_cut(bsp, (enum plane_kind)(PLANE_X + axis), at[i]);
            const struct splitter_tally tally = tally_of(bsp, list, count, cut);
            const double cost = splitter_cost(splitter, PLANE_X, &tally, count);
            if (!pays(tally, count) || cost >= *least) continue;
            best = cut;
            *least = cost;
        }
    }
    return best;
}

/* Halving ------------------------------------------------------------------------------------ */

struct cell {
    int32_t low[3], high[3];
    size_t cuts; /* that led to it */
};

/* Narrowed by the cuts above; polygons' planes do not count. */
static struct cell cell_of(const struct bsp *bsp, struct bsp_place place)
{
    const int32_t end = bsp->mesh->grid.is_long ? LIM_LONG_END : CUBE_END;
    struct cell cell = {{-end, -end, -end}, {end, end, end}, 0};
    for (; place.parent != BSP_NONE;
         place = (struct bsp_place){bsp->nodes[place.parent].parent, bsp->nodes[place.parent].in_front}) {
        const uint32_t group = bsp->nodes[place.parent].group;
        if (group < bsp->coplanar->count) continue;
        const struct plane *plane = bsp_plane(bsp, group);
        const int axis = (int)plane->kind - PLANE_X;
        const int32_t d = (int32_t)plane->d;
        if (place.in_front && d > cell.low[axis]) cell.low[axis] = d;
        if (!place.in_front && d < cell.high[axis]) cell.high[axis] = d;
        cell.cuts++;
    }
    return cell;
}

/* Halves are left out where all pieces lie in one: no node is worth that. */
uint32_t axis_cut_halving(struct bsp *bsp, struct bsp_place place, const uint32_t *list, size_t count)
{
    struct cell cell = cell_of(bsp, place);
    for (size_t step = cell.cuts;; step++) {
        const int axis = (int)(step % 3);
        const int32_t middle = cell.low[axis] + (cell.high[axis] - cell.low[axis]) / 2;
        if (cell.high[axis] - cell.low[axis] < CELL_MIN_UNITS) return BSP_NONE;
        const uint32_t cut = bsp_cut(bsp, (enum plane_kind)(PLANE_X + axis), middle);
        const struct splitter_tally tally = tally_of(bsp, list, count, cut);
        if (tally.front + tally.splits && tally.back + tally.splits)
            return tally.splits * CROSSING_SHARE <= count ? cut : BSP_NONE;
        if (tally.front)
            cell.low[axis] = middle;
        else
            cell.high[axis] = middle;
    }
}
