/* SPDX-License-Identifier: MIT
 *
 * What changed, as rectangles that cost little to send: in pixels, which all of a rectangle has, and in windows, which
 * each rectangle opens one of. In: changed stretches of lines, from the top down. Out: a list of rectangles that holds
 * them all. The list is short; when it is full its owner sends it, and starts another. */
#ifndef LIM_RECTS_H
#define LIM_RECTS_H

#include "target.h"

/* How many are put together at a time: more find better company, and take longer to. */
#ifndef LIM_DELTA_RECTS
#define LIM_DELTA_RECTS 16
#endif

struct lim_rects {
    uint16_t count;
    struct lim_rect rect[LIM_DELTA_RECTS];
};

/* Puts the rectangle where that costs least: to another one, which grows over all between them, or on its own. false:
 * it would be on its own, and there is no room. */
bool lim_rects_add(struct lim_rects *rects, const struct lim_target_costs *costs, const struct lim_rect *rect);

/* Puts rectangles together that cost no more so. */
void lim_rects_join(struct lim_rects *rects, const struct lim_target_costs *costs);

#endif
