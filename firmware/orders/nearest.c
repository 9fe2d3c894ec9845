/* SPDX-License-Identifier: MIT
 *
 * Nearest first, pass one: walks the tree, or the sorted list, closes gaps, and retains the polygons that closed some;
 * by scan lines all that are in view. All at once, or, where a frame is begun while another is still on its way,
 * polygon by polygon (lim_frame_work()). bands.c drives it. */
#include "orders/nearest.h"

#include "eye.h"
#include "lines/framebuffer.h"
#include "lines/gaps.h"
#include "lines/layers.h"
#include "lines/retain.h"
#include "lines/share.h"
#include "lines/smooth.h"
#include "lines/smooth_line.h"
#include "lines/span.h"
#include "orders/room.h"
#include "pieces/entry.h"
#include "routes/mover_list.h"
#include "routes/mover_order.h"
#include "routes/mover_route.h"
#include "routes/route.h"
#include "screen/project.h"
#include "screen/samples.h"
#include "view/cull.h"
#include "view/walk.h"

#if LIM_HAS_SPANS

/* Polygons come from the sorted list: a constant where nothing is walked, for meshes do not come here. */
#define IS_LISTED(nearest) (!LIM_HAS_WALKED || LIM_IS_SORTED(&(nearest)->pass->target))

/* Draws the open view together, and CULL's planes with it. */
static void shrink(struct lim_nearest *nearest)
{
    const bool smaller = lim_spans_shrink(&nearest->spans);

    if (LIM_HAS_CULL && smaller)
        lim_cull_set(lim_cull_of(nearest->pass), &nearest->pass->view, lim_eye_of(nearest->pass)->at_q8,
                     &nearest->spans.open);
}

/* SPAN for one polygon that is not non-monotone, on the lines `shown`, which shrink to those of which something was
 * open. sink: for the pieces, with `look`, where they are painted at once, and nobody asks for lines; or NULL. false: a
 * pool is exhausted. */
static inline bool close_lines(struct lim_spans *spans, const struct lim_point *at, uint8_t n, uint8_t first,
                               struct lim_span_extent *shown, lim_piece_fill *sink, struct lim_piece_look *look)
{
    const int16_t top = shown->top, bottom = shown->bottom;
    struct lim_closing closing;
    bool closed = true;

    closing.top = NULL;
    lim_edge_begin(&closing.pair, n, first);
    for (int16_t y = top; closed && y < bottom;) {
        const int16_t turn = lim_edge_turn(&closing.pair, at, n, y);
        const int16_t end = turn < bottom ? turn : bottom;
        closed = LIM_HAS_FILLED && sink ? lim_spans_close_filling(spans, y, end, &closing, sink, look)
                                        : lim_spans_close(spans, y, end, &closing);
        y = end;
    }
    *shown = (struct lim_span_extent){bottom, top};
    if (closing.top)
        *shown =
            (struct lim_span_extent){(int16_t)(closing.top - spans->lines), (int16_t)(closing.last - spans->lines + 1)};
    return closed;
}

/* Closed on the lines `shown`, of those that the band keeps: where no gap is left the band gives lines away, and what
 * is closed stays closed, so closing begins anew. `seen` grows by the lines of which something was open. Points that
 * wait in the pool for retaining move with its end. false: a pool is exhausted. */
static LIM_ALONE bool close_with_room(struct lim_nearest *nearest, const struct lim_point *at, uint8_t n, uint8_t first,
                                      struct lim_span_extent shown, struct lim_span_extent *seen)
{
    for (;;) {
        struct lim_span_extent again = shown;
        const bool closed = close_lines(&nearest->spans, at, n, first, &again, NULL, NULL);
        if (again.top < seen->top) seen->top = again.top;
        if (again.bottom > seen->bottom) seen->bottom = again.bottom;
        if (closed) return true;
        const struct lim_point *const place = lim_retained_end(&nearest->retained);
        if (!lim_room_make(nearest)) return false;
        if (!LIM_OPTIMISE_SIZE && at == place) at = lim_retained_move(&nearest->retained, at, n);
        const int16_t bottom = (int16_t)nearest->bottom;
        if (seen->bottom > bottom) seen->bottom = bottom;
        if (shown.bottom > bottom) shown.bottom = bottom;
        if (shown.top >= shown.bottom) return true;
    }
}

/* Likewise where a polygon that is closed finds no cells. */
static bool retain_with_room(struct lim_nearest *nearest, const struct lim_retained_polygon *seen)
{
    while (!lim_retain(&nearest->spans, seen)) {
        if (!lim_room_make(nearest)) return false;
        if (seen->top >= nearest->bottom) return true;
    }
    return true;
}

/* The same where polygons are painted as they come. */
static inline bool fill_lines(struct lim_nearest *nearest, const struct lim_point *at, uint8_t n, uint8_t first,
                              struct lim_span_extent shown, uint16_t colour)
{
    struct lim_target *target = &nearest->pass->target;
    struct lim_piece_look look = {.ctx = lim_fill_ctx_of(target), .colour = colour};

    return close_lines(&nearest->spans, at, n, first, &shown, lim_fill_of(target), &look);
}

/* A constant where there is no choice. */
static inline bool fills(const struct lim_nearest *nearest)
{
    return LIM_HAS_FILLED && nearest->fills;
}

/* collect_plain() for a polygon that is drawn by its samples: it is retained up to a row of them. */
static inline bool collect_samples(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon,
                                   struct lim_span_extent shown)
{
    if (nearest->paint.smooth->line) {
        lim_smooth_add_polygon(&nearest->paint, &nearest->spans, polygon);
        return true;
    }
    if (!lim_nearest_retains_all(nearest) && !lim_smooth_close(&nearest->spans, polygon, &shown)) return false;
    if (shown.top >= shown.bottom) return true;
    if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->polygons_seen++;
    const int16_t rows = (int16_t)(shown.bottom * LIM_SAMPLE_ROWS), end_row = *polygon->shape.end_row;
    const struct lim_retained_polygon seen =
        lim_retained_of(polygon, shown.top, end_row < rows ? end_row : rows, false);
    return lim_retain(&nearest->spans, &seen);
}

/* Whether a record is opaque, and drawn as such. */
static inline bool is_for_fast_path(const struct lim_nearest *nearest, const LIM_FLASH lim_index *record)
{
    const unsigned slow = LIM_HAS_TRANSPARENT ? LIM_POLYGON_ALPHA : 0u;

    return !(record[0] & slow) && !lim_wireframe_of(nearest->pass) && !lim_is_antialiased(&nearest->pass->view);
}

/* A polygon that is not non-monotone. false: a pool is exhausted. */
static bool collect_plain(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon)
{
    struct lim_span_extent shown = lim_shape_lines(&polygon->shape, &nearest->spans.open);

    if (shown.top >= shown.bottom) return true;
    if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->lines += (uint32_t)(shown.bottom - shown.top);
    if (LIM_HAS_FILLED && fills(nearest))
        return fill_lines(nearest, polygon->at, polygon->n, polygon->shape.first, shown, polygon->colour);
    if (LIM_HAS_ANTIALIAS && lim_is_antialiased(&nearest->pass->view)) return collect_samples(nearest, polygon, shown);
    const bool wireframe = lim_wireframe_of(nearest->pass);
    const uint8_t alpha = wireframe ? (uint8_t)LIM_OPAQUE : lim_alpha_of(polygon);
    if (LIM_HAS_TRANSPARENT && alpha != LIM_OPAQUE) {
        if (!lim_layers_see(&nearest->spans, polygon, shown.top, shown.bottom)) return true;
    } else if (!lim_nearest_retains_all(nearest)) {
        const struct lim_span_extent lines = shown;
        shown = (struct lim_span_extent){lines.bottom, lines.top};
        if (!close_with_room(nearest, polygon->at, polygon->n, polygon->shape.first, lines, &shown)) return false;
    }
    if (shown.top >= shown.bottom) return true;
    if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->polygons_seen++;
    const struct lim_retained_polygon seen = lim_retained_of(polygon, shown.top, shown.bottom, wireframe);
    return retain_with_room(nearest, &seen);
}

static bool collect(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon)
{
    struct lim_screen_polygon triangle;

    if (!polygon->shape.non_monotone) return collect_plain(nearest, polygon);
    for (uint8_t k = 1; k + 1 < polygon->n; k++) {
        lim_project_fan(polygon, k, &triangle);
        if (!collect_plain(nearest, &triangle)) return false;
    }
    return true;
}

/* Of whatever kind it is. false: a pool is exhausted. */
static LIM_RARE bool collect_any(struct lim_nearest *nearest, const LIM_FLASH lim_index *record)
{
    struct lim_screen_polygon polygon;

    return !lim_project(&polygon, &nearest->pass->view, nearest->pass->scene, record, &nearest->spans.open,
                        lim_stats_of(nearest->pass)) ||
           collect(nearest, &polygon);
}

enum outcome {
    NOTHING_OPEN, /* nothing of it can be */
    COLLECTED,    /* all of it that was open is closed, and it is retained if there was any */
    EXHAUSTED_POOL,
    SLOW_PATH /* nothing was done: collect_any() */
};

/* Where a record with LIM_POLYGON_TEXTURE names it, or LIM_NONE of any record: textures may have been taken away. */
static inline uint16_t texture_word(const struct lim_pass *pass, const LIM_FLASH lim_index *record)
{
    if (!LIM_HAS_TEXTURE || !(record[0] & LIM_POLYGON_TEXTURE) || !lim_texture_count(pass->scene)) return LIM_NONE;
    return (uint16_t)(record + lim_record_words(record[0]) - LIM_POLYGON_TEXTURE_WORDS - pass->scene->polygons);
}

/* A polygon as most are: opaque, neither clipped nor non-monotone, and with room for its points where they would
 * be retained. They are projected to that place, so none of it is ever copied. What moves has no texture. */
static inline enum outcome collect_fast(struct lim_nearest *nearest, struct lim_view *view,
                                        const struct lim_scene *scene, const LIM_FLASH lim_index *record, bool moves)
{
    struct lim_pass *const pass = nearest->pass;
    const uint8_t n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    struct lim_point *at = lim_retained_place(&nearest->spans, &nearest->retained, n);
    struct lim_edge_shape shape;
    uint_fast16_t codes;

    LIM_DEBUG_ASSERT(n <= LIM_MAX_VERTICES);
    if (!at) return SLOW_PATH;
    if (!lim_project_fast(&shape, at, n, view, scene, record, &codes)) return SLOW_PATH;
    if (LIM_HAS_STATS) lim_stats_of(pass)->polygons++;
    if (lim_view_all_outside(codes)) return NOTHING_OPEN;
    if (codes & (LIM_VIEW_LEFT | LIM_VIEW_RIGHT)) nearest->retained.overhangs = true;
    const struct lim_rect *open = &nearest->spans.open;
    struct lim_span_extent shown = lim_shape_lines(&shape, open);
    if (shown.top >= shown.bottom) return NOTHING_OPEN;
    if (lim_project_is_narrow(&pass->view, open)) {
        lim_edge_bounds_sides(&shape, at, n);
        if (!lim_shape_meets_sides(&shape, open)) return NOTHING_OPEN;
    }
    if (LIM_HAS_STATS) lim_stats_of(pass)->lines += (uint32_t)(shown.bottom - shown.top);
    if (LIM_HAS_FILLED && fills(nearest)) {
        const uint16_t colour = lim_memory_colour((uint16_t)record[1]);
        return fill_lines(nearest, at, n, shape.first, shown, colour) ? COLLECTED : EXHAUSTED_POOL;
    }
    if (!lim_nearest_retains_all(nearest)) {
        struct lim_span_extent seen = shown;
        if (!close_lines(&nearest->spans, at, n, shape.first, &seen, NULL, NULL) &&
            !close_with_room(nearest, at, n, shape.first, shown, &seen))
            return EXHAUSTED_POOL;
        if (seen.top >= seen.bottom) return COLLECTED;
        shown = seen;
    }
    if (LIM_HAS_STATS) lim_stats_of(pass)->polygons_seen++;
    const uint16_t texture = moves ? (uint16_t)LIM_NONE : texture_word(pass, record);
    const bool textured = LIM_HAS_TEXTURE && texture != LIM_NONE;
    if (textured) nearest->retained.textured = true;
    lim_retained_link(&nearest->spans, &nearest->retained, &nearest->spans.lines[shown.top], n, shape.first,
                      (uint16_t)((unsigned)shown.bottom | (textured ? LIM_RETAINED_TEXTURE : 0u)),
                      textured ? texture : lim_memory_colour((uint16_t)record[1]),
                      (uint16_t)(LIM_RETAINED_HEAD_CELLS + n));
    return COLLECTED;
}

/* A record that faces the eye. false: a pool is exhausted. */
static LIM_ALONE bool collect_record(struct lim_nearest *nearest, const LIM_FLASH lim_index *record)
{
    enum outcome outcome = !LIM_OPTIMISE_SIZE && is_for_fast_path(nearest, record)
                               ? collect_fast(nearest, &nearest->pass->view, nearest->pass->scene, record, false)
                               : SLOW_PATH;

    if (outcome == SLOW_PATH) outcome = collect_any(nearest, record) ? COLLECTED : EXHAUSTED_POOL;
    if (outcome == EXHAUSTED_POOL) return false;
    if (lim_nearest_retains_all(nearest) || !nearest->spans.open_lines) return true;
    if (outcome == COLLECTED) lim_spans_trim(&nearest->spans);
    if (++nearest->since_shrink == LIM_POLYGONS_PER_SHRINK) {
        nearest->since_shrink = 0;
        shrink(nearest);
    }
    return true;
}

/* Polygons from the walk through the tree. false: a pool is exhausted. */
static bool collect_run(struct lim_nearest *nearest, lim_index run)
{
    struct lim_pass *const pass = nearest->pass;
    const LIM_FLASH lim_index *record = &pass->scene->polygons[run];

    for (;;) {
        const lim_index head = record[0];
        if (LIM_HAS_STATS) lim_stats_of(pass)->records += (head & LIM_POLYGON_PLANE) != 0;
        if (lim_record_is_seen(&pass->walk->eye, record)) {
            if (!collect_record(nearest, record)) return false;
            if (!nearest->spans.open_lines) return true;
        }
        if (head & LIM_POLYGON_LAST) return true;
        record += lim_record_words(head);
    }
}

enum { MOVER_EXHAUSTED = 1, MOVER_FULL }; /* a pool; all lines */

static LIM_IF_CALLED int draw_mover(void *ctx, uint16_t entry, const struct lim_screen_polygon *polygon,
                                    const struct lim_rect *open)
{
    struct lim_nearest *nearest = ctx;

    (void)open;
    if (!(entry == LIM_NONE ? collect(nearest, polygon) : lim_collect_piece(nearest, entry, polygon)))
        return MOVER_EXHAUSTED;
    return nearest->spans.open_lines ? 0 : MOVER_FULL;
}

static LIM_IF_CALLED int take_mover(void *ctx, struct lim_view *view, const struct lim_scene *object,
                                    const LIM_FLASH lim_index *record)
{
    struct lim_nearest *nearest = ctx;

    if (!is_for_fast_path(nearest, record)) return LIM_MOVER_DRAW;
    const enum outcome outcome = collect_fast(nearest, view, object, record, true);
    if (outcome == SLOW_PATH) return LIM_MOVER_DRAW;
    if (outcome == EXHAUSTED_POOL) return MOVER_EXHAUSTED;
    return nearest->spans.open_lines ? 0 : MOVER_FULL;
}

/* What moves and has come to empty space. false: a pool is exhausted. */
static LIM_IF_CALLED bool collect_list(struct lim_nearest *nearest, uint16_t list)
{
    struct lim_sorter *const sorter = lim_nearest_sorter(nearest);
    const struct lim_mover_sink sink = {.draw = draw_mover,
                                        .take = LIM_OPTIMISE_SIZE ? NULL : take_mover,
                                        .ctx = nearest,
                                        .open = &nearest->spans.open,
                                        .back_to_front = false};

    list = lim_movers_order(sorter, list, false);
    if (lim_movers_draw(sorter, list, &sink) == MOVER_EXHAUSTED) return false;
    if (!lim_nearest_retains_all(nearest)) shrink(nearest);
    return true;
}

static LIM_IF_CALLED bool collect_with_movers(struct lim_nearest *nearest)
{
    struct lim_route route = lim_route_static(lim_nearest_sorter(nearest), false);
    lim_index what;

    lim_route_begin(&route, lim_movers_list(lim_nearest_sorter(nearest), lim_cull_of(nearest->pass)));
    while (nearest->spans.open_lines) {
        const enum lim_route_event event = lim_route_next(&route, &what);
        if (event == LIM_ROUTE_END) return true;
        if (!(event == LIM_ROUTE_RUN ? collect_run(nearest, what) : collect_list(nearest, (uint16_t)what)))
            return false;
    }
    return true;
}

static LIM_IF_CALLED bool collect_from_tree(struct lim_nearest *nearest, const struct lim_rect *band)
{
    lim_index run;

    if (LIM_HAS_CULL)
        lim_cull_set(lim_cull_of(nearest->pass), &nearest->pass->view, lim_eye_of(nearest->pass)->at_q8, band);
    if (LIM_HAS_MOVERS && lim_moves(lim_nearest_sorter(nearest))) return collect_with_movers(nearest);
    lim_walk_begin(nearest->pass->walk, false);
    while (nearest->spans.open_lines && (run = lim_walk_next(nearest->pass->walk, lim_cull_of(nearest->pass),
                                                             lim_stats_of(nearest->pass))) != LIM_NO_INDEX) {
        if (!collect_run(nearest, run)) return false;
    }
    return true;
}

/* From the sorted list. false: a pool is exhausted. */
static bool collect_entry(struct lim_nearest *nearest, uint16_t at)
{
    struct lim_sorter *const sorter = lim_nearest_sorter(nearest);
    const LIM_FLASH lim_index *record = &nearest->pass->scene->polygons[sorter->list[at].record];
    struct lim_screen_polygon polygon;

    if (!lim_project(&polygon, &nearest->pass->view, nearest->pass->scene, record, &nearest->spans.open,
                     lim_stats_of(nearest->pass)))
        return true;
    const bool has_room = LIM_HAS_NEWELL && lim_entry_is_split(sorter, at) ? lim_collect_piece(nearest, at, &polygon)
                                                                           : collect(nearest, &polygon);
    if (!has_room) return false;
    if (++nearest->since_shrink < LIM_POLYGONS_PER_SHRINK) return true;
    nearest->since_shrink = 0;
    (void)lim_spans_shrink(&nearest->spans);
    return true;
}

static bool collect_from_list(struct lim_nearest *nearest)
{
    struct lim_sorter *const sorter = lim_nearest_sorter(nearest);

    for (uint16_t at = sorter->first; at != LIM_NONE && nearest->spans.open_lines; at = sorter->list[at].next)
        if (!collect_entry(nearest, at)) return false;
    return true;
}

static bool collect_from_source(struct lim_nearest *nearest, const struct lim_rect *band)
{
    if (IS_LISTED(nearest)) return collect_from_list(nearest);
    return collect_from_tree(nearest, band);
}

bool lim_collect(struct lim_nearest *nearest, const struct lim_rect *band)
{
    lim_nearest_open(nearest, band);
    if (!collect_from_source(nearest, band)) return false;
    if (LIM_HAS_STATS) lim_nearest_note_pools(nearest);
    return true;
}

/* The same in quanta, over all lines. What a loop above has in variables is in struct lim_progress. */

/* Records up to the next that faces the eye, and that one. */
static LIM_IF_CALLED bool collect_some_of_run(struct lim_nearest *nearest)
{
    const LIM_FLASH lim_index *record = nearest->progress.record;

    for (bool is_seen = false; record && !is_seen;) {
        const lim_index head = record[0];
        if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->records += (head & LIM_POLYGON_PLANE) != 0;
        is_seen = lim_record_is_seen(&nearest->pass->walk->eye, record);
        if (is_seen && !collect_record(nearest, record)) return false;
        record = head & LIM_POLYGON_LAST || !nearest->spans.open_lines ? NULL : record + lim_record_words(head);
    }
    nearest->progress.record = record;
    return true;
}

static LIM_IF_CALLED void begin_tree(struct lim_nearest *nearest, const struct lim_rect *frame)
{
    nearest->progress.record = NULL;
    if (LIM_HAS_CULL)
        lim_cull_set(lim_cull_of(nearest->pass), &nearest->pass->view, lim_eye_of(nearest->pass)->at_q8, frame);
    if (LIM_HAS_MOVERS && lim_moves(lim_nearest_sorter(nearest))) {
        *nearest->progress.route = lim_route_static(lim_nearest_sorter(nearest), false);
        lim_route_begin(nearest->progress.route,
                        lim_movers_list(lim_nearest_sorter(nearest), lim_cull_of(nearest->pass)));
        return;
    }
    lim_walk_begin(nearest->pass->walk, false);
}

/* LIM_NO_INDEX: there is none. With movers, they may come instead. */
static LIM_IF_CALLED enum lim_route_event next_of_tree(struct lim_nearest *nearest, lim_index *what)
{
    if (LIM_HAS_MOVERS && lim_moves(lim_nearest_sorter(nearest))) return lim_route_next(nearest->progress.route, what);
    *what = lim_walk_next(nearest->pass->walk, lim_cull_of(nearest->pass), lim_stats_of(nearest->pass));
    return *what == LIM_NO_INDEX ? LIM_ROUTE_END : LIM_ROUTE_RUN;
}

/* A quantum: a polygon, or what has moved to one place. */
static LIM_IF_CALLED enum lim_ahead_stage collect_some_of_tree(struct lim_nearest *nearest)
{
    lim_index what;

    if (!nearest->progress.record) {
        const enum lim_route_event event = nearest->spans.open_lines ? next_of_tree(nearest, &what) : LIM_ROUTE_END;
        if (event == LIM_ROUTE_END) return LIM_AHEAD_DONE;
        if (LIM_HAS_MOVERS && event == LIM_ROUTE_LIST)
            return collect_list(nearest, (uint16_t)what) ? LIM_AHEAD_BUSY : LIM_AHEAD_EXHAUSTED;
        nearest->progress.record = &nearest->pass->scene->polygons[what];
    }
    return collect_some_of_run(nearest) ? LIM_AHEAD_BUSY : LIM_AHEAD_EXHAUSTED;
}

static LIM_IF_CALLED enum lim_ahead_stage collect_some_of_list(struct lim_nearest *nearest)
{
    const uint16_t at = nearest->progress.entry;

    if (at == LIM_NONE || !nearest->spans.open_lines) return LIM_AHEAD_DONE;
    nearest->progress.entry = lim_nearest_sorter(nearest)->list[at].next;
    return collect_entry(nearest, at) ? LIM_AHEAD_BUSY : LIM_AHEAD_EXHAUSTED;
}

void lim_collect_begin(struct lim_nearest *nearest, const struct lim_rect *frame)
{
    lim_nearest_open(nearest, frame);
    if (IS_LISTED(nearest))
        nearest->progress.entry = lim_nearest_sorter(nearest)->first;
    else
        begin_tree(nearest, frame);
}

enum lim_ahead_stage lim_collect_some(struct lim_nearest *nearest)
{
    const enum lim_ahead_stage stage =
        IS_LISTED(nearest) ? collect_some_of_list(nearest) : collect_some_of_tree(nearest);

    if (LIM_HAS_STATS && stage == LIM_AHEAD_DONE) lim_nearest_note_pools(nearest);
    return stage;
}

#endif
