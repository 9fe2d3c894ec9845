/* SPDX-License-Identifier: MIT
 *
 * Nearest first, pass one: a band before its first polygon, and what its pools took. */
#include "lines/gaps.h"
#include "lines/retain.h"
#include "lines/share.h"
#include "lines/span.h"
#include "orders/nearest.h"
#include "view/pass.h"
#include "view/view.h"

#if LIM_HAS_SPANS

/* Scan lines retain every polygon in view, and paint from far to near; not bands of one line, of which there are only
 * where memory is scarce: any number of polygons lie behind one another at a pixel, and the least pools hold one. */
static inline bool can_retain_all(const struct lim_nearest *nearest, const struct lim_rect *band)
{
    if (!LIM_IS_SCANLINE(&nearest->pass->target) || band->y1 - band->y0 <= 1) return false;
    return lim_nearest_may_retain_all(nearest);
}

void lim_nearest_open(struct lim_nearest *nearest, const struct lim_rect *band)
{
    if (LIM_HAS_ANTIALIAS) *nearest->spans.has_strips = lim_is_antialiased(&nearest->pass->view);
    lim_retained_clear(&nearest->retained);
    lim_spans_open(&nearest->spans, &nearest->pass->target, band);
    nearest->since_shrink = 0;
    nearest->top = band->y0;
    nearest->bottom = band->y1;
    if (LIM_HAS_MOVERS) lim_open_pixel(nearest, band);
    if (LIM_HAS_SCANLINE) nearest->retains_all = can_retain_all(nearest, band);
    nearest->retained.size = nearest->retained.end;
    if (LIM_HAS_FENCE && !lim_nearest_retains_all(nearest))
        nearest->retained.size = lim_share_cells_before_fence(&nearest->retained);
    lim_share_set_lowest(&nearest->spans);
}

void lim_nearest_note_pools(struct lim_nearest *nearest)
{
    struct lim_stats *stats = lim_stats_of(nearest->pass);
    const uint16_t gaps = (uint16_t)(lim_share_gaps_end(&nearest->spans) - nearest->spans.fresh);

    if (!LIM_HAS_STATS) return;
    if (nearest->retained.used > stats->retained_cells_max) stats->retained_cells_max = nearest->retained.used;
    if (gaps > stats->gaps_max) stats->gaps_max = gaps;
}

#endif
