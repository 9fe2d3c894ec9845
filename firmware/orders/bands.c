/* SPDX-License-Identifier: MIT
 *
 * A frame, nearest first: pass one (nearest.c) over all lines, then pass two (paint.c). When a pool is exhausted the
 * frame is finished in bands: the same two passes over half the lines, a quarter, one line, half a line, and more again
 * where there is room. A band of one pixel needs one polygon and no gap, so every frame ends. */
#include "orders/nearest.h"

#include "lines/framebuffer.h"
#include "lines/gaps.h"
#include "lines/overlaid.h"
#include "lines/paint.h"
#include "lines/share.h"
#include "lines/smooth_line.h"
#include "movers/mover.h"
#include "orders/room.h"
#include "pieces/sorted.h"
#include "view/view.h"

#if LIM_HAS_SPANS

/* Of a frame: the next band, and how large those are that follow. */
struct bands {
    struct lim_rect band;
    uint16_t w_px, h_px; /* less than the screen's width: one line */
    bool grows;          /* the last band was painted, too */
};

static void bands_begin(struct bands *bands, const struct lim_target *target)
{
    bands->w_px = target->w_px;
    bands->h_px = target->h_px;
    bands->band = (struct lim_rect){0, 0, target->w_px, target->h_px};
    bands->grows = false;
}

/* A smaller band that starts where this one does. What PAINT has left of a band may be a single
 * pixel, which is smaller already. */
static void halve(struct bands *bands)
{
    struct lim_rect *band = &bands->band;
    uint16_t h_px = (uint16_t)(band->y1 - band->y0), w_px = (uint16_t)(band->x1 - band->x0);

    if (h_px > 1)
        h_px /= 2;
    else if (w_px > 1)
        w_px /= 2;
    bands->w_px = w_px;
    bands->h_px = h_px;
    band->x1 = (uint16_t)(band->x0 + w_px);
    band->y1 = (uint16_t)(band->y0 + h_px);
    bands->grows = false;
}

/* The band that follows: to the right, or below. What crowds a frame is mostly in a part of it, so when two in a row
 * were painted those that follow are twice as large. */
static void follow(struct bands *bands, const struct lim_target *target)
{
    struct lim_rect *band = &bands->band;

    if (bands->grows) {
        uint16_t *size = bands->w_px < target->w_px ? &bands->w_px : &bands->h_px;
        *size = (uint16_t)(2 * *size);
    }
    bands->grows = !bands->grows;
    band->x0 = band->x1;
    if (band->x0 >= target->w_px) {
        band->x0 = 0;
        band->y0 = band->y1;
    }
    band->x1 = (uint16_t)(target->w_px - band->x0 < bands->w_px ? target->w_px : band->x0 + bands->w_px);
    band->y1 = (uint16_t)(target->h_px - band->y0 < bands->h_px ? target->h_px : band->y0 + bands->h_px);
}

/* Whether the cache of vertices was overwritten. */
static bool took_idle_memory(struct lim_nearest *nearest)
{
    bool took = nearest->paint.actives.in_pool || (LIM_HAS_MOVERS && *nearest->paint.actives.crowded);

    if (LIM_HAS_TRANSPARENT) {
        took = took || nearest->paint.layers->in_idle;
        nearest->paint.layers->in_idle = false;
    }
    return took;
}

/* Where a pool is exhausted stop->y is the first line that is not yet painted. */
static int paint_band(struct lim_nearest *nearest, const struct lim_rect *band, bool is_collected,
                      struct lim_paint_stop *stop)
{
    *stop = (struct lim_paint_stop){band->y0, (uint_fast8_t)(is_collected ? LIM_PAINT_FITS : LIM_PAINT_ACTIVE)};
    if (!is_collected) return 0;
    const int err = lim_paint_band(&nearest->paint, &nearest->spans, &nearest->retained, band, stop);
    if (took_idle_memory(nearest)) lim_view_forget(&nearest->pass->view);
    return err;
}

/* How far the stack must reach, and how many polygons wait at one pixel, is not bounded where some are transparent; and
 * wireframe retains more of a polygon than the least pool was made for. The painter's order needs no pool at all: a
 * line for which any is too small is painted so. */
static bool wants_painter(const struct lim_nearest *nearest, const struct lim_rect *band, enum lim_paint_pool exhausted)
{
    if (LIM_HAS_MOVERS && lim_nearest_moves(nearest)) return false;
    if (!nearest->pass->scene->limits.layers && !lim_wireframe_of(nearest->pass)) return false;
    return exhausted == LIM_PAINT_LAYERS || band->y1 - band->y0 == 1;
}

void lim_nearest_set_antialiased(struct lim_nearest *nearest, bool antialiased)
{
    lim_view_set_antialiased(&nearest->pass->view, antialiased);
    if (LIM_HAS_MOVERS) lim_movers_set_antialiased(*nearest->movers, antialiased);
}

/* One line, from a walk of its own: it needs no pool. */
static LIM_IF_CALLED int draw_line_alone(struct lim_nearest *nearest, const struct lim_rect *band)
{
    const int err = lim_smooth_begin_line(&nearest->paint, band->y0);

    if (err) return err;
    (void)lim_collect(nearest, band);
    return lim_smooth_end_line(&nearest->paint, &nearest->spans, band->y0);
}

/* The band's first line; what is left of the band comes next. */
static LIM_IF_CALLED int paint_first_line(struct lim_nearest *nearest, struct bands *bands)
{
    struct lim_rect *band = &bands->band;
    const bool antialiased = lim_is_antialiased(&nearest->pass->view);

    if (LIM_HAS_ANTIALIAS) lim_nearest_set_antialiased(nearest, false);
    const int err = lim_painter_line(*nearest->painter, *nearest->paint.lent, band->y0);
    if (LIM_HAS_ANTIALIAS) lim_nearest_set_antialiased(nearest, antialiased);
    *nearest->paint.lent = NULL;
    if (band->y1 - band->y0 > 1)
        band->y0++;
    else
        follow(bands, &nearest->pass->target);
    return err;
}

static struct lim_rect whole_frame(const struct lim_nearest *nearest)
{
    return (struct lim_rect){0, 0, nearest->pass->target.w_px, nearest->pass->target.h_px};
}

static void count_band(struct lim_nearest *nearest)
{
    nearest->bands++;
    if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->bands = nearest->bands;
}

/* Pass one has left the band's lower lines to the next one. */
static void shorten(struct lim_nearest *nearest, struct bands *bands)
{
    bands->band.y1 = nearest->bottom;
    count_band(nearest);
}

static bool wants_fill(const struct lim_nearest *nearest)
{
    const struct lim_target *target = &nearest->pass->target;

    return LIM_HAS_FILLED && lim_fill_of(target) && target->method == LIM_NEAREST_FIRST &&
           lim_nearest_can_fill(nearest);
}

static void fill_background(struct lim_nearest *nearest)
{
    const struct lim_rect *open = &nearest->spans.open;
    lim_piece_fill *const fill = lim_fill_of(&nearest->pass->target);
    struct lim_piece_look look = {.ctx = lim_fill_ctx_of(&nearest->pass->target),
                                  .colour = lim_background_of(nearest->pass)};

    if (!nearest->spans.open_lines) return;
    for (look.y_px = open->y0; look.y_px < open->y1; look.y_px++) {
        const struct lim_gap *gap = &nearest->spans.lines[look.y_px].gap;
        for (; gap; gap = lim_gap_after(&nearest->spans, gap))
            if (gap->x0 < gap->x1) fill(&look, gap->x0, gap->x1);
    }
}

/* A framebuffer's lines are done as lines that were lent are. */
static int show(const struct lim_nearest *nearest)
{
    const struct lim_rect frame = whole_frame(nearest);

    lim_overlay_picture(nearest->pass);
    if (lim_has_framebuffer(&nearest->pass->target)) return lim_target_done(&nearest->pass->target, &frame);
    return lim_target_show(&nearest->pass->target);
}

/* Polygons straight into the frame that the target keeps: pass one alone. What was painted of a band for which there
 * are not gaps enough is painted again. */
static int fill_frame(struct lim_nearest *nearest)
{
    struct bands bands;

    bands_begin(&bands, &nearest->pass->target);
    while (bands.band.y0 < nearest->pass->target.h_px) {
        nearest->fills = true;
        const bool whole = lim_collect(nearest, &bands.band);
        nearest->fills = false;
        if (whole) {
            fill_background(nearest);
            follow(&bands, &nearest->pass->target);
        } else {
            count_band(nearest);
            halve(&bands);
        }
    }
    return show(nearest);
}

/* By scan lines a line's gaps are not known before it is painted. */
static LIM_IF_CALLED uint16_t cells_before_kept(const struct lim_spans *spans)
{
    const uint32_t gaps = (uint32_t)(*spans->strips_size - *spans->kept);

    return (uint16_t)(gaps * lim_share_gap_b(spans, true) / lim_share_cell_b(spans));
}

static void begin_frame(struct lim_nearest *nearest)
{
    nearest->paint.background = lim_background_of(nearest->pass);
    nearest->retained.end = nearest->retained.whole;
    if (LIM_HAS_ANTIALIAS) {
        const bool antialiased = lim_wants_antialias(nearest);
        lim_nearest_set_antialiased(nearest, antialiased);
        *nearest->spans.kept = antialiased && LIM_IS_SCANLINE(&nearest->pass->target) ? *nearest->line_gaps : 0;
        if (*nearest->spans.kept) nearest->retained.end = cells_before_kept(&nearest->spans);
    }
    if (LIM_IS_SORTED(&nearest->pass->target)) lim_sorted_order(lim_nearest_sorter(nearest));
}

/* For what of a band could not be painted, from line band->y0 on, a pool is too small. */
static int paint_less(struct lim_nearest *nearest, struct bands *bands, enum lim_paint_pool exhausted)
{
    const struct lim_rect *band = &bands->band;

    count_band(nearest);
    if (LIM_HAS_MOVERS && lim_nearest_moves(nearest) && band->y1 - band->y0 == 1 && band->x1 - band->x0 == 1) {
        const int err = lim_draw_pixel(nearest, band);
        if (!err) follow(bands, &nearest->pass->target);
        return err;
    }
    if (LIM_HAS_FALLBACK && wants_painter(nearest, band, exhausted)) return paint_first_line(nearest, bands);
    if (!LIM_HAS_ANTIALIAS || !lim_is_antialiased(&nearest->pass->view) || band->y1 - band->y0 > 1 ||
        lim_nearest_moves(nearest)) {
        halve(bands);
        return 0;
    }
    const int err = draw_line_alone(nearest, band);
    if (!err) follow(bands, &nearest->pass->target);
    return err;
}

int lim_nearest_frame(struct lim_nearest *nearest, enum lim_ahead_stage stage)
{
    const struct lim_rect frame = whole_frame(nearest);
    bool is_collected = stage == LIM_AHEAD_DONE;
    struct bands bands;

    if (stage == LIM_AHEAD_BEGUN) {
        begin_frame(nearest);
        if (LIM_HAS_FILLED && wants_fill(nearest)) return fill_frame(nearest);
        is_collected = lim_collect(nearest, &frame);
    }
    bands_begin(&bands, &nearest->pass->target);
    for (;;) {
        struct lim_paint_stop stop;
        if (is_collected && bands.band.y1 > nearest->bottom) shorten(nearest, &bands);
        int err = paint_band(nearest, &bands.band, is_collected, &stop);
        if (stop.exhausted) {
            bands.band.y0 = stop.y;
            if (LIM_HAS_SCANLINE && nearest->retains_all && is_collected && stop.exhausted == LIM_PAINT_ACTIVE &&
                lim_room_keep(nearest))
                count_band(nearest);
            else
                err = paint_less(nearest, &bands, (enum lim_paint_pool)stop.exhausted);
        } else {
            follow(&bands, &nearest->pass->target);
        }
        if (err || bands.band.y0 >= nearest->pass->target.h_px) return err;
        is_collected = lim_collect(nearest, &bands.band);
    }
}

/* A target that keeps the picture is filled by pass one. */
static bool begin_ahead(struct lim_nearest *nearest, enum lim_ahead_stage *stage)
{
    const struct lim_rect frame = whole_frame(nearest);

    if (LIM_HAS_FILLED && wants_fill(nearest)) return false;
    begin_frame(nearest);
    lim_collect_begin(nearest, &frame);
    *stage = LIM_AHEAD_BUSY;
    return true;
}

bool lim_nearest_work(struct lim_nearest *nearest, enum lim_ahead_stage *stage)
{
    if (*stage == LIM_AHEAD_BEGUN) return begin_ahead(nearest, stage);
    if (*stage == LIM_AHEAD_BUSY) *stage = lim_collect_some(nearest);
    return *stage == LIM_AHEAD_BUSY;
}

int lim_nearest_paint(struct lim_nearest *nearest, enum lim_ahead_stage *stage)
{
    while (*stage == LIM_AHEAD_BUSY)
        *stage = lim_collect_some(nearest);
    return lim_nearest_frame(nearest, *stage);
}

#endif
