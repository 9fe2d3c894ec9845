/* SPDX-License-Identifier: MIT
 *
 * TRACE: which pixels of its whole a piece has, line by line. In: the whole polygon on the screen, the piece's cuts.
 * Out: of each line the pixels x <= .. < y, bottom to top, as the retained polygons' cells have them; or, antialiased,
 * of each row the samples. */
#ifndef LIM_TRACE_H
#define LIM_TRACE_H

#include "orders.h"

/* Lines top <= y < bottom, one at least, of a projected polygon that is not non-monotone and has them: what of them is
 * within `open` and the piece's; but for those above and below that have nothing of it. That of `bottom` - 1 is first.
 */
void lim_trace_lines(const struct lim_sorter *sorter, uint16_t entry, const struct lim_screen_polygon *whole,
                     const struct lim_rect *open, struct lim_point *last, int16_t *top, int16_t *bottom);

/* Leaves of rows of samples what is. */
void lim_trace_cut(const struct lim_sorter *sorter, uint16_t entry, const struct lim_screen_polygon *whole,
                   struct lim_point *last, int16_t top, int16_t bottom);

/* The same of one line of the screen. */
struct lim_point lim_piece_line(const struct lim_sorter *sorter, uint16_t entry, const struct lim_screen_polygon *whole,
                                int16_t y);

#endif
