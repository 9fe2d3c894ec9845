/* SPDX-License-Identifier: MIT
 *
 * Movers in empty space: a list that nothing of the static scene divides any more is put in order, and drawn. */
#ifndef LIM_MOVER_ORDER_H
#define LIM_MOVER_ORDER_H

#include "orders.h"

/* Puts a list that has come to empty space in order, nearest first or the other way round. Returns its head. */
uint16_t lim_movers_order(struct lim_sorter *sorter, uint16_t list, bool back_to_front);

/* Draws the polygons of an ordered list's entries one by one; `entry` is LIM_NONE for one that was never cut. Ends with
 * what `draw` returns, if that is not 0. */
typedef int lim_mover_draw(void *ctx, uint16_t entry, const struct lim_screen_polygon *polygon,
                           const struct lim_rect *open);
int lim_movers_draw(struct lim_sorter *sorter, uint16_t list, const struct lim_rect *open, bool back_to_front,
                    lim_mover_draw *draw, void *ctx);

#endif
