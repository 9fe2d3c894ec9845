/* SPDX-License-Identifier: MIT
 *
 * Pixel by pixel: there are no gaps, but a word a pixel that says which of its samples are closed. */
#include "lines/smooth_line.h"

#include "lines/overlaid.h"
#include "lines/paint.h"
#include "lines/smooth.h"
#include "pixels/texture.h"
#include "screen/polygon.h"
#include "view/pass.h"

#if LIM_HAS_ANTIALIAS

int lim_smooth_begin_line(struct lim_paint *paint, uint16_t y)
{
    const struct lim_target *target = &paint->pass->target;
    struct lim_smooth *smooth = paint->smooth;

    smooth->line = lim_paint_lend(paint, y);
    if (!smooth->line) return LIM_ERR_TARGET;
    for (uint16_t x = 0; x < target->w_px; x++)
        smooth->covered[x] = 0;
    smooth->open_px = target->w_px;
    return LIM_OK;
}

static struct lim_smooth_sink sink_of(const struct lim_paint *paint)
{
    struct lim_smooth_sink sink = {.line = paint->smooth->line, .sums = paint->smooth->sums};

    if (LIM_HAS_TEXTURE) *sink.stats = lim_stats_of(paint->pass);
    return sink;
}

/* A textured pixel's colour comes by way of the line, as in smooth.c. */
static void add_samples(struct lim_smooth *smooth, struct lim_spans *spans, struct lim_smooth_sink *sink, uint16_t x,
                        uint16_t mask)
{
    const uint16_t covered = smooth->covered[x], fresh = (uint16_t)(mask & ~covered);

    if (!fresh) return;
    if (LIM_HAS_TEXTURE && sink->span->gradients) {
        lim_texture_fill(sink->span, sink->line, x, (uint16_t)(x + 1), *sink->stats);
        sink->share = lim_smooth_share(sink->line[x]);
    }
    lim_smooth_mix_pixel(sink, x, lim_sample_count(fresh));
    smooth->covered[x] = covered | mask;
    if (smooth->covered[x] == LIM_ALL_SAMPLES && !--smooth->open_px) spans->open_lines = 0;
}

/* A strip's samples of a pixel: bit 4 * row + sample. */
static uint16_t mask_of(const struct lim_strip *strip, int16_t x)
{
    uint16_t mask = 0;

    for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
        const int16_t left = lim_bound_sample(&strip->left, s), right = lim_bound_sample(&strip->right, s);
        for (uint_fast8_t k = 0; k < LIM_SAMPLES_A_ROW; k++) {
            const int16_t v = (int16_t)(LIM_SAMPLES_A_ROW * x + (int16_t)k);
            if (v >= left && v < right) mask |= (uint16_t)(1u << (LIM_SAMPLES_A_ROW * s + k));
        }
    }
    return mask;
}

static LIM_IF_CALLED void set_textured(struct lim_smooth_sink *sink, const struct lim_paint *paint,
                                       const struct lim_screen_polygon *polygon, struct lim_gradients *gradients,
                                       uint16_t y, const struct lim_strip *strip)
{
    *sink->span =
        (struct lim_textured_span){paint->pass->texturing, NULL, y, lim_strip_first_px(strip), lim_strip_end_px(strip)};
    if (lim_screen_texture(polygon) == LIM_NONE) return;
    lim_texture_set(paint->pass->texturing, lim_screen_texture(polygon), polygon->at, polygon->n, gradients);
    sink->span->gradients = gradients;
}

void lim_smooth_add(struct lim_paint *paint, struct lim_spans *spans, const struct lim_strip *strip,
                    const struct lim_screen_polygon *polygon)
{
    const int16_t w_px = (int16_t)paint->pass->target.w_px;
    int16_t x = lim_strip_first_px(strip), end = lim_strip_end_px(strip);
    struct lim_smooth_sink sink = sink_of(paint);
    struct lim_gradients gradients;

    sink.share = lim_smooth_share(polygon->colour);
    if (LIM_HAS_TEXTURE) set_textured(&sink, paint, polygon, &gradients, spans->open.y0, strip);
    if (end > w_px) end = w_px;
    for (x = x > 0 ? x : 0; x < end; x++)
        add_samples(paint->smooth, spans, &sink, (uint16_t)x, mask_of(strip, x));
    if (LIM_HAS_STATS) lim_stats_of(paint->pass)->pixels_painted += sink.painted_px;
}

uint16_t lim_smooth_see_pixel(const struct lim_paint *paint, const struct lim_screen_polygon *polygon, uint16_t x,
                              uint16_t y, struct lim_strip *strip)
{
    struct lim_sample_edges edges;

    lim_strip_begin(&edges, polygon->n, polygon->shape.first);
    lim_strip_any(strip, &edges, polygon->at, polygon->n, polygon->shape.first, (int16_t)y, *polygon->shape.end_row);
    return (uint16_t)(mask_of(strip, (int16_t)x) & ~paint->smooth->covered[x]);
}

uint32_t lim_smooth_share_there(const struct lim_paint *paint, const struct lim_screen_polygon *polygon, uint16_t x,
                                uint16_t y, const struct lim_strip *strip)
{
    struct lim_smooth_sink sink = sink_of(paint);
    struct lim_gradients gradients;

    if (!LIM_HAS_TEXTURE || lim_screen_texture(polygon) == LIM_NONE) return lim_smooth_share(polygon->colour);
    set_textured(&sink, paint, polygon, &gradients, y, strip);
    lim_texture_fill(sink.span, sink.line, x, (uint16_t)(x + 1), *sink.stats);
    return lim_smooth_share(sink.line[x]);
}

void lim_smooth_add_to_pixel(struct lim_paint *paint, struct lim_spans *spans, uint16_t x, uint16_t samples,
                             uint32_t share)
{
    struct lim_smooth_sink sink = sink_of(paint);

    sink.share = share;
    if (LIM_HAS_TEXTURE) sink.span->gradients = NULL;
    add_samples(paint->smooth, spans, &sink, x, samples);
    if (LIM_HAS_STATS) lim_stats_of(paint->pass)->pixels_painted += sink.painted_px;
}

void lim_smooth_add_polygon(struct lim_paint *paint, struct lim_spans *spans, const struct lim_screen_polygon *polygon)
{
    struct lim_sample_edges edges;
    struct lim_strip strip;

    lim_strip_begin(&edges, polygon->n, polygon->shape.first);
    lim_strip_any(&strip, &edges, polygon->at, polygon->n, polygon->shape.first, (int16_t)spans->open.y0,
                  *polygon->shape.end_row);
    lim_smooth_add(paint, spans, &strip, polygon);
}

static int end_pixels(struct lim_paint *paint, struct lim_spans *spans, uint16_t y, uint16_t x0, uint16_t x1)
{
    const struct lim_target *target = &paint->pass->target;
    struct lim_smooth_sink sink = sink_of(paint);

    sink.share = lim_smooth_share(paint->background);
    if (LIM_HAS_TEXTURE) sink.span->gradients = NULL;
    for (uint16_t x = x0; x < x1; x++)
        add_samples(paint->smooth, spans, &sink, x, LIM_ALL_SAMPLES);
    if (LIM_HAS_STATS) lim_stats_of(paint->pass)->pixels_background += sink.painted_px;
    lim_overlay_line(paint->pass, paint->smooth->line, y, x0, x1);
    paint->smooth->line = NULL;
    return target->done(target->ctx, y, x0, (uint16_t)(x1 - x0));
}

int lim_smooth_end_pixel(struct lim_paint *paint, struct lim_spans *spans, uint16_t x, uint16_t y)
{
    return end_pixels(paint, spans, y, x, (uint16_t)(x + 1));
}

int lim_smooth_end_line(struct lim_paint *paint, struct lim_spans *spans, uint16_t y)
{
    return end_pixels(paint, spans, y, 0, paint->pass->target.w_px);
}

#endif
