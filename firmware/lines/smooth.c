/* SPDX-License-Identifier: MIT
 *
 * Sums are of 16 samples, so a channel needs four bits more than it has: all three fit 32 bits, and are added and
 * rounded together. Colours are mixed as they are blended (blend.h), in the panel's values. */
#include "lines/smooth.h"

#include "pixels/fill.h"
#include "screen/polygon.h"
#include "screen/samples.h"

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

static lim_mask_sink push;

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

#endif
