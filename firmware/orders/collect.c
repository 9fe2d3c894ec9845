/* SPDX-License-Identifier: MIT
 *
 * Nearest first, pass one for one polygon: it closes the gaps that are open, and is retained if there was any; by scan
 * lines whenever it is in view. nearest.c says which one is next. */
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
#include "movers/meet.h"
#include "orders/room.h"
#include "pieces/mesh_leaf.h"
#include "screen/project.h"
#include "screen/samples.h"
#include "view/cull.h"

#if LIM_HAS_SPANS

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

/* Whether it leaves open what it has of the screen: its pixels are divided line by line (crowd.h). A constant where
 * nothing moves. */
static inline bool stays_open(const struct lim_nearest *nearest)
{
    return LIM_HAS_MOVERS && *nearest->moves;
}

/* collect_plain() for a polygon that is drawn by its samples: it is retained up to a row of them. */
static inline bool collect_samples(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon,
                                   struct lim_span_extent shown)
{
    if (nearest->paint.smooth->line) {
        if (LIM_HAS_MOVERS && *nearest->by_pixel == LIM_BY_PIXEL_SAMPLES)
            lim_collect_samples_of_pixel(nearest, polygon);
        else
            lim_smooth_add_polygon(&nearest->paint, &nearest->spans, polygon);
        return true;
    }
    if (!lim_nearest_retains_all(nearest) && !lim_smooth_close(&nearest->spans, polygon, &shown, stays_open(nearest)))
        return false;
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

    return !(record[0] & slow) && !lim_wireframe_of(nearest->pass) && !lim_is_antialiased(&nearest->pass->view) &&
           !(LIM_HAS_MOVERS && *nearest->by_pixel);
}

/* A polygon that is not non-monotone. false: a pool is exhausted. */
static bool collect_plain(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon)
{
    struct lim_span_extent shown = lim_shape_lines(&polygon->shape, &nearest->spans.open);

    if (shown.top >= shown.bottom) return true;
    if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->lines += (uint32_t)(shown.bottom - shown.top);
    if (LIM_HAS_FILLED && fills(nearest))
        return fill_lines(nearest, polygon->at, polygon->n, polygon->shape.first, shown, polygon->colour);
    if (LIM_HAS_MOVERS && *nearest->by_pixel >= LIM_BY_PIXEL_OPAQUE) {
        lim_collect_look_of_pixel(nearest, polygon);
        return true;
    }
    if (LIM_HAS_ANTIALIAS && lim_is_antialiased(&nearest->pass->view)) return collect_samples(nearest, polygon, shown);
    const bool wireframe = lim_wireframe_of(nearest->pass);
    const uint8_t alpha = wireframe ? (uint8_t)LIM_OPAQUE : lim_alpha_of(polygon);
    if (stays_open(nearest) || (LIM_HAS_TRANSPARENT && alpha != LIM_OPAQUE)) {
        if (!lim_nearest_retains_all(nearest) &&
            !lim_spans_see(&nearest->spans, polygon->at, polygon->n, polygon->shape.first, shown))
            return true;
    } else if (!lim_nearest_retains_all(nearest)) {
        const struct lim_span_extent lines = shown;
        shown = (struct lim_span_extent){lines.bottom, lines.top};
        if (!close_with_room(nearest, polygon->at, polygon->n, polygon->shape.first, lines, &shown)) return false;
    }
    if (shown.top >= shown.bottom) return true;
    if (LIM_HAS_MOVERS && !lim_wins_pixel(nearest, polygon->at, polygon->n, polygon->shape.first)) return true;
    if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->polygons_seen++;
    const struct lim_retained_polygon seen = lim_retained_of(polygon, shown.top, shown.bottom, wireframe);
    return retain_with_room(nearest, &seen);
}

bool lim_collect_polygon(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon)
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
           lim_collect_polygon(nearest, &polygon);
}

enum outcome {
    NOTHING_OPEN, /* nothing of it can be */
    COLLECTED,    /* all of it that was open is closed, and it is retained if there was any */
    EXHAUSTED_POOL,
    SLOW_PATH /* nothing was done: collect_any() */
};

/* lim_screen_polygon.texture; LIM_NONE of any record: textures may have been taken away. */
static inline uint16_t texture_named(const struct lim_scene *scene, const LIM_FLASH lim_index *record)
{
    if (!LIM_HAS_TEXTURE || !(record[0] & LIM_POLYGON_TEXTURE) || !lim_texture_count(scene)) return LIM_NONE;
    if (lim_mappings_name_textures(scene)) return lim_record_mapping(record);
    return (uint16_t)(record + lim_record_words(record[0]) - LIM_POLYGON_TEXTURE_WORDS - scene->polygons);
}

/* An object that moves, and from where on its textures are numbered (lim_mover_first_texture()). */
struct moving_look {
    const struct lim_scene *object;
    uint16_t first_texture;
};

static inline uint16_t moving_texture(const struct moving_look *moving, const LIM_FLASH lim_index *record)
{
    const uint16_t own = moving->first_texture == LIM_NONE ? LIM_NONE : texture_named(moving->object, record);

    return (uint16_t)(own == LIM_NONE ? LIM_NONE : moving->first_texture + own);
}

/* A polygon that is opaque and neither clipped nor non-monotone, whose points lie where they would be retained: none of
 * it is ever copied. moving: NULL, of what stands still. */
static inline enum outcome collect_shape(struct lim_nearest *nearest, const LIM_FLASH lim_index *record,
                                         struct lim_point *at, uint8_t n, struct lim_edge_shape *shape,
                                         const struct moving_look *moving)
{
    struct lim_pass *const pass = nearest->pass;
    const struct lim_rect *open = &nearest->spans.open;
    struct lim_span_extent shown = lim_shape_lines(shape, open);

    if (shown.top >= shown.bottom) return NOTHING_OPEN;
    if (lim_project_is_narrow(&pass->view, open)) {
        lim_edge_bounds_sides(shape, at, n);
        if (!lim_shape_meets_sides(shape, open)) return NOTHING_OPEN;
    }
    if (LIM_HAS_STATS) lim_stats_of(pass)->lines += (uint32_t)(shown.bottom - shown.top);
    if (LIM_HAS_FILLED && fills(nearest)) {
        const uint16_t colour = lim_memory_colour((uint16_t)record[1]);
        return fill_lines(nearest, at, n, shape->first, shown, colour) ? COLLECTED : EXHAUSTED_POOL;
    }
    if (moving && stays_open(nearest)) {
        if (!lim_nearest_retains_all(nearest) && !lim_spans_see(&nearest->spans, at, n, shape->first, shown))
            return NOTHING_OPEN;
    } else if (!lim_nearest_retains_all(nearest)) {
        struct lim_span_extent seen = shown;
        if (!close_lines(&nearest->spans, at, n, shape->first, &seen, NULL, NULL) &&
            !close_with_room(nearest, at, n, shape->first, shown, &seen))
            return EXHAUSTED_POOL;
        if (seen.top >= seen.bottom) return COLLECTED;
        shown = seen;
    }
    if (LIM_HAS_STATS) lim_stats_of(pass)->polygons_seen++;
    const uint16_t texture =
        LIM_HAS_MOVERS && moving ? moving_texture(moving, record) : texture_named(pass->scene, record);
    const bool textured = LIM_HAS_TEXTURE && texture != LIM_NONE;
    if (textured) nearest->retained.textured = true;
    lim_retained_link(&nearest->spans, &nearest->retained, &nearest->spans.lines[shown.top], n, shape->first,
                      (uint16_t)((unsigned)shown.bottom | (textured ? LIM_RETAINED_TEXTURE : 0u)),
                      textured ? texture : lim_memory_colour((uint16_t)record[1]),
                      (uint16_t)(LIM_RETAINED_HEAD_CELLS + n));
    return COLLECTED;
}

/* Of a record as most are, where there is room for its points. */
static inline enum outcome collect_fast(struct lim_nearest *nearest, struct lim_view *view,
                                        const struct lim_scene *scene, const LIM_FLASH lim_index *record,
                                        const struct moving_look *moving)
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
    return collect_shape(nearest, record, at, n, &shape, moving);
}

/* What follows a polygon. false: a pool is exhausted. */
static inline bool go_on_after(struct lim_nearest *nearest, enum outcome outcome)
{
    if (outcome == EXHAUSTED_POOL) return false;
    if (lim_nearest_retains_all(nearest) || !nearest->spans.open_lines) return true;
    if (outcome == COLLECTED) lim_spans_trim(&nearest->spans);
    if (++nearest->since_shrink == LIM_POLYGONS_PER_SHRINK) {
        nearest->since_shrink = 0;
        lim_nearest_shrink(nearest);
    }
    return true;
}

/* A record that faces the eye. false: a pool is exhausted. */
bool lim_collect_record(struct lim_nearest *nearest, const LIM_FLASH lim_index *record)
{
    enum outcome outcome = !LIM_OPTIMISE_SIZE && is_for_fast_path(nearest, record)
                               ? collect_fast(nearest, &nearest->pass->view, nearest->pass->scene, record, NULL)
                               : SLOW_PATH;

    if (outcome == SLOW_PATH) outcome = collect_any(nearest, record) ? COLLECTED : EXHAUSTED_POOL;
    return go_on_after(nearest, outcome);
}

#if LIM_HAS_MOVERS
enum lim_collected lim_collect_moving(struct lim_nearest *nearest, struct lim_view *view,
                                      const struct lim_scene *object, const LIM_FLASH lim_index *record,
                                      uint16_t first_texture)
{
    const struct moving_look moving = {object, first_texture};

    if (!is_for_fast_path(nearest, record)) return LIM_COLLECT_SLOWLY;
    const enum outcome outcome = collect_fast(nearest, view, object, record, &moving);
    if (outcome == SLOW_PATH) return LIM_COLLECT_SLOWLY;
    return outcome == EXHAUSTED_POOL ? LIM_COLLECT_EXHAUSTED : LIM_COLLECTED;
}
#endif

/* Mesh leaves ------------------------------------------------------------------------------------------------------ */

#if LIM_HAS_MESH_LEAVES

/* collect_fast() where points are known. */
static inline enum outcome collect_fast_entry(struct lim_nearest *nearest, const LIM_FLASH lim_index *record)
{
    const struct lim_mesh_leaf *leaf = *nearest->leaf;
    const uint8_t n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    struct lim_point *at = lim_retained_place(&nearest->spans, &nearest->retained, n);
    struct lim_edge_shape shape;

    if (!at || !lim_mesh_leaf_corners(leaf, record, n, at) || !lim_edge_bounds_plain(&shape, at, n)) return SLOW_PATH;
    if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->polygons++;
    return collect_shape(nearest, record, at, n, &shape, NULL);
}

static LIM_RARE bool collect_any_entry(struct lim_nearest *nearest, const LIM_FLASH lim_index *record)
{
    struct lim_screen_polygon polygon;

    return !lim_mesh_leaf_project(&polygon, *nearest->leaf, record, &nearest->spans.open,
                                  lim_stats_of(nearest->pass)) ||
           lim_collect_polygon(nearest, &polygon);
}

static lim_collect_one collect_leaf_record;
static bool collect_leaf_record(struct lim_nearest *nearest, const LIM_FLASH lim_index *record)
{
    enum outcome outcome =
        !LIM_OPTIMISE_SIZE && is_for_fast_path(nearest, record) ? collect_fast_entry(nearest, record) : SLOW_PATH;

    if (outcome == SLOW_PATH) outcome = collect_any_entry(nearest, record) ? COLLECTED : EXHAUSTED_POOL;
    return go_on_after(nearest, outcome);
}

/* The same where something moves, as far as it has to be asked. */
static bool collect_of_leaf(struct lim_nearest *nearest, const LIM_FLASH lim_index *record)
{
    if (LIM_HAS_MOVERS && lim_nearest_moves(nearest) && lim_meet_asks(nearest->progress.route))
        return lim_collect_met(nearest, record, true, collect_leaf_record);
    return collect_leaf_record(nearest, record);
}

static bool line_may_show(const struct lim_spans *spans, const struct lim_line *line, uint16_t x0, uint16_t x1)
{
    const struct lim_gap *gap = &line->gap;

    if (LIM_HAS_ANTIALIAS && lim_spans_have_strips(spans)) return gap->x0 < x1 && gap->x1 > x0;
    for (; gap; gap = lim_gap_after(spans, gap))
        if (gap->x0 < x1 && gap->x1 > x0 && gap->x0 < gap->x1) return true;
    return false;
}

/* Whether a pixel within may be open: antialiased, a pixel between open ones counts. */
static bool spans_may_show(const struct lim_spans *spans, const struct lim_rect *within)
{
    const struct lim_rect *open = &spans->open;
    const uint16_t y1 = within->y1 < open->y1 ? within->y1 : open->y1;

    for (uint16_t y = within->y0 > open->y0 ? within->y0 : open->y0; y < y1; y++)
        if (line_may_show(spans, &spans->lines[y], within->x0, within->x1)) return true;
    return false;
}

/* Whether all of the leaf lies behind what is closed: then its vertices need not be projected. */
static bool is_hidden_leaf(const struct lim_nearest *nearest, const LIM_FLASH lim_index *run)
{
    const struct lim_pass *pass = nearest->pass;
    const lim_index box = lim_mesh_leaf_words(run)[LIM_MESH_LEAF_BOX];
    struct lim_rect rect;

    return !lim_nearest_retains_all(nearest) && lim_view_box_rect(&pass->view, &pass->scene->boxes[box], &rect) &&
           !spans_may_show(&nearest->spans, &rect);
}

bool lim_collect_mesh_leaf(struct lim_nearest *nearest, const LIM_FLASH lim_index *run)
{
    struct lim_pass *const pass = nearest->pass;
    const struct lim_mesh_leaf_seen seen = {pass->scene, &pass->view, false};
    struct lim_mesh_leaf *const leaf = *nearest->leaf;
    const LIM_FLASH lim_index *record;

    if (is_hidden_leaf(nearest, run)) return true;
    lim_mesh_leaf_sort(leaf, &seen, run);
    if (LIM_HAS_STATS) {
        lim_stats_of(pass)->records += lim_mesh_leaf_words(run)[LIM_MESH_LEAF_POLYGONS];
        lim_stats_of(pass)->leaf_records += lim_mesh_leaf_words(run)[LIM_MESH_LEAF_POLYGONS];
        if (leaf->used > lim_stats_of(pass)->leaf_polygons_max) lim_stats_of(pass)->leaf_polygons_max = leaf->used;
    }
    if (leaf->extent != LIM_VIEW_INSIDE) nearest->retained.overhangs = true;
    while (nearest->spans.open_lines && (record = lim_mesh_leaf_next(leaf)) != NULL)
        if (!collect_of_leaf(nearest, record)) return false;
    return true;
}

#endif

#endif
