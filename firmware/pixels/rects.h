/* SPDX-License-Identifier: MIT
 *
 * What changed, as rectangles that cost little to send: in pixels, which all of a rectangle has, and in windows, of
 * which each rectangle opens one. In: changed stretches of lines, from the top down. Out: a list of rectangles that
 * holds them all. The list is short; when it is full its owner sends it, and starts another. */
#ifndef LIM_RECTS_H
#define LIM_RECTS_H

#include "orders.h"

/* Puts a rectangle, not above the last one, where that costs least: to another one, which grows over all between them,
 * or on its own. false: it would be on its own, and there is no room. */
bool lim_rects_add(struct lim_rects *rects, const struct lim_rect *rect);

void lim_rects_clear(struct lim_rects *rects);

/* Puts rectangles together that cost no more so. None of them grows any more. */
void lim_rects_join(struct lim_rects *rects);

#endif
