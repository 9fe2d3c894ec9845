/* SPDX-License-Identifier: MIT
 *
 * Antialiased edges, accumulated nearest first: a pixel whose samples are not all one polygon's stays open until all
 * are closed, and each polygon adds its colour as often as it closes a sample. In: strips (samples.h), gaps that know
 * samples (mask.h). Out: pixels. Memory: a line of sums, lent by whoever wants antialiasing. */
#ifndef LIM_SMOOTH_H
#define LIM_SMOOTH_H

#include "lines/layers.h"
#include "lines/mask.h"
#include "lines/retain.h"
#include "pixels/texture.h"
#include "stats.h"

/* What lim_set_antialias() borrows: a line's sums, and which samples are closed where that has to do without gaps. */
#define LIM_ANTIALIAS_MEM_B(w_px) (((size_t)(w_px) * (sizeof(uint32_t) + sizeof(uint16_t)) + 3) & ~(size_t)3)

struct lim_smooth {
    uint32_t *sums;    /* of the colours of a pixel's closed samples: red from bit 20 on, green 10, blue 0; NULL: off */
    uint16_t *covered; /* the closed samples of a line that is drawn alone */
    uint16_t *line;    /* the memory of that line, or NULL */
    uint16_t open_px;  /* how many of its pixels are open */
};

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
