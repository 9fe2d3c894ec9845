/* SPDX-License-Identifier: MIT
 *
 * Antialiased edges, accumulated nearest first: a pixel whose samples are not all one polygon's stays open until all
 * are closed, and each polygon adds its colour as often as it closes a sample. In: strips (samples.h), gaps that know
 * samples (strips.h). Out: pixels. Memory: a line of sums, lent by whoever wants antialiasing. */
#ifndef LIM_SMOOTH_H
#define LIM_SMOOTH_H

#include "colour.h"
#include "lines/strips.h"
#include "pixels/fill.h"
#include "pixels/texture.h"

/* Where a polygon's samples go. */
struct lim_smooth_sink {
    uint16_t *line;
    uint32_t *sums;
    uint32_t share;  /* what a sample adds to a sum: lim_smooth_share() */
    uint16_t colour; /* as it lies in memory */
    uint16_t painted_px;
    LIM_OPTIONAL(struct lim_stats *, stats, LIM_HAS_TEXTURE);
    LIM_OPTIONAL(struct lim_textured_span, span, LIM_HAS_TEXTURE); /* no gradients: of one colour */
};

/* Sums are of 16 samples, so a channel needs four bits more than it has: all three and the samples' number, modulo 16,
 * fit 32 bits, and are added together. Colours are mixed as they are blended (blend.h), in the panel's values. */
static inline uint32_t lim_smooth_share(uint16_t colour)
{
    const uint32_t rgb565 = lim_memory_colour(colour);

    return UINT32_C(1) << 28 | (rgb565 & 0xF800) << 8 | (rgb565 & 0x07E0) << 4 | (rgb565 & 0x1F);
}

/* A sixteenth of a sum, rounded. */
static inline uint16_t lim_smooth_colour(uint32_t sum)
{
    const uint32_t sixteenfold = sum + (UINT32_C(8) << 19 | UINT32_C(8) << 9 | 8);

    return lim_memory_colour(
        (uint16_t)((sixteenfold >> 12 & 0xF800) | (sixteenfold >> 8 & 0x07E0) | (sixteenfold >> 4 & 0x1F)));
}

/* n samples of a pixel, 1 to 16. The last ones of it write it, and leave a sum of 0. true: these were. */
static inline bool lim_smooth_add_to(uint16_t *line, uint32_t *sums, uint32_t x, uint32_t n, uint32_t share)
{
    const uint32_t sum = sums[x] + n * share;

    if (sum >> 28) {
        sums[x] = sum;
        return false;
    }
    sums[x] = 0;
    line[x] = lim_smooth_colour(sum);
    return true;
}

static inline bool lim_smooth_add_samples(const struct lim_smooth_sink *sink, uint32_t x, uint32_t n, uint32_t share)
{
    return lim_smooth_add_to(sink->line, sink->sums, x, n, share);
}

static LIM_INLINE void lim_smooth_mix_pixel(struct lim_smooth_sink *sink, uint32_t x, uint32_t n)
{
    const bool closes = lim_smooth_add_samples(sink, x, n, sink->share);

    if (LIM_HAS_STATS) sink->painted_px = (uint16_t)(sink->painted_px + closes);
}

/* One polygon's pixels in a line, samples of which were open. Its context is a struct lim_smooth_sink. */
lim_strip_sink lim_smooth_mix;

/* SPAN: closes the samples of a polygon that is not non-monotone, on lines `shown`, which shrink to those of which some
 * were open; if it stays open, as if it is transparent, only looks whether any is. false: a pool is exhausted. */
bool lim_smooth_close(struct lim_spans *spans, const struct lim_screen_polygon *polygon, struct lim_span_extent *shown,
                      bool stays_open);

/* What an active polygon has on a line, and its edges go on to the next. */
static LIM_INLINE struct lim_strip lim_smooth_strip(struct lim_sample_edges *edges, const struct lim_active *active,
                                                    const union lim_retained_cell *cells, int32_t y)
{
    const struct lim_point *at = &cells[LIM_RETAINED_HEAD_CELLS].at;

    if (LIM_HAS_NEWELL && !cells[0].link.n) {
        struct lim_strip strip;
        lim_strip_of_rows(&strip, at, (int16_t)active->bottom, (int16_t)y);
        return strip;
    }
    return lim_strip_next(edges, at, cells[0].link.n, cells[0].link.first, y, (int16_t)active->bottom);
}

/* The same of a strip of line y. */
enum lim_span_result lim_smooth_close_line(struct lim_spans *spans, int16_t y, const struct lim_strip *strip);

/* Pushes what is open of a transparent strip: at edges its alpha counts by samples. */
void lim_smooth_push(struct lim_layers *layers, const struct lim_spans *spans, const struct lim_line *line,
                     const struct lim_strip *strip, uint16_t colour, uint8_t alpha);

#endif
