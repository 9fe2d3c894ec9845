/* SPDX-License-Identifier: MIT
 *
 * Which subtrees can still be seen? The planes of the open rectangle (the pixels that are not yet
 * painted lie inside it) against a subtree's box. Conservative: says "no" only when it is certain. */
#ifndef LIM_CULL_H
#define LIM_CULL_H

#include "stages.h"

void lim_cull_set(struct lim_cull *cull, const struct lim_view *view, const int32_t eye_q8[3],
                  const struct lim_rect *open);

bool lim_cull_sees(const struct lim_cull *cull, const LIM_FLASH struct lim_box *box);

/* The same of a subtree that a walk comes to with so much on its stack: while there is as much, the walk is inside of
 * that subtree, and what the subtree's box is inside of need not be tried again. The answers are those of
 * lim_cull_sees(), if all above the subtree that have boxes were asked for. */
bool lim_cull_enters(struct lim_cull *cull, const LIM_FLASH struct lim_box *box, uint16_t depth);

#endif
