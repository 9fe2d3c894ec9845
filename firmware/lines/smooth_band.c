/* SPDX-License-Identifier: MIT
 *
 * The polygons that cross a line are kept from near to far: what is nearer closes its samples first. Of retained lists,
 * which run from far to near, each is turned around as its line comes. */
#include "lines/active.h"
#include "lines/crowd.h"
#include "lines/layers.h"
#include "lines/overlaid.h"
#include "lines/paint.h"
#include "lines/share.h"
#include "lines/smooth.h"
#include "lines/smooth_run.h"
#include "lines/span.h"
#include "view/pass.h"

#if LIM_HAS_ANTIALIAS

static uint16_t turned_around(const struct lim_retained *retained, uint16_t polygon)
{
    uint16_t nearer = LIM_NONE;

    while (polygon != LIM_NONE) {
        union lim_retained_cell *cells = &retained->cells[polygon];
        const uint16_t next = cells[0].link.next;
        cells[0].link.next = nearer;
        nearer = polygon;
        polygon = next;
    }
    return nearer;
}

/* Merges those that start on a line into the list. false: no room. */
static bool smooth_activate(struct lim_paint *paint, const struct lim_spans *spans, const struct lim_retained *retained,
                            uint16_t polygon, uint16_t y)
{
    struct lim_active **link = &paint->actives.first;

    for (polygon = turned_around(retained, polygon); polygon != LIM_NONE;) {
        const union lim_retained_cell *cells = &retained->cells[polygon];
        struct lim_active *active = lim_active_new(&paint->actives, spans, y);
        if (!active) return false;
        while (*link && (*link)->polygon < polygon)
            link = &(*link)->next;
        active->next = *link;
        *link = active;
        link = &active->next;
        active->polygon = polygon;
        active->bottom = lim_retained_bottom(cells);
        active->colour = cells[1].look.colour;
        lim_active_join_crowd(&paint->actives, active, cells);
        *active->share = lim_smooth_share(active->colour);
        if (LIM_HAS_TEXTURE && lim_retained_has_texture(cells))
            lim_texture_set(paint->pass->texturing, cells[1].look.colour, lim_active_points(cells), cells[0].link.n,
                            active->gradients);
        lim_strip_begin(active->samples, cells[0].link.n, cells[0].link.first);
        polygon = cells[0].link.next;
    }
    return true;
}

static inline void set_look(struct lim_smooth_sink *sink, struct lim_active *active,
                            const union lim_retained_cell *cells, const struct lim_strip *strip)
{
    sink->colour = active->colour;
    sink->share = *active->share;
    if (!LIM_HAS_TEXTURE) return;
    sink->span->gradients = lim_retained_has_texture(cells) ? active->gradients : NULL;
    sink->span->left = lim_strip_first_px(strip);
    sink->span->right = lim_strip_end_px(strip);
}

/* What of a strip is open goes to the sink, or to the layers. false: no gap is left. */
static bool smooth_add_strip(struct lim_paint *paint, struct lim_spans *spans, struct lim_line *open,
                             struct lim_active *active, const union lim_retained_cell *cells,
                             const struct lim_strip *strip, struct lim_smooth_sink *sink)
{
    if (LIM_HAS_TRANSPARENT && lim_retained_alpha(cells) != LIM_OPAQUE) {
        if (LIM_HAS_MASKED)
            lim_layers_mask(paint->layers, lim_retained_has_texture(cells) ? active->gradients : NULL,
                            lim_strip_first_px(strip), lim_strip_end_px(strip));
        lim_smooth_push(paint->layers, spans, open, strip, cells[1].look.colour, lim_retained_alpha(cells));
        return true;
    }
    set_look(sink, active, cells, strip);
    return lim_strips_close(spans, open, strip->left, strip->right, lim_smooth_mix, sink) != LIM_SPAN_EXHAUSTED;
}

/* The same of some pixels of a polygon whose edges are still on the line. */
struct smooth_cut {
    struct lim_paint *paint;
    struct lim_spans *spans;
    const struct lim_retained *retained;
    struct lim_line *open;
    struct lim_smooth_sink *sink;
    int16_t y;
    bool fits;
};

static lim_crowd_part smooth_add_part;
static LIM_IF_CALLED void smooth_add_part(void *ctx, struct lim_active *active, int32_t x0, int32_t x1)
{
    struct smooth_cut *const cut = ctx;
    const union lim_retained_cell *cells = &cut->retained->cells[active->polygon];
    const struct lim_strip within = {lim_bound_at(x0 * LIM_SAMPLES_A_ROW), lim_bound_at(x1 * LIM_SAMPLES_A_ROW)};
    struct lim_sample_edges edges = *active->samples;
    const struct lim_strip whole = lim_smooth_strip(&edges, active, cells, cut->y);
    const struct lim_strip strip = lim_strip_common(&whole, &within);

    if (!lim_line_is_closed(cut->open))
        cut->fits &= smooth_add_strip(cut->paint, cut->spans, cut->open, active, cells, &strip, cut->sink);
}

/* false: no gap is left; edges have gone on all the same. */
static bool smooth_polygons(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                            struct lim_line *open, int16_t y, struct lim_smooth_sink *sink)
{
    const struct lim_gap within = open->gap;
    const int16_t below = (int16_t)((y + 1) * LIM_SAMPLE_ROWS);
    struct lim_active **link = &paint->actives.first, *active;
    const bool is_cut = lim_crowd_cuts(&paint->actives);
    struct smooth_cut cut = {paint, spans, retained, open, sink, y, true};

    if (LIM_HAS_MOVERS && is_cut) lim_crowd_paint(&paint->actives, &within, smooth_add_part, &cut);
    while ((active = *link) != NULL) {
        const union lim_retained_cell *cells = &retained->cells[active->polygon];
        const struct lim_strip strip = lim_smooth_strip(active->samples, active, cells, y);
        if (!lim_line_is_closed(open) && !is_cut)
            cut.fits &= smooth_add_strip(paint, spans, open, active, cells, &strip, sink);
        if ((int16_t)active->bottom > below)
            link = &active->next;
        else
            lim_active_give_back(&paint->actives, link);
    }
    return cut.fits;
}

/* A line that is lent, and will be painted anew. */
static LIM_IF_CALLED int smooth_stop(struct lim_paint *paint, const struct lim_smooth_sink *sink,
                                     struct lim_paint_stop *stop, enum lim_paint_pool exhausted)
{
    for (uint16_t x = 0; exhausted == LIM_PAINT_ACTIVE && x < paint->pass->target.w_px; x++)
        sink->sums[x] = 0;
    if (LIM_HAS_TRANSPARENT) paint->layers->used = 0;
    *paint->lent = sink->line;
    return lim_paint_stops(stop, exhausted);
}

/* What stays open. */
static void smooth_background(const struct lim_paint *paint, const struct lim_spans *spans, const struct lim_line *open,
                              struct lim_smooth_sink *sink)
{
    struct lim_stats *stats = lim_stats_of(paint->pass);

    if (LIM_HAS_STATS) stats->pixels_painted += sink->painted_px;
    sink->painted_px = 0;
    sink->colour = paint->background;
    sink->share = lim_smooth_share(paint->background);
    if (LIM_HAS_TEXTURE) sink->span->gradients = NULL;
    for (uint16_t at = open->gap.next; at != LIM_NONE; at = (*spans->strips)[at].next)
        lim_strip_to_sink(lim_smooth_mix, sink, &(*spans->strips)[at].open.left, &(*spans->strips)[at].open.right);
    if (LIM_HAS_STATS) stats->pixels_background += sink->painted_px;
}

static int smooth_line(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                       const struct lim_rect *band, struct lim_paint_stop *stop)
{
    const uint16_t y = stop->y;
    const struct lim_target *target = &paint->pass->target;
    struct lim_stats *stats = lim_stats_of(paint->pass);
    struct lim_smooth_sink sink = {.line = NULL, .sums = paint->smooth->sums};
    struct lim_line open;

    lim_line_open(&open, target, band, y);
    if (!lim_crowd_line(paint, spans, retained, &open.gap, y, LIM_CROWD_SAMPLES))
        return lim_paint_stops(stop, LIM_PAINT_ACTIVE);
    sink.line = lim_paint_lend(paint, y);
    if (!sink.line) return LIM_ERR_TARGET;
    const uint16_t x0 = open.gap.x0, x1 = open.gap.x1;
    if (LIM_HAS_TEXTURE) {
        sink.span->texturing = paint->pass->texturing;
        sink.span->y = y;
        *sink.stats = stats;
    }
    if (LIM_HAS_MASKED) lim_layers_begin(paint->layers, paint->pass->texturing, y);
    lim_actives_count(&paint->actives, spans, stats, y);
    if (LIM_HAS_TRANSPARENT) lim_layers_open_own(paint->layers);
    lim_spans_reset_pool(spans);
    if (x0 < x1) (void)lim_strips_begin(spans, &open);
    const bool fits = smooth_polygons(paint, spans, retained, &open, (int16_t)y, &sink);
    if (LIM_HAS_MOVERS && !fits) return smooth_stop(paint, &sink, stop, LIM_PAINT_ACTIVE);
    smooth_background(paint, spans, &open, &sink);
    if (LIM_HAS_TRANSPARENT && !lim_layers_finish(paint->layers, sink.line, stats))
        return smooth_stop(paint, &sink, stop, LIM_PAINT_LAYERS);
    lim_overlay_line(paint->pass, sink.line, y, x0, x1);
    return target->done(target->ctx, y, x0, (uint16_t)(x1 - x0));
}

/* Whether the cells end before the gaps that a line takes. Pass one may have filled all, if it divided no gap. */
static bool leaves_gaps(const struct lim_spans *spans)
{
    return lim_share_gap_behind(spans, spans->retained->used * lim_share_cell_b(spans)) <= spans->lowest;
}

/* Each polygon divides a gap at most. What pass one has closed has had room for its gaps; but by scan lines it closes
 * none. */
static bool line_fits(const struct lim_paint *paint, const struct lim_spans *spans)
{
    return !LIM_IS_SCANLINE(&paint->pass->target) || paint->actives.fresh < *spans->kept;
}

int lim_smooth_band(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                    const struct lim_rect *band, struct lim_paint_stop *stop)
{
    bool fits = leaves_gaps(spans);
    int err = 0;

    lim_actives_start(&paint->actives, spans, true);
    stop->y = band->y0;
    while (fits && stop->y < band->y1) {
        fits = smooth_activate(paint, spans, retained, spans->lines[stop->y].retained, stop->y);
        if (!fits) break;
        uint16_t lines = lim_smooth_run(paint, spans, retained, band, stop->y, &err);
        if (!err && !lines) {
            fits = line_fits(paint, spans);
            if (!fits) break;
            err = smooth_line(paint, spans, retained, band, stop);
            lines = 1;
        }
        if (err || stop->exhausted) return err;
        stop->y = (uint16_t)(stop->y + lines);
    }
    return lim_paint_stops(stop, fits ? LIM_PAINT_FITS : LIM_PAINT_ACTIVE);
}

#endif
