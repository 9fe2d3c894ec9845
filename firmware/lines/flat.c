/* SPDX-License-Identifier: MIT
 *
 * The polygons that cross a line are kept from far to near, as retain.h lists those that start on it. What is nearer
 * paints over what is farther, so each pixel ends as the nearest polygon's: the picture of pass one. */
#include "lines/active.h"
#include "lines/crowd.h"
#include "lines/overlaid.h"
#include "lines/paint.h"
#include "lines/span.h"
#include "pixels/fill.h"
#include "pixels/texture.h"
#include "screen/edge.h"
#include "view/pass.h"

#if LIM_HAS_SPANS

static LIM_IF_CALLED void flat_set_texture(const struct lim_pass *pass, const struct lim_retained *retained,
                                           struct lim_active *active)
{
    const union lim_retained_cell *cells = &retained->cells[active->polygon];

    active->gradients->texture = NULL;
    if (lim_retained_has_texture(cells))
        lim_texture_set(pass->texturing, cells[1].look.colour, lim_active_points(cells), cells[0].link.n,
                        active->gradients);
}

/* Merges those that start on the line into the list. false: no room. */
static LIM_HOT_INLINE bool flat_activate(struct lim_paint *paint, const struct lim_spans *spans,
                                         const struct lim_retained *retained, uint16_t polygon, uint16_t y)
{
    struct lim_actives *const actives = &paint->actives;
    struct lim_active **link = &actives->first;

    for (; polygon != LIM_NONE; polygon = retained->cells[polygon].link.next) {
        struct lim_active *active = lim_active_new(actives, spans, y);
        if (!active) return false;
        while (*link && (*link)->polygon > polygon)
            link = &(*link)->next;
        active->next = *link;
        *link = active;
        link = &active->next;
        lim_active_begin(actives, active, retained, polygon, (int16_t)y);
        if (LIM_HAS_TEXTURE) flat_set_texture(paint->pass, retained, active);
    }
    return true;
}

/* How far polygons may reach beyond what is to be painted of a line: not at all, beyond the screen's sides, or
 * anywhere, because its pixels do not begin at 0. */
enum reach { WITHIN, OVERHANGING, ANYWHERE };

/* Pixels of the line that may be painted. */
struct extent {
    int32_t x0, x1;
};

/* By a call where that is rare, or code is to be smallest. Balanced code has one loop for all, so none is rare. */
static LIM_HOT_INLINE void flat_fill(uint16_t *line, int32_t x0, int32_t x1, uint16_t colour, bool rare)
{
    if ((rare && !LIM_OPTIMISE_SIZE) || !LIM_HOT)
        lim_fill(line, (uint16_t)x0, (uint16_t)(x1 - x0), colour);
    else
        lim_fill_inline(line, (int_fast16_t)x0, (int_fast16_t)x1, colour);
}

static LIM_IF_CALLED void flat_fill_textured(const struct lim_pass *pass, struct lim_gradients *gradients,
                                             uint16_t *line, struct extent all, struct extent seen, uint16_t y,
                                             struct lim_stats *stats)
{
    const struct lim_textured_span span = {pass->texturing, gradients, y, all.x0, all.x1};

    lim_texture_fill(&span, line, (uint16_t)seen.x0, (uint16_t)seen.x1, stats);
}

/* What its cuts leave of a run. */
static LIM_IF_CALLED void paint_uncut(struct lim_paint *paint, struct lim_active *active, uint16_t *line,
                                      struct extent all, struct extent within, uint16_t y, struct lim_stats *stats)
{
    const struct lim_near *const near = active->near;
    const int32_t end = near->x1 < within.x1 ? near->x1 : within.x1;

    for (int32_t x = near->x0 > within.x0 ? near->x0 : within.x0, to; lim_crowd_next(near->cuts, NULL, &x, end, &to);
         x = to) {
        if (LIM_HAS_TEXTURE && active->gradients->texture)
            flat_fill_textured(paint->pass, active->gradients, line, all, (struct extent){x, to}, y, stats);
        else
            flat_fill(line, x, to, active->colour, true);
        if (LIM_HAS_STATS) stats->pixels_painted += (uint32_t)(to - x);
    }
}

static LIM_HOT_INLINE void flat_paint_polygons(struct lim_paint *paint, const struct lim_retained *retained,
                                               uint16_t *line, struct extent extent, enum reach reach, uint16_t below,
                                               struct lim_stats *stats)
{
    struct lim_actives *const actives = &paint->actives;
    struct lim_active **link = &actives->first, *active = *link;

    while (active) {
        int32_t x0 = lim_edge_next_x(&active->pair.left), x1 = lim_edge_next_x(&active->pair.right);
        const struct extent all = {x0, x1};
        if (reach == OVERHANGING && x0 < 0) x0 = 0;
        if (reach == ANYWHERE && x0 < extent.x0) x0 = extent.x0;
        if (reach != WITHIN && x1 > extent.x1) x1 = extent.x1;
        if (LIM_HAS_MOVERS && lim_crowd_cuts(actives) && lim_active_is_cut(active)) {
            paint_uncut(paint, active, line, all, extent, (uint16_t)(below - 1), stats);
        } else if (x0 < x1) {
            if (LIM_HAS_TEXTURE && active->gradients->texture)
                flat_fill_textured(paint->pass, active->gradients, line, all, (struct extent){x0, x1},
                                   (uint16_t)(below - 1), stats);
            else
                flat_fill(line, x0, x1, active->colour, reach == ANYWHERE);
            if (LIM_HAS_STATS) stats->pixels_painted += (uint32_t)(x1 - x0);
        }
        if (active->turn == below) {
            if (active->bottom == below) {
                lim_active_give_back(actives, link);
                active = *link;
                continue;
            }
            lim_active_turn(active, &retained->cells[active->polygon], (int16_t)below);
        }
        link = &active->next;
        active = *link;
    }
}

static LIM_HOT_INLINE void flat_paint_background(const struct lim_spans *spans, const struct lim_gap *gap,
                                                 uint16_t *line, uint16_t colour, enum reach reach,
                                                 struct lim_stats *stats)
{
    for (;;) {
        const uint16_t n_px = (uint16_t)(gap->x1 - gap->x0);
        if (n_px) flat_fill(line, gap->x0, gap->x1, colour, reach == ANYWHERE);
        if (LIM_HAS_STATS) stats->pixels_background += n_px;
        if (gap->next == LIM_NONE) return;
        gap = &spans->pool[gap->next];
    }
}

static LIM_HOT_INLINE int flat_paint_line(struct lim_paint *paint, const struct lim_spans *spans,
                                          const struct lim_gap *gap, const struct lim_retained *retained,
                                          struct extent extent, enum reach reach, uint16_t y, struct lim_stats *stats)
{
    const uint16_t below = (uint16_t)(y + 1);
    const struct lim_target *const target = &paint->pass->target;
    uint16_t *const line = target->lend(target->ctx, y);

    if (!line) return LIM_ERR_TARGET;
    lim_actives_count(&paint->actives, spans, stats, y);
    flat_paint_background(spans, gap, line, paint->background, reach, stats);
    flat_paint_polygons(paint, retained, line, extent, reach, below, stats);
    lim_overlay_line(paint->pass, line, y, (uint16_t)extent.x0, (uint16_t)extent.x1);
    return target->done(target->ctx, y, (uint16_t)extent.x0, (uint16_t)(extent.x1 - extent.x0));
}

static LIM_HOT_INLINE int flat_paint_lines(struct lim_paint *paint, struct lim_spans *spans,
                                           const struct lim_retained *retained, const struct lim_rect *band,
                                           enum reach reach, struct lim_paint_stop *stop, struct lim_stats *stats)
{
    const struct lim_line *line = &spans->lines[band->y0], *const end = &spans->lines[band->y1];
    struct extent extent = {reach == ANYWHERE ? band->x0 : 0, band->x1};
    uint16_t at = band->y0;
    int err = 0;

    for (; line != end; line++, at++) {
        if (LIM_HAS_ROUND && reach == ANYWHERE) {
            struct lim_line open;
            lim_line_open(&open, &paint->pass->target, band, at);
            extent = (struct extent){open.gap.x0, open.gap.x1};
        }
        stop->y = at;
        if (!flat_activate(paint, spans, retained, line->retained, at)) return lim_paint_stops(stop, LIM_PAINT_ACTIVE);
        const struct lim_gap within = {(uint16_t)extent.x0, (uint16_t)extent.x1, LIM_NONE};
        if (!lim_crowd_line(paint, spans, retained, &within, at, LIM_CROWD_OVER))
            return lim_paint_stops(stop, LIM_PAINT_ACTIVE);
        err = flat_paint_line(paint, spans, &line->gap, retained, extent, reach, at, stats);
        if (err) break;
    }
    stop->y = at;
    return err;
}

/* Most frames of an object: without a comparison with the extent, whose registers the loop has for itself. What lies
 * within the screen is rounded to its pixels, but for whole ones (perspective.h). */
static LIM_ALONE int paint_within(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                                  const struct lim_rect *band, struct lim_paint_stop *stop, struct lim_stats *stats)
{
    return flat_paint_lines(paint, spans, retained, band, WITHIN, stop, stats);
}

/* Most frames of rooms: the first pixel is compared with 0, which takes no register. */
static LIM_ALONE int paint_overhanging(struct lim_paint *paint, struct lim_spans *spans,
                                       const struct lim_retained *retained, const struct lim_rect *band,
                                       struct lim_paint_stop *stop, struct lim_stats *stats)
{
    return flat_paint_lines(paint, spans, retained, band, OVERHANGING, stop, stats);
}

int lim_flat_band(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                  const struct lim_rect *band, struct lim_paint_stop *stop)
{
    struct lim_stats *stats = lim_stats_of(paint->pass);
    const struct lim_target *target = &paint->pass->target;
    /* Short code has one loop. */
    const bool from_0 = !LIM_OPTIMISE_SIZE && !band->x0 && !lim_target_is_round(target);

    lim_actives_start(&paint->actives, spans, false);
    if (from_0 && LIM_SUB_BITS > 0 && !retained->overhangs && band->x1 == target->w_px)
        return paint_within(paint, spans, retained, band, stop, stats);
    if (from_0) return paint_overhanging(paint, spans, retained, band, stop, stats);
    return flat_paint_lines(paint, spans, retained, band, ANYWHERE, stop, stats);
}

#endif
