/* SPDX-License-Identifier: MIT
 *
 * What is not flat colour alone (flat.c): the list of active polygons is kept in walk order, which is the order of
 * their cells. New ones arrive far to near (retain.h), so each is put in front of the one before it or further up. */
#include "lines/paint.h"

#include "lines/active.h"
#include "lines/crowd.h"
#include "lines/layers.h"
#include "lines/overlaid.h"
#include "lines/retain.h"
#include "lines/span.h"
#include "lines/wireframe.h"
#include "pixels/delta.h"
#include "pixels/fill.h"
#include "pixels/runs.h"
#include "pixels/texture.h"
#include "view/pass.h"
#include "view/view.h"

#if LIM_HAS_SPANS

static const union lim_retained_cell *paint_cells_of(const struct lim_retained *retained,
                                                     const struct lim_active *active)
{
    return &retained->cells[active->polygon];
}

/* Starts one polygon on line y. false: no room. */
static bool activate(struct lim_paint *paint, const struct lim_spans *spans, const struct lim_retained *retained,
                     uint16_t polygon, uint16_t y)
{
    const union lim_retained_cell *cells = &retained->cells[polygon];
    struct lim_active **link = &paint->actives.first, *active = lim_active_new(&paint->actives, spans, y);

    if (!active) return false;
    while (*link && (*link)->polygon < polygon)
        link = &(*link)->next;
    active->next = *link;
    *link = active;
    if (LIM_HAS_TEXTURE && lim_retained_has_texture(cells))
        lim_texture_set(paint->pass->texturing, cells[1].look.colour, lim_active_points(cells), cells[0].link.n,
                        active->gradients);
    lim_active_begin(&paint->actives, active, retained, polygon, (int16_t)y);
    return true;
}

static bool activate_line(struct lim_paint *paint, const struct lim_spans *spans, const struct lim_retained *retained,
                          uint16_t polygon, uint16_t y)
{
    for (; polygon != LIM_NONE; polygon = retained->cells[polygon].link.next)
        if (!activate(paint, spans, retained, polygon, y)) return false;
    return true;
}

struct sink {
    uint16_t *line;
    uint16_t colour;
    uint16_t painted_px;
    LIM_OPTIONAL(struct lim_wire, wire, LIM_HAS_WIREFRAME);        /* of no corners: polygons are filled */
    LIM_OPTIONAL(struct lim_textured_span, span, LIM_HAS_TEXTURE); /* no gradients: of one colour */
    LIM_OPTIONAL(struct lim_stats *, stats, LIM_HAS_TEXTURE);
    LIM_OPTIONAL(struct lim_delta *, notes, LIM_HAS_DELTA); /* of this line's pieces, or NULL */
};

static inline bool is_textured(const struct sink *sink)
{
    return LIM_HAS_TEXTURE && sink->span->gradients;
}

/* true: noted, and not to be painted. */
static inline bool note(const struct sink *sink, uint16_t x0, uint16_t x1, uint32_t look)
{
    if (!LIM_HAS_DELTA || !*sink->notes) return false;
    lim_delta_note(*sink->notes, x0, x1, look);
    return !sink->line;
}

static inline void set_wire(struct sink *sink, const struct lim_paint *paint, const union lim_retained_cell *cells,
                            uint16_t y)
{
    const struct lim_wireframe *style = lim_wireframe_of(paint->pass);
    const uint8_t n = cells[0].link.n;

    sink->wire->n = 0;
    if (!style) return;
    *sink->wire = (struct lim_wire){.at = lim_active_points(cells),
                                    .hidden = cells[LIM_RETAINED_HEAD_CELLS + n].hidden,
                                    .colour = style->one_colour ? lim_memory_colour(style->colour) : sink->colour,
                                    .background = paint->background,
                                    .y = (int16_t)y,
                                    .n = n};
}

static inline void set_span(struct sink *sink, struct lim_active *active, const union lim_retained_cell *cells,
                            int32_t left, int32_t right)
{
    sink->span->gradients = lim_retained_has_texture(cells) ? active->gradients : NULL;
    sink->span->left = left;
    sink->span->right = right;
}

/* Whether all that a piece takes are texels in perspective, as most textured pieces do. */
static inline bool is_perspective(const struct sink *sink)
{
    const bool is_painted = LIM_HAS_TEXTURE && !LIM_HAS_DELTA && !LIM_HAS_WIREFRAME && !LIM_HAS_STATS;

    return is_painted && is_textured(sink) && !sink->span->gradients->is_even;
}

static lim_piece_fill paint_piece;

/* What a run of the piece is for delta output. */
static inline uint32_t look_of(const struct sink *sink)
{
    if (!is_textured(sink)) return sink->colour;
    if (LIM_HAS_MOVERS && sink->colour >= lim_texture_numbers(sink->span->texturing->scene))
        return sink->colour | LIM_RUN_TEXTURED | LIM_RUN_MOVES;
    return sink->colour | LIM_RUN_TEXTURED;
}

static void paint_piece(void *ctx, uint16_t x0, uint16_t x1)
{
    struct sink *sink = ctx;

    if (LIM_HAS_TEXTURE && LIM_HOT && is_perspective(sink)) {
        (void)lim_texture_fill_stretches(sink->span, sink->line, x0, x1);
        return;
    }
    if (!note(sink, x0, x1, look_of(sink))) {
        if (LIM_HAS_WIREFRAME && sink->wire->n)
            lim_wire_fill(sink->line, sink->wire, x0, x1);
        else if (LIM_HAS_TEXTURE && is_textured(sink))
            lim_texture_fill(sink->span, sink->line, x0, x1, *sink->stats);
        else
            lim_fill(sink->line, x0, (uint16_t)(x1 - x0), sink->colour);
    }
    if (LIM_HAS_STATS) sink->painted_px = (uint16_t)(sink->painted_px + x1 - x0);
}

/* Moves a polygon to line y. false: it has ended. */
static bool paint_advance(struct lim_active *active, const union lim_retained_cell *cells, int16_t y)
{
    if (LIM_HOT && y < (int16_t)active->turn) { /* most lines: nothing ends */
        lim_edge_step(&active->pair.left);
        lim_edge_step(&active->pair.right);
        return true;
    }
    if (y >= (int16_t)lim_retained_bottom(cells)) return false;
    if (active->pair.left.end > y) lim_edge_step(&active->pair.left);
    if (active->pair.right.end > y) lim_edge_step(&active->pair.right);
    if (y >= (int16_t)active->turn) lim_active_turn(active, cells, y);
    return true;
}

/* A transparent polygon leaves its pixels open. */
static LIM_IF_CALLED void push_layers(struct lim_paint *paint, const struct lim_spans *spans,
                                      const struct lim_line *open, struct lim_active *active,
                                      const union lim_retained_cell *cells, int32_t x0, int32_t x1)
{
    if (LIM_HAS_MASKED)
        lim_layers_mask(paint->layers, lim_retained_has_texture(cells) ? active->gradients : NULL,
                        lim_edge_x(&active->pair.left), lim_edge_x(&active->pair.right));
    const struct lim_layer piece = {.x0 = x0 > 0 ? (uint16_t)x0 : 0,
                                    .x1 = x1 > 0 ? (uint16_t)x1 : 0,
                                    .colour = cells[1].look.colour,
                                    .alpha = LIM_HAS_MASKED ? lim_layers_alpha(paint->layers, lim_retained_alpha(cells))
                                                            : lim_retained_alpha(cells)};

    if (!paint->layers->exhausted) lim_layers_push(paint->layers, spans, open, &piece);
}

/* What of [left, right) is open. */
static inline void paint_open(struct lim_spans *spans, struct lim_line *open, int32_t x0, int32_t x1, struct sink *sink)
{
    if (!LIM_HOT || open->gap.next != LIM_NONE)
        (void)lim_span_close(spans, open, (int16_t)x0, (int16_t)x1, paint_piece, sink);
    else if (lim_gap_close_only(spans, &open->gap, &x0, &x1) != LIM_SPAN_SOME)
        return;
    else if (LIM_HAS_TEXTURE && is_perspective(sink))
        (void)lim_texture_fill_stretches(sink->span, sink->line, x0, x1);
    else
        paint_piece(sink, (uint16_t)x0, (uint16_t)x1);
}

/* Pixels x0 <= x < x1 of what an active polygon has on line y. */
static inline void sink_part(struct lim_paint *paint, struct lim_spans *spans, struct lim_line *open,
                             struct lim_active *active, const union lim_retained_cell *cells, int32_t x0, int32_t x1,
                             struct sink *sink)
{
    if (x0 >= x1) return;
    if (LIM_HAS_TRANSPARENT && lim_retained_alpha(cells) != LIM_OPAQUE)
        push_layers(paint, spans, open, active, cells, x0, x1);
    else
        paint_open(spans, open, x0, x1, sink);
}

static inline void set_sink_look(struct sink *sink, const struct lim_paint *paint, struct lim_active *active,
                                 const union lim_retained_cell *cells, uint16_t y, int32_t left, int32_t right)
{
    sink->colour = cells[1].look.colour;
    if (LIM_HAS_TEXTURE) set_span(sink, active, cells, left, right);
    if (LIM_HAS_WIREFRAME) set_wire(sink, paint, cells, y);
}

/* Of a line with cuts. */
struct paint_cut {
    struct lim_paint *paint;
    struct lim_spans *spans;
    const struct lim_retained *retained;
    struct lim_line *open;
    struct sink *sink;
    uint16_t y;
};

static lim_crowd_part paint_cut_part;
static LIM_IF_CALLED void paint_cut_part(void *ctx, struct lim_active *active, int32_t x0, int32_t x1)
{
    const struct paint_cut *const cut = ctx;
    const union lim_retained_cell *cells = paint_cells_of(cut->retained, active);
    const int32_t left = lim_edge_x(&active->pair.left), right = lim_edge_x(&active->pair.right);

    set_sink_look(cut->sink, cut->paint, active, cells, cut->y, left, right);
    sink_part(cut->paint, cut->spans, cut->open, active, cells, left > x0 ? left : x0, right < x1 ? right : x1,
              cut->sink);
}

static void paint_polygons(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                           struct lim_line *open, uint16_t y, struct sink *sink)
{
    struct lim_active **link = &paint->actives.first;
    const struct lim_gap within = {open->gap.x0, open->gap.x1, LIM_NONE};
    const bool is_cut = lim_crowd_cuts(&paint->actives);

    if (LIM_HAS_MOVERS && is_cut)
        lim_crowd_paint(&paint->actives, &within, paint_cut_part,
                        &(struct paint_cut){paint, spans, retained, open, sink, y});
    while (*link) {
        struct lim_active *active = *link;
        const union lim_retained_cell *cells = paint_cells_of(retained, active);
        const int32_t left = lim_edge_x(&active->pair.left), right = lim_edge_x(&active->pair.right);
        if (!is_cut) {
            set_sink_look(sink, paint, active, cells, y, left, right);
            sink_part(paint, spans, open, active, cells, left, right, sink);
        }
        if (paint_advance(active, cells, (int16_t)(y + 1)))
            link = &active->next;
        else
            lim_active_give_back(&paint->actives, link);
    }
}

static void paint_background(const struct lim_spans *spans, const struct lim_line *open, const struct lim_paint *paint,
                             const struct sink *sink)
{
    struct lim_stats *stats = lim_stats_of(paint->pass);
    const struct lim_gap *gap = &open->gap;

    for (;;) {
        if (gap->x0 < gap->x1 && !note(sink, gap->x0, gap->x1, paint->background))
            lim_fill(sink->line, gap->x0, (uint16_t)(gap->x1 - gap->x0), paint->background);
        if (LIM_HAS_STATS) stats->pixels_background += (uint16_t)(gap->x1 - gap->x0);
        if (gap->next == LIM_NONE) return;
        gap = &spans->pool[gap->next];
    }
}

/* What becomes of a line's pieces: delta output wants to know what they are, and paints what it sends by itself. It
 * looks at what is mixed or drawn over when it is painted, and cannot paint textures. */
enum line_use { PAINTED, NOTED, PAINTED_AND_NOTED };

static enum line_use use_of_line(const struct lim_paint *paint, const struct lim_retained *retained,
                                 const struct lim_rect *band, uint16_t y)
{
    if (!LIM_HAS_DELTA || !*paint->delta || lim_wireframe_of(paint->pass)) return PAINTED;
    if (lim_is_overlaid(paint->pass, y)) return PAINTED;
    if (band->x1 - band->x0 < paint->pass->target.w_px) return PAINTED; /* pieces of lines are sent as they are */
    enum line_use use = lim_delta_wants_lines(*paint->delta) ? PAINTED_AND_NOTED : NOTED;
    if (!LIM_HAS_TRANSPARENT && !LIM_HAS_TEXTURE) return use;
    for (const struct lim_active *active = paint->actives.first; active; active = active->next) {
        const union lim_retained_cell *cells = paint_cells_of(retained, active);
        if (LIM_HAS_TRANSPARENT && lim_retained_alpha(cells) != LIM_OPAQUE) return PAINTED;
        if (lim_retained_has_texture(cells)) use = PAINTED_AND_NOTED;
    }
    return use;
}

/* What the sink needs but a line and a colour. */
static inline void begin_sink(struct sink *sink, const struct lim_paint *paint, uint16_t y, enum line_use use)
{
    if (LIM_HAS_DELTA) {
        *sink->notes = use == PAINTED ? NULL : *paint->delta;
        if (*sink->notes) lim_delta_begin_line(*sink->notes, sink->line);
    }
    if (LIM_HAS_TEXTURE) {
        sink->span->texturing = paint->pass->texturing;
        sink->span->y = y;
        *sink->stats = lim_stats_of(paint->pass);
    }
}

static inline bool may_have_layers(const struct lim_retained *retained)
{
    return retained->transparent || (LIM_HAS_MASKED && retained->masked);
}

static int paint_line(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                      const struct lim_rect *band, struct lim_paint_stop *stop)
{
    const uint16_t y = stop->y;
    const struct lim_target *target = &paint->pass->target;
    struct lim_stats *stats = lim_stats_of(paint->pass);
    struct lim_line open;
    struct sink sink;

    lim_line_open(&open, target, band, y);
    const uint16_t x0 = LIM_HAS_ROUND ? open.gap.x0 : band->x0, x1 = LIM_HAS_ROUND ? open.gap.x1 : band->x1;
    if (!lim_crowd_line(paint, spans, retained, &open.gap, y, LIM_CROWD_GAPS))
        return lim_paint_stops(stop, LIM_PAINT_ACTIVE);
    sink.colour = sink.painted_px = 0;
    const enum line_use use = use_of_line(paint, retained, band, y);
    sink.line = use == NOTED ? NULL : lim_paint_lend(paint, y);
    if (use != NOTED && !sink.line) return LIM_ERR_TARGET;
    begin_sink(&sink, paint, y, use);
    if (LIM_HAS_MASKED) lim_layers_begin(paint->layers, paint->pass->texturing, y);
    lim_actives_count(&paint->actives, spans, stats, y);
    if (LIM_HAS_TRANSPARENT && may_have_layers(retained)) lim_layers_open(paint->layers, &paint->actives, spans, y);
    lim_spans_reset_pool(spans);
    paint_polygons(paint, spans, retained, &open, y, &sink);
    paint_background(spans, &open, paint, &sink);
    if (LIM_HAS_STATS) stats->pixels_painted += sink.painted_px;
    if (LIM_HAS_TRANSPARENT && !lim_layers_finish(paint->layers, sink.line, stats)) {
        *paint->lent = sink.line;
        return lim_paint_stops(stop, LIM_PAINT_LAYERS);
    }
    lim_overlay_line(paint->pass, sink.line, y, x0, x1);
    return target->done(target->ctx, y, x0, (uint16_t)(x1 - x0));
}

/* Whether all that is retained is opaque, and is only to be painted. A texture takes longer to paint twice than a
 * colour does: so they come here where each polygon is painted all over, and no gaps are known. */
static inline bool is_flat(const struct lim_paint *paint, const struct lim_retained *retained)
{
    if (LIM_HAS_DELTA && *paint->delta) return false;
    if (lim_wireframe_of(paint->pass)) return false;
    if (LIM_HAS_TRANSPARENT && retained->transparent) return false;
    return !LIM_HAS_TEXTURE || !retained->textured || LIM_IS_SCANLINE(&paint->pass->target);
}

int lim_paint_band(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                   const struct lim_rect *band, struct lim_paint_stop *stop)
{
    if (LIM_HAS_ANTIALIAS && lim_is_antialiased(&paint->pass->view))
        return lim_smooth_band(paint, spans, retained, band, stop);
    if (is_flat(paint, retained)) return lim_flat_band(paint, spans, retained, band, stop);
    lim_actives_start(&paint->actives, spans, true);
    for (stop->y = band->y0; stop->y < band->y1; stop->y++) {
        if (!activate_line(paint, spans, retained, spans->lines[stop->y].retained, stop->y))
            return lim_paint_stops(stop, LIM_PAINT_ACTIVE);
        const int err = paint_line(paint, spans, retained, band, stop);
        if (err || stop->exhausted) return err;
    }
    return 0;
}

#endif
