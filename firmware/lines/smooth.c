/* SPDX-License-Identifier: MIT
 *
 * What is narrow, textured or transparent is counted pixel by pixel. */
#include "lines/smooth.h"

#include "lines/layers.h"
#include "screen/polygon.h"

#if LIM_HAS_ANTIALIAS

/* Pixels x0 <= x < x1 of a line, from LIM_STRIP_BIAS_PX before it on, of each of which a strip has as many samples. */
typedef void run_sink(void *ctx, uint32_t x0, uint32_t x1, uint32_t n);

static LIM_INLINE void count_runs(const struct lim_strip *open, uint32_t x, uint32_t end, run_sink *sink, void *ctx)
{
    uint32_t before = lim_strip_count(open, x);

    for (; x < end; x++) {
        const uint32_t after = lim_strip_count(open, x + 1);
        if (after != before) sink(ctx, x, x + 1, after - before);
        before = after;
    }
}

/* Left to right: pixels at the left, those that it has all of, pixels at the right. */
static LIM_INLINE void find_runs(const struct lim_strip *open, run_sink *sink, void *ctx)
{
    enum { UP = LIM_SAMPLES_A_ROW - 1 };
    const uint32_t x0 = lim_bound_low(&open->left) / LIM_SAMPLES_A_ROW,
                   inner0 = (lim_bound_high(&open->left) + UP) / LIM_SAMPLES_A_ROW,
                   inner1 = lim_bound_low(&open->right) / LIM_SAMPLES_A_ROW,
                   x1 = (lim_bound_high(&open->right) + UP) / LIM_SAMPLES_A_ROW;

    if (inner0 >= inner1) {
        count_runs(open, x0, x1, sink, ctx);
        return;
    }
    count_runs(open, x0, inner0, sink, ctx);
    sink(ctx, inner0, inner1, LIM_SAMPLES);
    count_runs(open, inner1, x1, sink, ctx);
}

/* A pixel at a time, from the left: how many of its samples are before its right end, and were before its left one.
 * What of a sink is asked for at each is kept apart from what is written to. */
struct mixing {
    uint16_t *line;
    uint32_t *sums, share, at, before;
    uint16_t painted_px;
};

static inline struct mixing mixing_from(const struct lim_smooth_sink *sink, uint32_t x)
{
    return (struct mixing){
        .line = sink->line, .sums = sink->sums, .share = sink->share, .at = pair_of_both(x * LIM_SAMPLES_A_ROW)};
}

static inline uint32_t mixing_beyond(const struct mixing *mixing, const struct lim_bound *bound)
{
    return pair_beyond(mixing->at, bound->rows[0]) + pair_beyond(mixing->at, bound->rows[1]);
}

static LIM_INLINE void mix_next(struct mixing *mixing, uint32_t x, uint32_t n)
{
    if (!n) return;
    const bool closes = lim_smooth_add_to(mixing->line, mixing->sums, x - LIM_STRIP_BIAS_PX, n, mixing->share);
    if (LIM_HAS_STATS) mixing->painted_px = (uint16_t)(mixing->painted_px + closes);
}

/* Pixels x <= .. < end, from the one with the first sample. */
static LIM_ALONE void mix_narrow(struct lim_smooth_sink *sink, struct lim_strip open, uint32_t x, uint32_t end)
{
    struct mixing mixing = mixing_from(sink, x);

    for (; x < end; x++) {
        mixing.at += pair_of_both(LIM_SAMPLES_A_ROW);
        const uint32_t after = pair_sum(mixing_beyond(&mixing, &open.left) - mixing_beyond(&mixing, &open.right));
        mix_next(&mixing, x, after - mixing.before);
        mixing.before = after;
    }
    if (LIM_HAS_STATS) sink->painted_px = (uint16_t)(sink->painted_px + mixing.painted_px);
}

/* A texture's colours come by way of the line, whose pixels mean nothing yet while they are open. */
static run_sink mix_textured_run;
static inline void mix_textured_run(void *ctx, uint32_t x0, uint32_t x1, uint32_t n)
{
    struct lim_smooth_sink *sink = ctx;
    const uint16_t from = (uint16_t)(x0 - LIM_STRIP_BIAS_PX), end = (uint16_t)(x1 - LIM_STRIP_BIAS_PX);
    bool closes = true;

    lim_texture_fill(sink->span, sink->line, from, end, *sink->stats);
    if (n != LIM_SAMPLES) closes = lim_smooth_add_samples(sink, from, n, lim_smooth_share(sink->line[from]));
    if (LIM_HAS_STATS && closes) sink->painted_px = (uint16_t)(sink->painted_px + (end - from));
}

static LIM_ALONE void mix_textured(struct lim_smooth_sink *sink, const struct lim_strip *open)
{
    if (LIM_HAS_TEXTURE) find_runs(open, mix_textured_run, sink);
}

static LIM_INLINE void smooth_fill(struct lim_smooth_sink *sink, uint32_t x0, uint32_t x1)
{
    if (x0 >= x1) return;
    lim_fill_inline(sink->line, (int_fast16_t)x0, (int_fast16_t)x1, sink->colour);
    if (LIM_HAS_STATS) sink->painted_px = (uint16_t)(sink->painted_px + (x1 - x0));
}

/* Pixels x <= .. < end that a bound crosses. Right of it: what a polygon has of them; left of it: all but that. */
static LIM_INLINE void mix_side(struct lim_smooth_sink *sink, const struct lim_bound *bound, uint32_t x, uint32_t end,
                                bool right_of_it)
{
    struct mixing mixing = mixing_from(sink, x);

    do {
        mixing.at += pair_of_both(LIM_SAMPLES_A_ROW);
        const uint32_t after = pair_sum(mixing_beyond(&mixing, bound)), n = after - mixing.before;
        mix_next(&mixing, x, right_of_it ? n : LIM_SAMPLES - n);
        mixing.before = after;
    } while (++x < end);
    if (LIM_HAS_STATS) sink->painted_px = (uint16_t)(sink->painted_px + mixing.painted_px);
}

/* Most edges are steep, and cross one pixel of a line: how much of it is the sum of where they are in its rows. */
void lim_smooth_mix(void *ctx, uint32_t left0, uint32_t left1, uint32_t right0, uint32_t right1)
{
    const struct lim_bound left = {{left0, left1}}, right = {{right0, right1}};
    struct lim_smooth_sink *sink = ctx;

    if (LIM_HAS_TEXTURE && sink->span->gradients) {
        mix_textured(sink, &(struct lim_strip){left, right});
        return;
    }
    const bool left_steep = lim_bound_is_in_pixel(&left), right_steep = lim_bound_is_in_pixel(&right);
    uint32_t x0 = pair_low(left.rows[0]) / LIM_SAMPLES_A_ROW, inner0 = x0 + 1;
    uint32_t inner1 = pair_low(right.rows[0]) / LIM_SAMPLES_A_ROW, x1 = inner1 + 1;
    if (!left_steep) {
        x0 = lim_bound_low(&left) / LIM_SAMPLES_A_ROW;
        inner0 = (lim_bound_high(&left) + LIM_SAMPLES_A_ROW - 1) / LIM_SAMPLES_A_ROW;
    }
    if (!right_steep) {
        inner1 = lim_bound_low(&right) / LIM_SAMPLES_A_ROW;
        x1 = (lim_bound_high(&right) + LIM_SAMPLES_A_ROW - 1) / LIM_SAMPLES_A_ROW;
    }
    if (inner0 > inner1) {
        mix_narrow(sink, (struct lim_strip){left, right}, x0, x1);
        return;
    }
    if (left_steep) {
        const uint32_t n = LIM_SAMPLES * inner0 - lim_bound_sum(&left);
        if (n != LIM_SAMPLES)
            lim_smooth_mix_pixel(sink, x0 - LIM_STRIP_BIAS_PX, n);
        else
            inner0 = x0;
    } else {
        mix_side(sink, &left, x0, inner0, true);
    }
    smooth_fill(sink, inner0 - LIM_STRIP_BIAS_PX, inner1 - LIM_STRIP_BIAS_PX);
    if (right_steep) {
        const uint32_t n = lim_bound_sum(&right) - LIM_SAMPLES * inner1;
        if (n) lim_smooth_mix_pixel(sink, inner1 - LIM_STRIP_BIAS_PX, n);
    } else {
        mix_side(sink, &right, inner1, x1, false);
    }
}

static LIM_INLINE enum lim_span_result close_line(struct lim_spans *spans, struct lim_line *line, struct lim_bound left,
                                                  struct lim_bound right)
{
    if (line->gap.next == LIM_NONE) { /* all of it is open, or nothing */
        if (line->gap.x0 == line->gap.x1) return LIM_SPAN_NOTHING;
        if (!lim_strips_begin(spans, line)) return LIM_SPAN_EXHAUSTED;
    }
    return lim_strips_close(spans, line, left, right, NULL, NULL);
}

LIM_ALONE enum lim_span_result lim_smooth_close_line(struct lim_spans *spans, int16_t y, const struct lim_strip *strip)
{
    return close_line(spans, &spans->lines[y], strip->left, strip->right);
}

/* The first and the last line of which something was open; NULL: none so far. */
struct seen_lines {
    struct lim_line *top, *last;
};

static inline bool see_line(struct seen_lines *seen, struct lim_line *line, enum lim_span_result result)
{
    if (result == LIM_SPAN_NOTHING) return true;
    if (result == LIM_SPAN_EXHAUSTED) return false;
    if (!seen->top) seen->top = line;
    seen->last = line;
    return true;
}

/* Most lines: both edges go on through all of them. false: a pool is exhausted. */
static LIM_ALONE bool close_through(struct lim_spans *spans, struct lim_sample_edges *edges, int16_t y, int16_t end,
                                    struct seen_lines *seen)
{
    struct lim_line *line = &spans->lines[y], *const after = &spans->lines[end];
    struct lim_line *top = seen->top, *last = seen->last;

    do {
        const struct lim_bound left = lim_bound_step(&edges->left.x_q16, edges->left.step_q16),
                               right = lim_bound_step(&edges->right.x_q16, edges->right.step_q16);
        const enum lim_span_result result = close_line(spans, line, left, right);
        if (result == LIM_SPAN_NOTHING) continue;
        if (result == LIM_SPAN_EXHAUSTED) return false;
        if (!top) top = line;
        last = line;
    } while (++line < after);
    *seen = (struct seen_lines){top, last};
    return true;
}

/* Any line of a polygon. */
static bool close_any(struct lim_spans *spans, const struct lim_screen_polygon *polygon, struct lim_sample_edges *edges,
                      int16_t y, struct seen_lines *seen)
{
    struct lim_strip strip;

    lim_strip_any(&strip, edges, polygon->at, polygon->n, polygon->shape.first, y, *polygon->shape.end_row);
    return see_line(seen, &spans->lines[y], lim_smooth_close_line(spans, y, &strip));
}

static LIM_IF_CALLED bool see_open(const struct lim_spans *spans, const struct lim_screen_polygon *polygon,
                                   const struct lim_span_extent *shown)
{
    struct lim_sample_edges edges;

    lim_strip_begin(&edges, polygon->n, polygon->shape.first);
    for (int16_t y = shown->top; y < shown->bottom; y++) {
        const struct lim_strip strip =
            lim_strip_next(&edges, polygon->at, polygon->n, polygon->shape.first, y, *polygon->shape.end_row);
        if (lim_strips_see(spans, &spans->lines[y], &strip, NULL, NULL)) return true;
    }
    return false;
}

bool lim_smooth_close(struct lim_spans *spans, const struct lim_screen_polygon *polygon, struct lim_span_extent *shown,
                      bool stays_open)
{
    const int16_t bottom = shown->bottom;
    struct seen_lines seen = {NULL, NULL};
    struct lim_sample_edges edges;

    if (stays_open || (LIM_HAS_TRANSPARENT && lim_alpha_of(polygon) != LIM_OPAQUE)) {
        if (!see_open(spans, polygon, shown)) shown->top = bottom;
        return true;
    }
    lim_strip_begin(&edges, polygon->n, polygon->shape.first);
    for (int16_t y = shown->top; y < bottom;) {
        const int16_t end_row = edges.left.end < edges.right.end ? edges.left.end : edges.right.end;
        int16_t end = (int16_t)(end_row >> 2);
        if (end > bottom) end = bottom;
        if (end <= y) {
            end = (int16_t)(y + 1);
            if (!close_any(spans, polygon, &edges, y, &seen)) return false;
        } else if (!close_through(spans, &edges, y, end, &seen)) {
            return false;
        }
        y = end;
    }
    *shown = (struct lim_span_extent){bottom, bottom};
    if (seen.top)
        *shown = (struct lim_span_extent){(int16_t)(seen.top - spans->lines), (int16_t)(seen.last - spans->lines + 1)};
    return true;
}

/* Transparent -------------------------------------------------------------------------------- */

struct pusher {
    struct lim_layers *layers;
    uint16_t colour;
    uint8_t alpha;
};

static run_sink push_run;
static void push_run(void *ctx, uint32_t x0, uint32_t x1, uint32_t n)
{
    const struct pusher *pusher = ctx;
    struct lim_layers *layers = pusher->layers;
    const uint8_t whole = LIM_HAS_MASKED ? lim_layers_alpha(layers, pusher->alpha) : pusher->alpha;
    const uint8_t alpha = (uint8_t)((whole * n + LIM_SAMPLES / 2) / LIM_SAMPLES);

    layers->exhausted = layers->exhausted || layers->used == layers->size;
    if (layers->exhausted) return;
    layers->pool[layers->used++] = (struct lim_layer){.x0 = (uint16_t)(x0 - LIM_STRIP_BIAS_PX),
                                                      .x1 = (uint16_t)(x1 - LIM_STRIP_BIAS_PX),
                                                      .colour = pusher->colour,
                                                      .alpha = alpha};
    if (LIM_HAS_MASKED) lim_layers_note(layers);
}

static lim_strip_sink push;

static void push(void *ctx, uint32_t left0, uint32_t left1, uint32_t right0, uint32_t right1)
{
    find_runs(&(struct lim_strip){{{left0, left1}}, {{right0, right1}}}, push_run, ctx);
}

void lim_smooth_push(struct lim_layers *layers, const struct lim_spans *spans, const struct lim_line *line,
                     const struct lim_strip *strip, uint16_t colour, uint8_t alpha)
{
    struct pusher pusher = {layers, colour, alpha};

    (void)lim_strips_see(spans, line, strip, push, &pusher);
}

#endif
