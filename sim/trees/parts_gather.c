/* SPDX-License-Identifier: MIT
 *
 * Rounds of a sweep along x, as boxes grow by what joins them; most things are found in the first. */
#include "trees/parts_gather.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>

enum { ROUNDS_MAX = 8 };
static const double OVERLAP_SHARE = 1.0 / 16.0; /* of the smaller one's box */
static const double SCENE_SHARE = 0.5;          /* of the model's diagonal */
static const double THINNEST_UNITS = 1.0;       /* a flat box counts as so thick */

struct swept {
    double low; /* where its box begins */
    uint32_t leader;
};

struct sweep {
    struct survey *surveys;
    uint32_t *leaders;
    struct swept *order;
    size_t count;
    double most; /* the longest diagonal of what gathers others */
};

static double size_of(const struct survey *survey)
{
    return parts_diagonal(survey->part.low, survey->part.high);
}

static double overlap_share(const struct part *small, const struct part *large)
{
    double share = 1.0;
    for (int k = 0; k < 3; k++) {
        const double low = fmax(small->low[k], large->low[k]), high = fmin(small->high[k], large->high[k]);
        const double side = fmax(small->high[k] - small->low[k], THINNEST_UNITS);
        if (high < low) return 0.0;
        share *= fmin(fmax(high - low, THINNEST_UNITS) / side, 1.0);
    }
    return share;
}

static struct survey together(const struct survey *a, const struct survey *b)
{
    struct survey out = *a;
    for (int k = 0; k < 3; k++) {
        out.part.low[k] = fmin(a->part.low[k], b->part.low[k]);
        out.part.high[k] = fmax(a->part.high[k], b->part.high[k]);
    }
    out.part.polygons += b->part.polygons;
    out.records += b->records;
    out.largest = fmax(a->largest, b->largest);
    return out;
}

static bool try_join(struct sweep *sweep, uint32_t p, uint32_t q)
{
    const uint32_t first = p < q ? p : q, second = p < q ? q : p;
    struct survey *a = &sweep->surveys[first], *b = &sweep->surveys[second];
    const bool a_is_large = size_of(a) >= size_of(b);
    const struct survey *large = a_is_large ? a : b, *small = a_is_large ? b : a;
    if (size_of(large) > sweep->most || overlap_share(&small->part, &large->part) < OVERLAP_SHARE) return false;
    const struct survey both = together(a, b);
    if (both.records > PART_RECORDS_MAX || both.largest > PARTS_LARGEST_SHARE * size_of(&both)) return false;
    *a = both;
    b->part.polygons = 0;
    sweep->leaders[second] = first;
    return true;
}

static int compare_lows(const void *a, const void *b)
{
    const struct swept *p = a, *q = b;
    if (p->low != q->low) return p->low < q->low ? -1 : 1;
    return p->leader < q->leader ? -1 : 1;
}

static bool sweep_once(struct sweep *sweep)
{
    bool joined = false;
    for (size_t i = 0; i < sweep->count; i++)
        sweep->order[i].low = sweep->surveys[sweep->order[i].leader].part.low[0];
    qsort(sweep->order, sweep->count, sizeof *sweep->order, compare_lows);
    for (size_t i = 0; i < sweep->count; i++) {
        const struct survey *survey = &sweep->surveys[sweep->order[i].leader];
        for (size_t k = i + 1; k < sweep->count && survey->part.polygons; k++) {
            if (sweep->order[k].low > survey->part.high[0]) break;
            if (sweep->surveys[sweep->order[k].leader].part.polygons)
                joined |= try_join(sweep, sweep->order[i].leader, sweep->order[k].leader);
        }
    }
    return joined;
}

static void drop_joined(struct sweep *sweep)
{
    size_t kept = 0;
    for (size_t i = 0; i < sweep->count; i++)
        if (sweep->surveys[sweep->order[i].leader].part.polygons) sweep->order[kept++] = sweep->order[i];
    sweep->count = kept;
}

void parts_gather(struct survey *surveys, uint32_t *leaders, size_t polygon_count)
{
    struct sweep sweep = {surveys, leaders, grow_zeroed(polygon_count, sizeof *sweep.order), 0, 0.0};
    struct survey all = {.largest = 0.0};
    for (uint32_t i = 0; i < polygon_count; i++) {
        if (!surveys[i].part.polygons) continue;
        all = sweep.count ? together(&all, &surveys[i]) : surveys[i];
        sweep.order[sweep.count++].leader = i;
    }
    sweep.most = SCENE_SHARE * size_of(&all);
    for (int round = 0; round < ROUNDS_MAX && sweep_once(&sweep); round++)
        drop_joined(&sweep);
    free(sweep.order);
}
