/* SPDX-License-Identifier: MIT
 *
 * TRACE: which pixels of its whole a piece has, line by line. In: the whole polygon on the screen, the piece's cuts.
 * Out: of each line the pixels x <= .. < y, bottom to top, as the retained polygons' cells have them; or, antialiased,
 * of each row the samples. */
#ifndef LIM_TRACE_H
#define LIM_TRACE_H

#include "orders.h"

/* Lines top <= y < bottom, one at least, of a projected polygon that is not non-monotone and has them, as far as they
 * are within `open`: that of `bottom` - 1 first. */
void lim_trace_lines(struct lim_point *last, const struct lim_screen_polygon *whole, const struct lim_rect *open,
                     int16_t top, int16_t bottom);

/* Whether a piece has to be told from its whole: not if all other parts are drawn nearer, and hide theirs. */
bool lim_trace_is_needed(const struct lim_sorter *sorter, uint16_t entry, const struct lim_screen_polygon *whole);

/* Leaves of lines, or of rows, what is the piece's, or is hidden by other parts. */
void lim_trace_cut(const struct lim_sorter *sorter, uint16_t entry, const struct lim_screen_polygon *whole,
                   struct lim_point *last, int16_t top, int16_t bottom);

/* Both for one line of the screen. */
struct lim_point lim_piece_line(const struct lim_sorter *sorter, uint16_t entry, const struct lim_screen_polygon *whole,
                                int16_t y);

#endif
