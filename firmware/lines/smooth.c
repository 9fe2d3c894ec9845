/* SPDX-License-Identifier: MIT
 *
 * Sums are of 16 samples, so a channel needs four bits more than it has: all three fit 32 bits, and are added and
 * rounded together. Colours are mixed as they are blended (blend.h), in the panel's values. */
#include "lines/smooth.h"

#include "lines/paint.h"
#include "pixels/fill.h"

#if LIM_HAS_ANTIALIAS

static const uint32_t HALVES = UINT32_C(8) << 20 | UINT32_C(8) << 10 | 8;

static inline uint32_t spread(uint16_t colour)
{
    const uint32_t rgb565 = lim_memory_colour(colour);

    return (rgb565 & 0xF800) << 9 | (rgb565 & 0x07E0) << 5 | (rgb565 & 0x1F);
}

/* A sixteenth of a sum, rounded. */
static inline uint16_t smooth_colour_of(uint32_t sum)
{
    const uint32_t sixteenfold = sum + HALVES;

    return lim_memory_colour(
        (uint16_t)((sixteenfold >> 13 & 0xF800) | (sixteenfold >> 9 & 0x07E0) | (sixteenfold >> 4 & 0x1F)));
}

/* false: it is of one colour. */
static inline bool smooth_paint_textured(const struct lim_smooth_sink *sink, const struct lim_run *run)
{
    if (!LIM_HAS_TEXTURE || !sink->span->gradients) return false;
    lim_texture_fill(sink->span, sink->line, (uint16_t)run->x0, (uint16_t)run->x1, sink->stats);
    return true;
}

/* A texture's colours come by way of the line, whose pixels mean nothing yet while they are open. */
static void mix_run(struct lim_smooth_sink *sink, const struct lim_run *run, uint16_t covered)
{
    const uint32_t count = lim_sample_count(run->mask);
    const bool closes = (covered | run->mask) == LIM_ALL_SAMPLES, textured = smooth_paint_textured(sink, run);
    uint32_t share = spread(sink->colour) * count;

    for (int16_t x = run->x0; x < run->x1; x++) {
        if (LIM_HAS_TEXTURE && textured) share = spread(sink->line[x]) * count;
        const uint32_t sum = covered ? sink->sums[x] + share : share;
        if (closes)
            sink->line[x] = smooth_colour_of(sum);
        else
            sink->sums[x] = sum;
    }
    if (LIM_HAS_STATS && closes) sink->painted_px = (uint16_t)(sink->painted_px + (uint16_t)(run->x1 - run->x0));
}

void lim_smooth_mix(void *ctx, const struct lim_run *run, uint16_t covered)
{
    struct lim_smooth_sink *sink = ctx;

    if (run->mask != LIM_ALL_SAMPLES) {
        mix_run(sink, run, covered);
        return;
    }
    if (!smooth_paint_textured(sink, run))
        lim_fill(sink->line, (uint16_t)run->x0, (uint16_t)(run->x1 - run->x0), sink->colour);
    if (LIM_HAS_STATS) sink->painted_px = (uint16_t)(sink->painted_px + (uint16_t)(run->x1 - run->x0));
}

enum lim_span_result lim_smooth_close(struct lim_spans *spans, const struct lim_screen_polygon *polygon, int16_t top,
                                      int16_t bottom)
{
    const bool transparent = LIM_HAS_TRANSPARENT && lim_alpha_of(polygon) != LIM_OPAQUE;
    struct lim_sample_edges edges;
    struct lim_strip strip;
    uint8_t result = LIM_SPAN_NOTHING;

    lim_strip_begin(&edges, polygon->n, polygon->shape.first);
    for (int16_t y = top; y < bottom; y++) {
        lim_strip_next(&strip, &edges, polygon->at, polygon->n, polygon->shape.first, y, *polygon->shape.end_row);
        if (!transparent)
            result |= (uint8_t)lim_mask_close(spans, &spans->lines[y], &strip, NULL, NULL);
        else if (lim_mask_see(spans, &spans->lines[y], &strip, NULL, NULL))
            return LIM_SPAN_SOME;
    }
    return result & LIM_SPAN_EXHAUSTED ? LIM_SPAN_EXHAUSTED : (enum lim_span_result)result;
}

/* Transparent -------------------------------------------------------------------------------- */

struct pusher {
    struct lim_layers *layers;
    uint16_t colour;
    uint8_t alpha;
};

static void push(void *ctx, const struct lim_run *run, uint16_t covered)
{
    const struct pusher *pusher = ctx;
    struct lim_layers *layers = pusher->layers;
    const uint8_t alpha = (uint8_t)((pusher->alpha * lim_sample_count(run->mask) + 8) >> 4);

    (void)covered;
    layers->exhausted = layers->exhausted || layers->used == layers->size;
    if (layers->exhausted) return;
    layers->pool[layers->used++] = (struct lim_layer){(uint16_t)run->x0, (uint16_t)run->x1, pusher->colour, alpha};
}

void lim_smooth_push(struct lim_layers *layers, const struct lim_spans *spans, const struct lim_line *line,
                     const struct lim_strip *strip, uint16_t colour, uint8_t alpha)
{
    struct pusher pusher = {layers, colour, alpha};

    (void)lim_mask_see(spans, line, strip, push, &pusher);
}

/* Background --------------------------------------------------------------------------------- */

void lim_smooth_background(const struct lim_spans *spans, const struct lim_line *line, uint16_t background,
                           struct lim_smooth_sink *sink)
{
    const struct lim_gap *gap = &line->gap;

    sink->colour = background;
    if (LIM_HAS_TEXTURE) sink->span->gradients = NULL;
    if (gap->x0 == gap->x1) return;
    for (;; gap = &spans->pool[gap->next]) {
        const struct lim_run run = {(int16_t)gap->x0, (int16_t)gap->x1, (uint16_t) ~*gap->covered};
        lim_smooth_mix(sink, &run, *gap->covered);
        if (gap->next == LIM_NONE) return;
    }
}

/* A line alone ------------------------------------------------------------------------------- */

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
        *sink.span = (struct lim_textured_span){paint->texturing, NULL, (int16_t)spans->open.y0, strip->x0, strip->x1};
        if (lim_screen_texture(polygon) != LIM_NONE) {
            lim_texture_set(paint->texturing, lim_screen_texture(polygon), &gradients);
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
    paint->smooth->line = NULL;
    return target->done(target->ctx, y, 0, target->w_px);
}

#endif
