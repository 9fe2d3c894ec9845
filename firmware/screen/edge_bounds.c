/* SPDX-License-Identifier: MIT
 *
 * Which lines a polygon takes, and whether rounding has made it non-monotone: of many corners, and where they turn. */
#include "screen/edge.h"

/* A non-monotone polygon has more than one local extreme of either kind, a low one a line below a high one as a rule.
 * Where the extra ones lie near its top, a fan from the bottom sees every other corner, and the other way round. */
static LIM_RARE uint8_t choose_apex(const struct lim_point *at, uint8_t n, uint8_t top_at, lim_edge_sub bottom)
{
    const lim_edge_sub top = lim_edge_row(at[top_at].y);
    lim_edge_sub lowest_top = top, after = lim_edge_row(at[1].y), here = lim_edge_row(at[0].y);
    uint8_t bottom_at = 0;

    for (uint_fast8_t k = n; k-- > 0;) {
        const lim_edge_sub before = lim_edge_row(at[k].y);
        if (here <= before && here <= after && here > lowest_top) lowest_top = here;
        if (before == bottom) bottom_at = (uint8_t)k;
        after = here;
        here = before;
    }
    return 2 * lowest_top + 1 < top + bottom ? bottom_at : top_at;
}

/* A plain polygon's boundary goes down from its top to its bottom once; what goes farther is non-monotone. */
static LIM_RARE void find_turns(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n)
{
    const lim_edge_sub top = (lim_edge_sub)(shape->top - LIM_ORIGIN_PX);
    const lim_edge_sub bottom = (lim_edge_sub)(shape->bottom - LIM_ORIGIN_PX);
    lim_edge_sub before = lim_edge_row(at[n - 1].y), down = 0;
    uint8_t top_at = n;

    for (uint8_t k = 0; k < n; k++) {
        const lim_edge_sub row = lim_edge_row(at[k].y);

        if (row > before) down = (lim_edge_sub)(down + (row - before));
        if (row == top && top_at == n) top_at = k;
        before = row;
    }
    shape->first = top_at;
    shape->non_monotone = down > bottom - top;
    if (shape->non_monotone) shape->apex = choose_apex(at, n, top_at, bottom);
}

lim_edge_sub lim_edge_bounds_down(struct lim_edge_span *span, const struct lim_point *at, uint8_t n)
{
    lim_edge_sub before = lim_edge_level(at[n - 1].y), down = 0;

    span->top = span->bottom = lim_edge_level(at[0].y);
    span->first = 0;
    for (uint8_t k = 0; k < n; k++) {
        const lim_edge_sub y = lim_edge_level(at[k].y);
        if (y > before) down = (lim_edge_sub)(down + (y - before));
        lim_edge_span_add(span, y, k);
        before = y;
    }
    return down;
}

void lim_edge_bounds(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n)
{
    if (!lim_edge_bounds_plain(shape, at, n)) find_turns(shape, at, n);
}
