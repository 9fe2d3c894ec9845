/* SPDX-License-Identifier: MIT
 *
 * An antialiased line for which the pools are too small is drawn alone, from a walk of its own, nearest first. Memory:
 * that of lim_set_antialias(). */
#ifndef LIM_SMOOTH_LINE_H
#define LIM_SMOOTH_LINE_H

#include "screen/samples.h"
#include "stages.h"

/* A line for which the pools are too small is drawn alone, from a walk of its own, nearest first: begun, then every
 * polygon at once, then ended. The same sums in the same order. Returns an enum lim_error or the target's. */
int lim_smooth_begin_line(struct lim_paint *paint, uint16_t y);
void lim_smooth_add(struct lim_paint *paint, struct lim_spans *spans, const struct lim_strip *strip,
                    const struct lim_screen_polygon *polygon);
void lim_smooth_add_polygon(struct lim_paint *paint, struct lim_spans *spans, const struct lim_screen_polygon *polygon);
int lim_smooth_end_line(struct lim_paint *paint, struct lim_spans *spans, uint16_t y);

/* The same of one pixel of a line that was begun, where something moves: from as many walks as it shows polygons, of
 * which each adds the nearest that has samples of it that are open. What of a polygon these are, and its strip there;
 * its share (lim_smooth_share()); adding; and the end. */
uint16_t lim_smooth_see_pixel(const struct lim_paint *paint, const struct lim_screen_polygon *polygon, uint16_t x,
                              uint16_t y, struct lim_strip *strip);
uint32_t lim_smooth_share_there(const struct lim_paint *paint, const struct lim_screen_polygon *polygon, uint16_t x,
                                uint16_t y, const struct lim_strip *strip);
void lim_smooth_add_to_pixel(struct lim_paint *paint, struct lim_spans *spans, uint16_t x, uint16_t samples,
                             uint32_t share);
int lim_smooth_end_pixel(struct lim_paint *paint, struct lim_spans *spans, uint16_t x, uint16_t y);

#endif
