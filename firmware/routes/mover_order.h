/* SPDX-License-Identifier: MIT
 *
 * Movers in empty space: a list that nothing of the static scene divides any more is put in order, and drawn. */
#ifndef LIM_MOVER_ORDER_H
#define LIM_MOVER_ORDER_H

#include "orders.h"

/* Puts a list that has come to empty space in order, nearest first or the other way round. Returns its head. */
uint16_t lim_movers_order(struct lim_sorter *sorter, uint16_t list, bool back_to_front);

/* Who draws. */
struct lim_mover_sink {
    /* A polygon, or the piece `entry` of one; LIM_NONE: it was never cut. */
    int (*draw)(void *ctx, uint16_t entry, const struct lim_screen_polygon *polygon, const struct lim_rect *open);
    /* An object's record before it is projected, in the colour that it has, or with its texture (first_texture:
     * lim_mover_first_texture()): LIM_MOVER_DRAW, to draw it then. Or NULL. */
    int (*take)(void *ctx, struct lim_view *view, const struct lim_scene *object, const LIM_FLASH lim_index *record,
                uint16_t first_texture);
    void *ctx;
    const struct lim_rect *open;
    bool back_to_front;
};
#define LIM_MOVER_DRAW INT16_MIN

/* Draws the polygons of an ordered list's entries one by one. Ends with what the sink returns, if that is not 0. */
int lim_movers_draw(struct lim_sorter *sorter, uint16_t list, const struct lim_mover_sink *sink);

#endif
