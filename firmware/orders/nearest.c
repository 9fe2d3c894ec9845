/* SPDX-License-Identifier: MIT
 *
 * Nearest first, pass one: walks the tree, or the sorted list, closes gaps, and retains the polygons that closed some;
 * by scan lines all that are in view. All at once, or, where a frame is begun while another is still on its way,
 * polygon by polygon (lim_frame_work()). bands.c drives it. */
#include "orders/order.h"

#include "lines/framebuffer.h"
#include "lines/layers.h"
#include "pieces/piece.h"
#include "screen/project.h"

#if LIM_HAS_SPANS

enum { POLYGONS_PER_SHRINK = 20 }; /* the open view is drawn together this often */

/* SPAN for one polygon that is not non-monotone, on the lines `shown`, which shrink to those of which something was
 * open. sink: for the pieces, with `look`, where they are painted at once, and nobody asks for lines; or NULL. false: a
 * pool is exhausted. */
static inline bool close_lines(struct lim_spans *spans, const struct lim_point *at, uint8_t n, uint8_t first,
                               struct lim_span_extent *shown, lim_span_sink *sink, struct lim_piece_look *look)
{
    const int16_t top = shown->top, bottom = shown->bottom;
    struct lim_edge_pair pair;

    (void)sink, (void)look;
    *shown = (struct lim_span_extent){bottom, top};
    lim_edge_begin(&pair, n, first);
    for (int16_t y = top; y < bottom;) {
        const int16_t turn = lim_edge_turn(&pair, at, n, y);
        const int16_t end = turn < bottom ? turn : bottom;
#if LIM_HAS_FILLED
        if (sink) {
            if (!lim_spans_close_filling(spans, y, end, &pair, sink, look)) return false;
        } else
#endif
            if (!lim_spans_close(spans, y, end, &pair, shown))
            return false;
        y = end;
    }
    return true;
}

/* The same where polygons are painted as they come. */
static inline bool fill_lines(struct lim *lim, const struct lim_point *at, uint8_t n, uint8_t first,
                              struct lim_span_extent shown, uint16_t colour)
{
#if LIM_HAS_FILLED
    struct lim_piece_look look = {.ctx = lim_fill_ctx_of(&lim->target), .colour = colour};

    return close_lines(&lim->spans, at, n, first, &shown, lim_fill_of(&lim->target), &look);
#else
    (void)lim, (void)at, (void)n, (void)first, (void)shown, (void)colour;
    return false;
#endif
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

/* Scan lines: every polygon in view is retained, without a look at what is open, and painted from far to near. What
 * that cannot paint is drawn nearest first; so are bands of one line, of which there are only where memory is scarce:
 * any number of polygons lie behind one another at a pixel, and the least pools hold one. */
static inline bool retains_all(const struct lim *lim)
{
#if LIM_HAS_SCANLINE
    return lim->retains_all;
#else
    (void)lim;
    return false;
#endif
}

#if LIM_HAS_SCANLINE
/* In a band: one of a line is drawn nearest first, for which any pool will do. */
static inline bool can_retain_all(const struct lim *lim, const struct lim_rect *band)
{
    return LIM_IS_SCANLINE(&lim->target) && band->y1 - band->y0 > 1 && lim_can_fill(lim);
}
#endif

static bool sees_open(const struct lim *lim, const struct lim_screen_polygon *polygon, int16_t top, int16_t bottom)
{
#if LIM_HAS_TRANSPARENT
    return lim_layers_see(&lim->spans, polygon, top, bottom);
#else
    (void)lim, (void)polygon, (void)top, (void)bottom;
    return false;
#endif
}

/* Whether each polygon is painted as it comes, and nothing is retained. */
static inline bool fills(const struct lim *lim)
{
#if LIM_HAS_FILLED
    return lim->fills;
#else
    (void)lim;
    return false;
#endif
}

/* Whether a record is of one opaque colour, and drawn as such. */
static inline bool is_for_fast_path(const struct lim *lim, const LIM_FLASH lim_index *record)
{
    const unsigned slow = (LIM_HAS_TRANSPARENT ? LIM_POLYGON_ALPHA : 0u) | (LIM_HAS_TEXTURE ? LIM_POLYGON_TEXTURE : 0u);

    return !(record[0] & slow) && !lim_wireframe_of(lim) && !lim_is_antialiased(&lim->view);
}

/* A polygon that is not non-monotone. false: a pool is exhausted. */
static bool take_plain(struct lim *lim, const struct lim_screen_polygon *polygon)
{
    struct lim_span_extent shown = lim_shape_lines(&polygon->shape, &lim->spans.open);

    if (shown.top >= shown.bottom) return true;
    if (LIM_HAS_STATS) lim_stats_of(lim)->lines += (uint32_t)(shown.bottom - shown.top);
    if (LIM_HAS_FILLED && fills(lim))
        return fill_lines(lim, polygon->at, polygon->n, polygon->shape.first, shown, polygon->colour);
    if (LIM_HAS_ANTIALIAS && lim_is_antialiased(&lim->view)) return take_samples(lim, polygon, shown.top, shown.bottom);
    const bool wireframe = lim_wireframe_of(lim);
    const uint8_t alpha = wireframe ? (uint8_t)LIM_OPAQUE : lim_alpha_of(polygon);
    if (alpha != LIM_OPAQUE) {
        if (!sees_open(lim, polygon, shown.top, shown.bottom)) return true;
    } else if (!retains_all(lim) &&
               !close_lines(&lim->spans, polygon->at, polygon->n, polygon->shape.first, &shown, NULL, NULL)) {
        return false;
    }
    if (shown.top >= shown.bottom) return true;
    if (LIM_HAS_STATS) lim_stats_of(lim)->polygons_seen++;
    const struct lim_retained_polygon seen = lim_retained_of(polygon, shown.top, shown.bottom, wireframe);
    return lim_retain(&lim->retained, lim->spans.lines, &seen);
}

static bool take(struct lim *lim, const struct lim_screen_polygon *polygon)
{
    struct lim_screen_polygon triangle;

    if (!polygon->shape.non_monotone) return take_plain(lim, polygon);
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

/* Polygons from the walk through the tree. */
#if LIM_HAS_WALKED
/* Draws the open view together, and CULL's planes with it. */
static void shrink(struct lim *lim)
{
    const bool smaller = lim_spans_shrink(&lim->spans);

    if (LIM_HAS_CULL && smaller) lim_cull_set(lim_cull_of(lim), &lim->view, lim_eye_of(lim)->at_q8, &lim->spans.open);
}

/* Of whatever kind it is. false: a pool is exhausted. */
static LIM_RARE bool take_any(struct lim *lim, const LIM_FLASH lim_index *record)
{
    struct lim_screen_polygon polygon;

    return !lim_project(&polygon, &lim->view, lim->scene, record, &lim->spans.open, lim_stats_of(lim)) ||
           take(lim, &polygon);
}

enum outcome {
    NOTHING_OPEN, /* nothing of it can be */
    TAKEN,        /* all of it that was open is closed, and it is retained if there was any */
    EXHAUSTED_POOL,
    SLOW_PATH /* nothing was done: take_any() */
};

/* A polygon as most are: of one colour, neither clipped nor non-monotone, and with room for its points where they would
 * be retained. They are projected to that place, so none of it is ever copied. */
static inline enum outcome take_fast(struct lim *lim, const LIM_FLASH lim_index *record)
{
    const uint8_t n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    struct lim_point *at = lim_retained_place(&lim->retained, n);
    struct lim_edge_shape shape;
    uint_fast16_t codes;

    LIM_ASSERT(n <= LIM_MAX_VERTICES);
    if (!at) return SLOW_PATH;
    if (!lim_project_fast(&shape, at, n, &lim->view, lim->scene, record, &codes)) return SLOW_PATH;
    if (LIM_HAS_STATS) lim_stats_of(lim)->polygons++;
    if (lim_view_all_outside(codes)) return NOTHING_OPEN;
    if (codes & (LIM_VIEW_LEFT | LIM_VIEW_RIGHT)) lim->retained.overhangs = true;
    const struct lim_rect *open = &lim->spans.open;
    struct lim_span_extent shown = lim_shape_lines(&shape, open);
    if (shown.top >= shown.bottom) return NOTHING_OPEN;
    if (lim_project_is_narrow(&lim->view, open)) {
        lim_edge_bounds_sides(&shape, at, n);
        if (!lim_shape_meets_sides(&shape, open)) return NOTHING_OPEN;
    }
    if (LIM_HAS_STATS) lim_stats_of(lim)->lines += (uint32_t)(shown.bottom - shown.top);
    if (LIM_HAS_FILLED && fills(lim)) {
        const uint16_t colour = lim_memory_colour((uint16_t)record[1]);
        return fill_lines(lim, at, n, shape.first, shown, colour) ? TAKEN : EXHAUSTED_POOL;
    }
    if (!retains_all(lim)) {
        struct lim_span_extent seen = shown;
        if (!close_lines(&lim->spans, at, n, shape.first, &seen, NULL, NULL)) return EXHAUSTED_POOL;
        if (seen.top >= seen.bottom) return TAKEN;
        shown = seen;
    }
    if (LIM_HAS_STATS) lim_stats_of(lim)->polygons_seen++;
    lim_retained_link(&lim->retained, &lim->spans.lines[shown.top], n, shape.first, (uint16_t)shown.bottom,
                      lim_memory_colour((uint16_t)record[1]), (uint16_t)(LIM_RETAINED_HEAD_CELLS + n));
    return TAKEN;
}

/* A record that faces the eye. false: a pool is exhausted. */
static LIM_ALONE bool take_record(struct lim *lim, const LIM_FLASH lim_index *record, uint8_t *since_shrink)
{
    enum outcome outcome = !LIM_OPTIMISE_SIZE && is_for_fast_path(lim, record) ? take_fast(lim, record) : SLOW_PATH;

    if (outcome == SLOW_PATH) outcome = take_any(lim, record) ? TAKEN : EXHAUSTED_POOL;
    if (outcome == EXHAUSTED_POOL) return false;
    if (retains_all(lim) || !lim->spans.open_lines) return true;
    if (outcome == TAKEN) lim_spans_trim(&lim->spans);
    if (++*since_shrink == POLYGONS_PER_SHRINK) {
        *since_shrink = 0;
        shrink(lim);
    }
    return true;
}

/* false: a pool is exhausted. */
static bool take_run(struct lim *lim, lim_index run, uint8_t *since_shrink)
{
    const LIM_FLASH lim_index *record = &lim->scene->polygons[run];

    for (;;) {
        const lim_index head = record[0];
        if (LIM_HAS_STATS) lim_stats_of(lim)->records += (head & LIM_POLYGON_PLANE) != 0;
        if (lim_record_is_seen(&lim->walk.eye, record)) {
            if (!take_record(lim, record, since_shrink)) return false;
            if (!lim->spans.open_lines) return true;
        }
        if (head & LIM_POLYGON_LAST) return true;
        record += lim_record_words(head);
    }
}

#if LIM_HAS_MOVERS
enum { MOVER_EXHAUSTED = 1, MOVER_FULL }; /* a pool; all lines */

static int draw_mover(struct lim *lim, uint16_t entry, const struct lim_screen_polygon *polygon,
                      const struct lim_rect *open)
{
    (void)open;
    if (!(entry == LIM_NONE ? take(lim, polygon) : lim_piece_take(lim, entry, polygon))) return MOVER_EXHAUSTED;
    return lim->spans.open_lines ? 0 : MOVER_FULL;
}

/* What moves and has come to empty space. false: a pool is exhausted. */
static bool take_list(struct lim *lim, uint16_t list)
{
    list = lim_movers_order(lim, list, false);
    if (lim_movers_draw(lim, list, &lim->spans.open, false, draw_mover) == MOVER_EXHAUSTED) return false;
    shrink(lim);
    return true;
}

static bool collect_with_movers(struct lim *lim)
{
    struct lim_route route = lim_route_static(lim, false);
    uint8_t since_shrink = 0;
    lim_index what;

    lim_route_begin(&route, lim_movers_list(lim, lim_cull_of(lim)));
    while (lim->spans.open_lines) {
        const enum lim_route_event event = lim_route_next(lim, &route, &what);
        if (event == LIM_ROUTE_END) return true;
        if (!(event == LIM_ROUTE_RUN ? take_run(lim, what, &since_shrink) : take_list(lim, (uint16_t)what)))
            return false;
    }
    return true;
}
#endif

static bool collect_from_tree(struct lim *lim, const struct lim_rect *band)
{
    uint8_t since_shrink = 0;
    lim_index run;

    if (LIM_HAS_CULL) lim_cull_set(lim_cull_of(lim), &lim->view, lim_eye_of(lim)->at_q8, band);
#if LIM_HAS_MOVERS
    if (lim->movers.count) return collect_with_movers(lim);
#endif
    lim_walk_begin(&lim->walk, lim->stack, false);
    while (lim->spans.open_lines &&
           (run = lim_walk_next(&lim->walk, lim_cull_of(lim), lim_stats_of(lim))) != LIM_NO_INDEX) {
        if (!take_run(lim, run, &since_shrink)) return false;
    }
    return true;
}
#endif

/* And from the sorted list. */
#if LIM_HAS_SORTED
static bool take_entry(struct lim *lim, uint16_t at, uint8_t *since_shrink)
{
    const LIM_FLASH lim_index *record = &lim->scene->polygons[lim->sorter.list[at].record];
    struct lim_screen_polygon polygon;

    if (!lim_project(&polygon, &lim->view, lim->scene, record, &lim->spans.open, lim_stats_of(lim))) return true;
    if (!(LIM_HAS_NEWELL && lim_is_piece(lim, at) ? lim_piece_take(lim, at, &polygon) : take(lim, &polygon)))
        return false;
    if (++*since_shrink < POLYGONS_PER_SHRINK) return true;
    *since_shrink = 0;
    (void)lim_spans_shrink(&lim->spans);
    return true;
}

static bool collect_from_list(struct lim *lim)
{
    uint8_t since_shrink = 0;

    for (uint16_t at = lim->sorter.first; at != LIM_NONE && lim->spans.open_lines; at = lim->sorter.list[at].next)
        if (!take_entry(lim, at, &since_shrink)) return false;
    return true;
}
#endif

static bool collect_from_source(struct lim *lim, const struct lim_rect *band)
{
#if LIM_HAS_SORTED
    if (LIM_IS_SORTED(&lim->target)) return collect_from_list(lim);
#endif
#if LIM_HAS_WALKED
    return collect_from_tree(lim, band);
#else
    (void)band;
    return true;
#endif
}

static void open_band(struct lim *lim, const struct lim_rect *band)
{
    lim_spans_open(&lim->spans, &lim->target, band);
    lim_retained_clear(&lim->retained);
#if LIM_HAS_SCANLINE
    lim->retains_all = can_retain_all(lim, band);
#endif
}

bool lim_collect(struct lim *lim, const struct lim_rect *band)
{
    open_band(lim, band);
    if (!collect_from_source(lim, band)) return false;
    if (LIM_HAS_STATS) note_pools(lim);
    return true;
}

#if LIM_HAS_STREAM
/* The same in quanta, over all lines. What a loop above has in variables is in lim->ahead. */
#if LIM_HAS_WALKED
/* Records up to the next that faces the eye, and this. */
static bool take_some_of_run(struct lim *lim)
{
    const LIM_FLASH lim_index *record = lim->ahead.record;

    for (bool is_seen = false; record && !is_seen;) {
        const lim_index head = record[0];
        if (LIM_HAS_STATS) lim_stats_of(lim)->records += (head & LIM_POLYGON_PLANE) != 0;
        is_seen = lim_record_is_seen(&lim->walk.eye, record);
        if (is_seen && !take_record(lim, record, &lim->ahead.since_shrink)) return false;
        record = head & LIM_POLYGON_LAST || !lim->spans.open_lines ? NULL : record + lim_record_words(head);
    }
    lim->ahead.record = record;
    return true;
}

static void begin_tree(struct lim *lim, const struct lim_rect *frame)
{
    lim->ahead.record = NULL;
    if (LIM_HAS_CULL) lim_cull_set(lim_cull_of(lim), &lim->view, lim_eye_of(lim)->at_q8, frame);
#if LIM_HAS_MOVERS
    if (lim->movers.count) {
        lim->ahead.route = lim_route_static(lim, false);
        lim_route_begin(&lim->ahead.route, lim_movers_list(lim, lim_cull_of(lim)));
        return;
    }
#endif
    lim_walk_begin(&lim->walk, lim->stack, false);
}

/* LIM_NO_INDEX: there is none. With movers, they may come instead. */
static enum lim_route_event next_of_tree(struct lim *lim, lim_index *what)
{
#if LIM_HAS_MOVERS
    if (lim->movers.count) return lim_route_next(lim, &lim->ahead.route, what);
#endif
    *what = lim_walk_next(&lim->walk, lim_cull_of(lim), lim_stats_of(lim));
    return *what == LIM_NO_INDEX ? LIM_ROUTE_END : LIM_ROUTE_RUN;
}

/* A quantum: a polygon, or what has moved to one place. */
static enum lim_ahead_stage take_some_of_tree(struct lim *lim)
{
    lim_index what;

    if (!lim->ahead.record) {
        const enum lim_route_event event = lim->spans.open_lines ? next_of_tree(lim, &what) : LIM_ROUTE_END;
        if (event == LIM_ROUTE_END) return LIM_AHEAD_DONE;
#if LIM_HAS_MOVERS
        if (event == LIM_ROUTE_LIST) return take_list(lim, (uint16_t)what) ? LIM_AHEAD_BUSY : LIM_AHEAD_EXHAUSTED;
#endif
        lim->ahead.record = &lim->scene->polygons[what];
    }
    return take_some_of_run(lim) ? LIM_AHEAD_BUSY : LIM_AHEAD_EXHAUSTED;
}
#endif

#if LIM_HAS_SORTED
static enum lim_ahead_stage take_some_of_list(struct lim *lim)
{
    const uint16_t at = lim->ahead.entry;

    if (at == LIM_NONE || !lim->spans.open_lines) return LIM_AHEAD_DONE;
    lim->ahead.entry = lim->sorter.list[at].next;
    return take_entry(lim, at, &lim->ahead.since_shrink) ? LIM_AHEAD_BUSY : LIM_AHEAD_EXHAUSTED;
}
#endif

void lim_collect_begin(struct lim *lim, const struct lim_rect *frame)
{
    open_band(lim, frame);
    lim->ahead.since_shrink = 0;
#if LIM_HAS_SORTED
    lim->ahead.entry = lim->sorter.first;
    if (LIM_IS_SORTED(&lim->target)) return;
#endif
#if LIM_HAS_WALKED
    begin_tree(lim, frame);
#endif
}

static enum lim_ahead_stage take_some(struct lim *lim)
{
#if LIM_HAS_SORTED
    if (LIM_IS_SORTED(&lim->target)) return take_some_of_list(lim);
#endif
#if LIM_HAS_WALKED
    return take_some_of_tree(lim);
#else
    return LIM_AHEAD_DONE;
#endif
}

enum lim_ahead_stage lim_collect_some(struct lim *lim)
{
    const enum lim_ahead_stage stage = take_some(lim);

    if (LIM_HAS_STATS && stage == LIM_AHEAD_DONE) note_pools(lim);
    return stage;
}
#endif

#endif
