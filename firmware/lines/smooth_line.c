/* SPDX-License-Identifier: MIT
 *
 * Pixel by pixel: there are no gaps, but a word a pixel that says which of its samples are closed. */
#include "lines/smooth_line.h"

#include "lines/overlaid.h"
#include "lines/smooth.h"
#include "pixels/texture.h"
#include "screen/polygon.h"
#include "screen/samples.h"
#include "view/pass.h"

#if LIM_HAS_ANTIALIAS

int lim_smooth_begin_line(struct lim_paint *paint, uint16_t y)
{
    const struct lim_target *target = &paint->pass->target;
    struct lim_smooth *smooth = paint->smooth;

    smooth->line = target->lend(target->ctx, y);
    if (!smooth->line) return LIM_ERR_TARGET;
    for (uint16_t x = 0; x < target->w_px; x++)
        smooth->covered[x] = 0;
    smooth->open_px = target->w_px;
    return LIM_OK;
}

static struct lim_smooth_sink sink_of(const struct lim_paint *paint)
{
    return (struct lim_smooth_sink){
        .line = paint->smooth->line, .sums = paint->smooth->sums, .stats = lim_stats_of(paint->pass)};
}

/* Pixel by pixel: there are no gaps. */
static void add_samples(struct lim_smooth *smooth, struct lim_spans *spans, struct lim_smooth_sink *sink, int16_t x,
                        uint16_t mask)
{
    const uint16_t covered = smooth->covered[x];
    const struct lim_run run = {x, (int16_t)(x + 1), (uint16_t)(mask & ~covered)};

    if (!run.mask) return;
    lim_smooth_mix(sink, &run, covered);
    smooth->covered[x] = covered | mask;
    if (smooth->covered[x] == LIM_ALL_SAMPLES && !--smooth->open_px) spans->open_lines = 0;
}

void lim_smooth_add(struct lim_paint *paint, struct lim_spans *spans, const struct lim_strip *strip,
                    const struct lim_screen_polygon *polygon)
{
    const int16_t w_px = (int16_t)paint->pass->target.w_px, end = strip->x1 < w_px ? strip->x1 : w_px;
    struct lim_smooth_sink sink = sink_of(paint);
    struct lim_gradients gradients;

    sink.colour = polygon->colour;
    if (LIM_HAS_TEXTURE) {
        *sink.span =
            (struct lim_textured_span){paint->pass->texturing, NULL, (int16_t)spans->open.y0, strip->x0, strip->x1};
        if (lim_screen_texture(polygon) != LIM_NONE) {
            lim_texture_set(paint->pass->texturing, lim_screen_texture(polygon), polygon->at, polygon->n, &gradients);
            sink.span->gradients = &gradients;
        }
    }
    for (int16_t x = strip->x0 > 0 ? strip->x0 : 0; x < end;) {
        struct lim_run run;
        lim_strip_run(strip, x, &run);
        for (; x < run.x1 && x < end; x++)
            add_samples(paint->smooth, spans, &sink, x, run.mask);
    }
    if (LIM_HAS_STATS) sink.stats->pixels_painted += sink.painted_px;
}

void lim_smooth_add_polygon(struct lim_paint *paint, struct lim_spans *spans, const struct lim_screen_polygon *polygon)
{
    struct lim_sample_edges edges;
    struct lim_strip strip;

    lim_strip_begin(&edges, polygon->n, polygon->shape.first);
    lim_strip_next(&strip, &edges, polygon->at, polygon->n, polygon->shape.first, (int16_t)spans->open.y0,
                   *polygon->shape.end_row);
    lim_smooth_add(paint, spans, &strip, polygon);
}

int lim_smooth_end_line(struct lim_paint *paint, struct lim_spans *spans, uint16_t y)
{
    const struct lim_target *target = &paint->pass->target;
    struct lim_smooth_sink sink = sink_of(paint);

    sink.colour = paint->background;
    for (uint16_t x = 0; x < target->w_px; x++)
        add_samples(paint->smooth, spans, &sink, (int16_t)x, LIM_ALL_SAMPLES);
    if (LIM_HAS_STATS) sink.stats->pixels_background += sink.painted_px;
    lim_overlay_line(paint->pass, paint->smooth->line, y, 0, target->w_px);
    paint->smooth->line = NULL;
    return target->done(target->ctx, y, 0, target->w_px);
}

#endif
