/* SPDX-License-Identifier: MIT
 *
 * A frame, nearest first: pass one (nearest.c) over all lines, then pass two (paint.c). When a pool is exhausted the
 * frame is finished in bands: the same two passes over half the lines, a quarter, one line, half a line, and more again
 * where there is room. A band of one pixel needs one polygon and no gap, so every frame ends. */
#include "orders/order.h"

#include "lines/framebuffer.h"
#include "lines/gaps.h"

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
    const uint16_t lines = (uint16_t)(band->y1 - band->y0), pixels = (uint16_t)(band->x1 - band->x0);

    bands->w_px = pixels;
    bands->h_px = lines;
    if (lines > 1)
        bands->h_px /= 2;
    else if (pixels > 1)
        bands->w_px /= 2;
    band->x1 = (uint16_t)(band->x0 + bands->w_px);
    band->y1 = (uint16_t)(band->y0 + bands->h_px);
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

/* Positive: a pool is exhausted (LIM_PAINT_...), and *y is the first line that is not yet painted. */
static int paint_band(struct lim *lim, const struct lim_rect *band, bool is_collected, uint16_t *y)
{
    *y = band->y0;
    if (!is_collected) return LIM_PAINT_ACTIVE;
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

/* One line, from a walk of its own: it needs no pool. */
static inline int draw_line_alone(struct lim *lim, const struct lim_rect *band)
{
#if LIM_HAS_ANTIALIAS
    const int err = lim_smooth_begin_line(lim, band->y0);

    if (err) return err;
    (void)lim_collect(lim, band);
    return lim_smooth_end_line(lim, band->y0);
#else
    (void)lim, (void)band;
    return 0;
#endif
}

/* The band's first line; what is left of the band comes next. */
static int paint_first_line(struct lim *lim, struct bands *bands)
{
    struct lim_rect *band = &bands->band;
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
        follow(bands, &lim->target);
    return err;
}

static struct lim_rect whole_frame(const struct lim *lim)
{
    return (struct lim_rect){0, 0, lim->target.w_px, lim->target.h_px};
}

static void count_band(struct lim *lim)
{
    lim->bands++;
    if (LIM_HAS_STATS) lim_stats_of(lim)->bands = lim->bands;
}

#if LIM_HAS_FILLED
static bool wants_fill(const struct lim *lim)
{
    return lim_fill_of(&lim->target) && lim->target.method == LIM_NEAREST_FIRST && lim_can_fill(lim);
}

static void fill_background(struct lim *lim)
{
    const struct lim_rect *open = &lim->spans.open;
    lim_span_sink *const fill = lim_fill_of(&lim->target);
    struct lim_piece_look look = {.ctx = lim_fill_ctx_of(&lim->target), .colour = lim_background_of(lim)};

    if (!lim->spans.open_lines) return;
    for (look.y_px = open->y0; look.y_px < open->y1; look.y_px++) {
        const struct lim_gap *gap = &lim->spans.lines[look.y_px].gap;
        for (; gap; gap = lim_gap_after(&lim->spans, gap))
            if (gap->x0 < gap->x1) fill(&look, gap->x0, gap->x1);
    }
}

/* A framebuffer's lines are done as lines that were lent are. */
static int show(const struct lim *lim)
{
    const struct lim_rect frame = whole_frame(lim);

    if (lim_has_framebuffer(&lim->target)) return lim_target_done(&lim->target, &frame);
#if LIM_HAS_FRAME
    return lim->target.show(lim->target.ctx);
#else
    return LIM_ERR_TARGET;
#endif
}

/* Polygons straight into the frame that the target keeps: pass one alone. What was painted of a band for which there
 * are not gaps enough is painted again. */
static int fill_frame(struct lim *lim)
{
    struct bands bands;

    bands_begin(&bands, &lim->target);
    while (bands.band.y0 < lim->target.h_px) {
        lim->fills = true;
        const bool whole = lim_collect(lim, &bands.band);
        lim->fills = false;
        if (whole) {
            fill_background(lim);
            follow(&bands, &lim->target);
        } else {
            count_band(lim);
            halve(&bands);
        }
    }
    return show(lim);
}
#endif

static void begin_frame(struct lim *lim)
{
    if (LIM_HAS_ANTIALIAS) set_antialiased(lim, lim_wants_antialias(lim));
    if (LIM_IS_SORTED(&lim->target)) lim_sorted_order(lim);
}

/* For what of a band could not be painted, from line band->y0 on, a pool is too small. */
static int paint_less(struct lim *lim, struct bands *bands, int exhausted)
{
    const struct lim_rect *band = &bands->band;

    count_band(lim);
    if (wants_painter(lim, band, exhausted)) return paint_first_line(lim, bands);
    if (!LIM_HAS_ANTIALIAS || !lim_is_antialiased(&lim->view) || band->y1 - band->y0 > 1) {
        halve(bands);
        return 0;
    }
    const int err = draw_line_alone(lim, band);
    if (!err) follow(bands, &lim->target);
    return err;
}

/* From pass one over all lines to the frame's last line. */
static int finish_frame(struct lim *lim, bool is_collected)
{
    struct bands bands;

    bands_begin(&bands, &lim->target);
    for (;;) {
        uint16_t y;
        int err = paint_band(lim, &bands.band, is_collected, &y);
        if (err > 0) {
            bands.band.y0 = y;
            err = paint_less(lim, &bands, err);
        } else {
            follow(&bands, &lim->target);
        }
        if (err || bands.band.y0 >= lim->target.h_px) return err;
        is_collected = lim_collect(lim, &bands.band);
    }
}

int lim_nearest_frame(struct lim *lim)
{
    const struct lim_rect frame = whole_frame(lim);

    begin_frame(lim);
#if LIM_HAS_FILLED
    if (wants_fill(lim)) return fill_frame(lim);
#endif
    return finish_frame(lim, lim_collect(lim, &frame));
}

#if LIM_HAS_STREAM
/* A target that keeps the picture is filled by pass one. */
static bool begin_ahead(struct lim *lim)
{
    const struct lim_rect frame = whole_frame(lim);

#if LIM_HAS_FILLED
    if (wants_fill(lim)) return false;
#endif
    begin_frame(lim);
    lim_collect_begin(lim, &frame);
    lim->ahead.stage = LIM_AHEAD_BUSY;
    return true;
}

bool lim_nearest_work(struct lim *lim)
{
    if (lim->ahead.stage == LIM_AHEAD_BEGUN) return begin_ahead(lim);
    if (lim->ahead.stage == LIM_AHEAD_BUSY) lim->ahead.stage = lim_collect_some(lim);
    return lim->ahead.stage == LIM_AHEAD_BUSY;
}

int lim_nearest_paint(struct lim *lim)
{
    if (lim->ahead.stage == LIM_AHEAD_BEGUN) return lim_nearest_frame(lim);
    while (lim_nearest_work(lim))
        ;
    return finish_frame(lim, lim->ahead.stage == LIM_AHEAD_DONE);
}
#endif

#endif
