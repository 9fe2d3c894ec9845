/* SPDX-License-Identifier: MIT
 *
 * Nearest first. Pass one walks the tree, closes gaps, and retains the polygons that closed some;
 * pass two paints them line by line. When a pool is exhausted, the frame is finished in bands: the
 * same two passes over half the lines, a quarter, one line, half a line. A band of one pixel needs
 * one polygon and no gap, so every frame ends. */
#include "order.h"

#include "layers.h"
#include "piece.h"
#include "project.h"

#if LIM_HAS_SPANS

enum { POLYGONS_PER_SHRINK = 20 }; /* the open view is drawn together this often */

/* SPAN for one polygon that is not folded. look: of its pieces for the sink, or NULL. */
static inline enum lim_span_result close_lines(struct lim_spans *spans, const struct lim_screen_polygon *polygon,
                                               int16_t top, int16_t bottom, lim_span_sink *sink,
                                               struct lim_piece_look *look)
{
    struct lim_edge_pair pair;
    uint8_t result = LIM_SPAN_NOTHING;
    int16_t y = top;

    lim_edge_begin(&pair, polygon->n, polygon->shape.first);
    while (y < bottom) {
        const int16_t turn = lim_edge_turn(&pair, polygon->at, polygon->n, y);
        const int16_t end = turn < bottom ? turn : bottom;
        for (;;) {
            if (pair.left.x < pair.right.x) {
                if (look) look->y_px = (uint16_t)y;
                result |= (uint8_t)lim_span_close(spans, &spans->lines[y], pair.left.x, pair.right.x, sink, look);
            }
            if (++y == end) break;
            lim_edge_step(&pair.left);
            lim_edge_step(&pair.right);
        }
        if (pair.left.end > turn) lim_edge_step(&pair.left);
        if (pair.right.end > turn) lim_edge_step(&pair.right);
    }
    return result & LIM_SPAN_EXHAUSTED ? LIM_SPAN_EXHAUSTED : (enum lim_span_result)result;
}

/* take_plain() for a polygon that is measured by its samples: it is retained up to a row of them. */
static inline bool take_samples(struct lim *lim, const struct lim_screen_polygon *polygon, int16_t top, int16_t bottom)
{
#if LIM_HAS_ANTIALIAS
    const int16_t rows = (int16_t)(bottom * LIM_SAMPLE_ROWS);

    if (lim->paint.smooth.line) {
        lim_smooth_add_polygon(lim, polygon);
        return true;
    }
    const enum lim_span_result result = lim_smooth_close(&lim->spans, polygon, top, bottom);
    if (result != LIM_SPAN_SOME) return result == LIM_SPAN_NOTHING;
    if (LIM_HAS_STATS) lim_stats_of(lim)->polygons_seen++;
    const struct lim_retained_polygon seen =
        lim_retained_of(polygon, top, polygon->shape.end_row < rows ? polygon->shape.end_row : rows, false);
    return lim_retain(&lim->retained, lim->spans.lines, &seen);
#else
    (void)lim, (void)polygon, (void)top, (void)bottom;
    return false;
#endif
}

static bool sees_open(const struct lim *lim, const struct lim_screen_polygon *polygon, int16_t top, int16_t bottom)
{
#if LIM_HAS_TRANSPARENT
    return lim_layers_see(&lim->spans, polygon, top, bottom);
#else
    (void)lim, (void)polygon, (void)top, (void)bottom;
    return false;
#endif
}

/* Whether the target fills each polygon as it comes. */
static inline bool fills(const struct lim *lim)
{
#if LIM_HAS_FRAME
    return lim->fills;
#else
    (void)lim;
    return false;
#endif
}

/* take_plain() for such a target, without retaining anything. */
static inline bool fill_plain(struct lim *lim, const struct lim_screen_polygon *polygon, int16_t top, int16_t bottom)
{
#if LIM_HAS_FRAME
    struct lim_piece_look look = {.ctx = lim->target.ctx, .colour = polygon->colour};

    return close_lines(&lim->spans, polygon, top, bottom, lim->target.fill, &look) != LIM_SPAN_EXHAUSTED;
#else
    (void)lim, (void)polygon, (void)top, (void)bottom;
    return false;
#endif
}

/* false: a pool is exhausted. */
static bool take_plain(struct lim *lim, const struct lim_screen_polygon *polygon)
{
    const struct lim_rect *open = &lim->spans.open;
    const int16_t top = polygon->shape.top > (int16_t)open->y0 ? polygon->shape.top : (int16_t)open->y0;
    const int16_t bottom = polygon->shape.bottom < (int16_t)open->y1 ? polygon->shape.bottom : (int16_t)open->y1;

    if (top >= bottom) return true;
    if (LIM_HAS_STATS) lim_stats_of(lim)->lines += (uint32_t)(bottom - top);
    if (LIM_HAS_FRAME && fills(lim)) return fill_plain(lim, polygon, top, bottom);
    if (LIM_HAS_ANTIALIAS && lim_is_antialiased(&lim->view)) return take_samples(lim, polygon, top, bottom);
    const bool wireframe = lim_wireframe_of(lim);
    const uint8_t alpha = wireframe ? (uint8_t)LIM_OPAQUE : lim_alpha_of(polygon);
    const enum lim_span_result result = alpha == LIM_OPAQUE ? close_lines(&lim->spans, polygon, top, bottom, NULL, NULL)
                                        : sees_open(lim, polygon, top, bottom) ? LIM_SPAN_SOME
                                                                               : LIM_SPAN_NOTHING;
    if (result == LIM_SPAN_NOTHING) return true;
    if (result == LIM_SPAN_EXHAUSTED) return false;
    if (LIM_HAS_STATS) lim_stats_of(lim)->polygons_seen++;
    const struct lim_retained_polygon seen = lim_retained_of(polygon, top, bottom, wireframe);
    return lim_retain(&lim->retained, lim->spans.lines, &seen);
}

static bool take(struct lim *lim, const struct lim_screen_polygon *polygon)
{
    struct lim_screen_polygon triangle;

    if (!polygon->shape.folded) return take_plain(lim, polygon);
    for (uint8_t k = 1; k + 1 < polygon->n; k++) {
        lim_project_fan(polygon, k, &triangle);
        if (!take_plain(lim, &triangle)) return false;
    }
    return true;
}

static void note_pools(struct lim *lim)
{
    struct lim_stats *stats = lim_stats_of(lim);

    if (lim->retained.used > stats->retained_cells_max) stats->retained_cells_max = lim->retained.used;
    if (lim->spans.fresh > stats->gaps_max) stats->gaps_max = lim->spans.fresh;
}

/* Where polygons come from: the walk through the tree, or the sorted list. false: a pool is exhausted. */
#if LIM_HAS_NEAREST
static void shrink(struct lim *lim)
{
    const bool smaller = lim_spans_shrink(&lim->spans);

    if (LIM_HAS_CULL && smaller) lim_cull_set(lim_cull_of(lim), &lim->view, lim_eye_of(lim)->at_q8, &lim->spans.open);
}

static bool take_run(struct lim *lim, uint16_t run, uint8_t *since_shrink)
{
    const LIM_FLASH uint16_t *record = &lim->scene->polygons[run];
    struct lim_screen_polygon polygon;

    for (;;) {
        const uint16_t head = record[0];
        if (LIM_HAS_STATS) lim_stats_of(lim)->records += (head & LIM_POLYGON_PLANE) != 0;
        if (lim_record_is_seen(&lim->walk.eye, record)) {
            if (lim_project(&polygon, &lim->view, lim->scene, record, &lim->spans.open, lim_stats_of(lim))) {
                if (!take(lim, &polygon)) return false;
                if (!lim->spans.open_lines) return true;
            }
            if (++*since_shrink == POLYGONS_PER_SHRINK) {
                *since_shrink = 0;
                shrink(lim);
            }
        }
        if (head & LIM_POLYGON_LAST) return true;
        record += lim_record_words(head);
    }
}

#if LIM_HAS_MOVERS
enum { EXHAUSTED = 1, FULL }; /* a pool; all lines */

static int draw_mover(struct lim *lim, uint16_t entry, const struct lim_screen_polygon *polygon,
                      const struct lim_rect *open)
{
    (void)open;
    if (!(entry == LIM_NONE ? take(lim, polygon) : lim_piece_take(lim, entry, polygon))) return EXHAUSTED;
    return lim->spans.open_lines ? 0 : FULL;
}

static bool collect_with_movers(struct lim *lim)
{
    struct lim_route route = lim_route_static(lim, false);
    uint8_t since_shrink = 0;
    uint16_t what;

    lim_route_begin(&route, lim_movers_list(lim, lim_cull_of(lim)));
    while (lim->spans.open_lines) {
        const enum lim_route_event event = lim_route_next(lim, &route, &what);
        if (event == LIM_ROUTE_END) return true;
        if (event == LIM_ROUTE_RUN) {
            if (!take_run(lim, what, &since_shrink)) return false;
            continue;
        }
        what = lim_movers_order(lim, what, false);
        if (lim_movers_draw(lim, what, &lim->spans.open, false, draw_mover) == EXHAUSTED) return false;
        shrink(lim);
    }
    return true;
}
#endif

static bool collect_from_tree(struct lim *lim, const struct lim_rect *band)
{
    uint8_t since_shrink = 0;
    uint16_t run;

    if (LIM_HAS_CULL) lim_cull_set(lim_cull_of(lim), &lim->view, lim_eye_of(lim)->at_q8, band);
#if LIM_HAS_MOVERS
    if (lim->movers.count) return collect_with_movers(lim);
#endif
    lim_walk_begin(&lim->walk, lim->stack, false);
    while (lim->spans.open_lines &&
           (run = lim_walk_next(&lim->walk, lim_cull_of(lim), lim_stats_of(lim))) != LIM_NONE) {
        if (!take_run(lim, run, &since_shrink)) return false;
    }
    return true;
}
#endif

#if LIM_HAS_SORTED
static bool collect_from_list(struct lim *lim)
{
    const struct lim_rect *open = &lim->spans.open;
    struct lim_screen_polygon polygon;
    uint8_t since_shrink = 0;

    for (uint16_t at = lim->sorter.first; at != LIM_NONE && lim->spans.open_lines; at = lim->sorter.list[at].next) {
        const LIM_FLASH uint16_t *record = &lim->scene->polygons[lim->sorter.list[at].record];
        if (!lim_project(&polygon, &lim->view, lim->scene, record, open, lim_stats_of(lim))) continue;
        if (!(LIM_HAS_NEWELL && lim_is_piece(lim, at) ? lim_piece_take(lim, at, &polygon) : take(lim, &polygon)))
            return false;
        if (++since_shrink < POLYGONS_PER_SHRINK) continue;
        since_shrink = 0;
        (void)lim_spans_shrink(&lim->spans);
    }
    return true;
}
#endif

static bool collect_from_source(struct lim *lim, const struct lim_rect *band)
{
#if LIM_HAS_SORTED
    if (LIM_IS_SORTED(&lim->target)) return collect_from_list(lim);
#endif
#if LIM_HAS_NEAREST
    return collect_from_tree(lim, band);
#else
    (void)band;
    return true;
#endif
}

/* Pass one over a band. */
static bool collect(struct lim *lim, const struct lim_rect *band)
{
    lim_spans_open(&lim->spans, &lim->target, band);
    lim->retained.used = 0;
    if (!collect_from_source(lim, band)) return false;
    if (LIM_HAS_STATS) note_pools(lim);
    return true;
}

/* A smaller band that starts where this one does. What PAINT has left of a band may be a single
 * pixel, which is smaller already. */
static void halve(struct lim_rect *band)
{
    const uint16_t lines = (uint16_t)(band->y1 - band->y0), pixels = (uint16_t)(band->x1 - band->x0);

    if (lines > 1)
        band->y1 = (uint16_t)(band->y0 + lines / 2);
    else if (pixels > 1)
        band->x1 = (uint16_t)(band->x0 + pixels / 2);
}

/* The band of the same size that follows: to the right, or below. */
static void follow(struct lim_rect *band, const struct lim_target *target)
{
    const uint16_t lines = (uint16_t)(band->y1 - band->y0), pixels = (uint16_t)(band->x1 - band->x0);

    if (band->x1 < target->w_px) {
        band->x0 = band->x1;
        band->x1 = (uint16_t)(target->w_px - band->x0 < pixels ? target->w_px : band->x0 + pixels);
        return;
    }
    band->x0 = 0;
    band->x1 = pixels;
    band->y0 = band->y1;
    band->y1 = (uint16_t)(target->h_px - band->y0 < lines ? target->h_px : band->y0 + lines);
}

/* Both passes. Positive: a pool is exhausted (LIM_PAINT_...), and *y is the first line that is not yet painted. */
static int draw_band(struct lim *lim, const struct lim_rect *band, uint16_t *y)
{
    *y = band->y0;
    if (!collect(lim, band)) return LIM_PAINT_ACTIVE;
    return lim_paint_band(&lim->paint, &lim->spans, &lim->retained, band, y, lim_stats_of(lim));
}

/* How far the stack must reach, and how many polygons wait at one pixel, is not bounded where some are transparent; and
 * wireframe retains more of a polygon than the least pool was made for. The painter's order needs no pool at all: a
 * line for which any is too small is painted so. */
static bool wants_painter(const struct lim *lim, const struct lim_rect *band, int exhausted)
{
    if (!LIM_HAS_FALLBACK) return false;
    if (!lim->scene->limits.layers && !lim_wireframe_of(lim) && !lim_moves(lim)) return false;
    return exhausted == LIM_PAINT_LAYERS || band->y1 - band->y0 == 1;
}

/* In all views of the frame. */
static inline void set_antialiased(struct lim *lim, bool antialiased)
{
#if LIM_HAS_ANTIALIAS
    lim->view.antialiased = antialiased;
#if LIM_HAS_MOVERS
    lim->movers.world.antialiased = antialiased;
    for (uint16_t i = 0; i < lim->movers.count; i++)
        lim->movers.movers[i].view.antialiased = antialiased;
#endif
#else
    (void)lim, (void)antialiased;
#endif
}

/* Whether lim_set_antialias() has lent what it takes. */
static inline bool wants_antialias(const struct lim *lim)
{
#if LIM_HAS_ANTIALIAS
    return lim->paint.smooth.sums && !lim_wireframe_of(lim);
#else
    (void)lim;
    return false;
#endif
}

/* One line, from a walk of its own: it needs no pool. */
static inline int draw_line_alone(struct lim *lim, const struct lim_rect *band)
{
#if LIM_HAS_ANTIALIAS
    const int err = lim_smooth_begin_line(lim, band->y0);

    if (err) return err;
    (void)collect(lim, band);
    return lim_smooth_end_line(lim, band->y0);
#else
    (void)lim, (void)band;
    return 0;
#endif
}

/* The band's first line; what is left of the band comes next. */
static int paint_first_line(struct lim *lim, struct lim_rect *band)
{
    int err = LIM_ERR_TARGET;
#if LIM_HAS_FALLBACK
    const bool antialiased = lim_is_antialiased(&lim->view);

    set_antialiased(lim, false);
    err = lim_painter_line(lim, band->y0);
    set_antialiased(lim, antialiased);
#endif
    if (band->y1 - band->y0 > 1)
        band->y0++;
    else
        follow(band, &lim->target);
    return err;
}

#if LIM_HAS_FRAME
/* Whether all of the frame is made of pieces in one colour, and the target has room for it. */
static bool wants_fill(const struct lim *lim)
{
    if (!lim->target.fill || lim->target.method != LIM_NEAREST_FIRST || wants_antialias(lim)) return false;
    if (lim->scene->limits.layers || lim_texture_count(lim->scene) || lim_wireframe_of(lim)) return false;
#if LIM_HAS_DELTA
    if (lim->delta) return false;
#endif
    return !lim_moves(lim);
}

static void fill_background(struct lim *lim)
{
    const struct lim_rect *open = &lim->spans.open;
    struct lim_piece_look look = {.ctx = lim->target.ctx, .colour = lim_background_of(lim)};

    if (!lim->spans.open_lines) return;
    for (look.y_px = open->y0; look.y_px < open->y1; look.y_px++) {
        struct lim_line *line = &lim->spans.lines[look.y_px];
        (void)lim_span_close(&lim->spans, line, 0, (int16_t)lim->target.w_px, lim->target.fill, &look);
    }
}

/* Polygons straight into the frame that the target keeps: pass one alone. Positive: it must come by lines. */
static int fill_frame(struct lim *lim, const struct lim_rect *frame)
{
    lim->fills = true;
    const bool whole = collect(lim, frame);
    lim->fills = false;
    if (!whole) return LIM_PAINT_ACTIVE;
    fill_background(lim);
    return lim->target.show(lim->target.ctx);
}
#endif

int lim_nearest_frame(struct lim *lim)
{
    struct lim_rect band = {0, 0, lim->target.w_px, lim->target.h_px};

    if (LIM_HAS_ANTIALIAS) set_antialiased(lim, wants_antialias(lim));
    if (LIM_IS_SORTED(&lim->target)) lim_sorted_order(lim);
#if LIM_HAS_FRAME
    if (wants_fill(lim)) {
        const int err = fill_frame(lim, &band);
        if (err <= 0) return err;
    }
#endif
    while (band.y0 < lim->target.h_px) {
        uint16_t y;
        const int err = draw_band(lim, &band, &y);
        if (err < 0) return err;
        if (err) {
            band.y0 = y;
            if (LIM_HAS_STATS) lim_stats_of(lim)->bands++;
            if (wants_painter(lim, &band, err)) {
                const int failed = paint_first_line(lim, &band);
                if (failed) return failed;
            } else if (LIM_HAS_ANTIALIAS && lim_is_antialiased(&lim->view) && band.y1 - band.y0 == 1) {
                const int failed = draw_line_alone(lim, &band);
                if (failed) return failed;
                follow(&band, &lim->target);
            } else {
                halve(&band);
            }
        } else {
            follow(&band, &lim->target);
        }
    }
    return 0;
}

#endif
