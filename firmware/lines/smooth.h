/* SPDX-License-Identifier: MIT
 *
 * Antialiased edges, accumulated nearest first: a pixel whose samples are not all one polygon's stays open until all
 * are closed, and each polygon adds its colour as often as it closes a sample. In: strips (samples.h), gaps that know
 * samples (mask.h). Out: pixels. Memory: a line of sums, lent by whoever wants antialiasing. */
#ifndef LIM_SMOOTH_H
#define LIM_SMOOTH_H

#include "lines/mask.h"
#include "pixels/texture.h"
#include "screen/samples.h"

/* Where a polygon's samples go. */
struct lim_smooth_sink {
    uint16_t *line;
    uint32_t *sums;
    uint16_t colour; /* as it lies in memory */
    uint16_t painted_px;
    struct lim_stats *stats;
    LIM_OPTIONAL(struct lim_textured_span, span, LIM_HAS_TEXTURE); /* no gradients: of one colour */
};

/* Its context is a struct lim_smooth_sink. */
lim_mask_sink lim_smooth_mix;

/* SPAN: closes the samples of a polygon that is not non-monotone, on lines top <= y < bottom; if it is transparent,
 * only looks whether any is open. */
enum lim_span_result lim_smooth_close(struct lim_spans *spans, const struct lim_screen_polygon *polygon, int16_t top,
                                      int16_t bottom);

/* Pushes what is open of a transparent strip: at edges its alpha counts by samples. */
void lim_smooth_push(struct lim_layers *layers, const struct lim_spans *spans, const struct lim_line *line,
                     const struct lim_strip *strip, uint16_t colour, uint8_t alpha);

/* What stays open of a line. */
void lim_smooth_background(const struct lim_spans *spans, const struct lim_line *line, uint16_t background,
                           struct lim_smooth_sink *sink);

#endif
