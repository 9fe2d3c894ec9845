/* SPDX-License-Identifier: MIT
 *
 * SPAN for antialiasing: per line, which samples are still open. The same lists of gaps in the same pool, but a gap
 * knows which samples of its pixels are closed, the same ones in each; a pixel stays in a gap until all are. */
#ifndef LIM_MASK_H
#define LIM_MASK_H

#include "lines/gaps.h"

struct lim_run;
struct lim_strip;

/* Receives pixels x0 <= x < x1 of a line, left to right: of each, the samples `mask` were open; `covered`, others,
 * were closed before. */
typedef void lim_mask_sink(void *ctx, const struct lim_run *run, uint16_t covered);

/* Closes the samples that a strip has on a line. Those that were open go to `sink`, if any. */
enum lim_span_result lim_mask_close(struct lim_spans *spans, struct lim_line *line, const struct lim_strip *strip,
                                    lim_mask_sink *sink, void *ctx);

/* What of a strip's samples is open, to `sink`; it stays open. true: something is. Without a sink the answer is all
 * there is. */
bool lim_mask_see(const struct lim_spans *spans, const struct lim_line *line, const struct lim_strip *strip,
                  lim_mask_sink *sink, void *ctx);

#endif
