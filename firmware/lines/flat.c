/* SPDX-License-Identifier: MIT
 *
 * The polygons that cross a line are kept from far to near, as retain.h lists those that start on it. What is nearer
 * paints over what is farther, so each pixel ends as the nearest polygon's: the picture of pass one. */
#include "lines/active.h"
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
static LIM_INLINE bool flat_activate(struct lim_paint *paint, const struct lim_retained *retained, uint16_t polygon,
                                     uint16_t y)
{
    struct lim_actives *const actives = &paint->actives;
    struct lim_active **link = &actives->first;

    for (; polygon != LIM_NONE; polygon = retained->cells[polygon].link.next) {
        struct lim_active *active = lim_active_new(actives);
        if (!active) return false;
        while (*link && (*link)->polygon > polygon)
            link = &(*link)->next;
        active->next = *link;
        *link = active;
        link = &active->next;
        lim_active_begin(active, retained, polygon, (int16_t)y);
        if (LIM_HAS_TEXTURE) flat_set_texture(paint->pass, retained, active);
    }
    return true;
}

/* Pixels of the line that may be painted. */
struct extent {
    int32_t x0, x1;
};

static LIM_IF_CALLED void flat_fill_textured(const struct lim_pass *pass, struct lim_gradients *gradients,
                                             uint16_t *line, struct extent all, struct extent seen, uint16_t y,
                                             struct lim_stats *stats)
{
    const struct lim_textured_span span = {pass->texturing, gradients, (int16_t)y, (int16_t)all.x0, (int16_t)all.x1};

    lim_texture_fill(&span, line, (uint16_t)seen.x0, (uint16_t)seen.x1, stats);
}

/* With `within`, no polygon reaches beyond the extent. */
static LIM_INLINE void flat_paint_polygons(struct lim_paint *paint, const struct lim_retained *retained, uint16_t *line,
                                           struct extent extent, bool within, uint16_t below, struct lim_stats *stats)
{
    struct lim_actives *const actives = &paint->actives;
    struct lim_active **link = &actives->first, *active;

    while ((active = *link) != NULL) {
        int32_t x0 = lim_edge_next_x(&active->pair.left), x1 = lim_edge_next_x(&active->pair.right);
        const struct extent all = {x0, x1};
        if (!within && x0 < extent.x0) x0 = extent.x0;
        if (!within && x1 > extent.x1) x1 = extent.x1;
        if (x0 < x1) {
            if (LIM_HAS_TEXTURE && active->gradients->texture)
                flat_fill_textured(paint->pass, active->gradients, line, all, (struct extent){x0, x1},
                                   (uint16_t)(below - 1), stats);
            else
                lim_fill_inline(line, (int_fast16_t)x0, (int_fast16_t)x1, active->colour);
            if (LIM_HAS_STATS) stats->pixels_painted += (uint32_t)(x1 - x0);
        }
        if (active->turn == below) {
            if (active->bottom == below) {
                lim_active_give_back(actives, link);
                continue;
            }
            lim_active_turn(active, &retained->cells[active->polygon], (int16_t)below);
        }
        link = &active->next;
    }
}

static LIM_INLINE void flat_paint_background(const struct lim_spans *spans, const struct lim_gap *gap, uint16_t *line,
                                             uint16_t colour, struct lim_stats *stats)
{
    for (;;) {
        const uint16_t n_px = (uint16_t)(gap->x1 - gap->x0);
        if (n_px) lim_fill_inline(line, (int_fast16_t)gap->x0, (int_fast16_t)gap->x1, colour);
        if (LIM_HAS_STATS) stats->pixels_background += n_px;
        if (gap->next == LIM_NONE) return;
        gap = &spans->pool[gap->next];
    }
}

static LIM_INLINE int flat_paint_line(struct lim_paint *paint, struct lim_spans *spans,
                                      const struct lim_retained *retained, const struct lim_rect *band, bool within,
                                      uint16_t y, struct lim_stats *stats)
{
    const uint16_t below = (uint16_t)(y + 1);
    struct extent extent = {band->x0, band->x1};
    uint16_t *const line = paint->pass->target.lend(paint->pass->target.ctx, y);

    if (!line) return LIM_ERR_TARGET;
    if (LIM_HAS_ROUND) {
        struct lim_line open;
        lim_line_open(&open, &paint->pass->target, band, y);
        extent = (struct extent){open.gap.x0, open.gap.x1};
    }
    if (LIM_HAS_STATS && paint->actives.used > stats->active_max) stats->active_max = paint->actives.used;
    flat_paint_background(spans, &spans->lines[y].gap, line, paint->background, stats);
    flat_paint_polygons(paint, retained, line, extent, within, below, stats);
    lim_overlay_line(paint->pass, line, y, (uint16_t)extent.x0, (uint16_t)extent.x1);
    return paint->pass->target.done(paint->pass->target.ctx, y, (uint16_t)extent.x0, (uint16_t)(extent.x1 - extent.x0));
}

/* Whether the band shows each line from side to side, and no polygon reaches beyond it. What lies within the screen is
 * rounded to its pixels, but for whole ones (perspective.h). */
static bool flat_is_within(const struct lim_paint *paint, const struct lim_retained *retained,
                           const struct lim_rect *band)
{
    const struct lim_target *target = &paint->pass->target;

    return LIM_SUB_BITS && !lim_target_is_round(target) && !retained->overhangs && !band->x0 &&
           band->x1 == target->w_px;
}

static LIM_INLINE int flat_paint_lines(struct lim_paint *paint, struct lim_spans *spans,
                                       const struct lim_retained *retained, const struct lim_rect *band, bool within,
                                       uint16_t *y, struct lim_stats *stats)
{
    for (*y = band->y0; *y < band->y1; ++*y) {
        if (!flat_activate(paint, retained, spans->lines[*y].retained, *y)) return LIM_PAINT_ACTIVE;
        const int err = flat_paint_line(paint, spans, retained, band, within, *y, stats);
        if (err) return err;
    }
    return 0;
}

/* Most frames: without a comparison with the extent, whose two registers the loop has for itself. */
static LIM_ALONE int paint_within(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                                  const struct lim_rect *band, uint16_t *y, struct lim_stats *stats)
{
    return flat_paint_lines(paint, spans, retained, band, true, y, stats);
}

int lim_flat_band(struct lim_paint *paint, struct lim_spans *spans, const struct lim_retained *retained,
                  const struct lim_rect *band, uint16_t *y)
{
    struct lim_stats *stats = lim_stats_of(paint->pass);

    lim_actives_start(&paint->actives);
    if (!LIM_OPTIMISE_SIZE && flat_is_within(paint, retained, band))
        return paint_within(paint, spans, retained, band, y, stats);
    return flat_paint_lines(paint, spans, retained, band, false, y, stats);
}

#endif
