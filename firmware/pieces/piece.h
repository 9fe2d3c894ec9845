/* SPDX-License-Identifier: MIT
 *
 * Pieces of split polygons. A piece is a whole record and a list of planes, each with the side on which the piece
 * lies. It gets no vertices of its own on the screen: of each line's pixels of the whole polygon it takes those on
 * its side of the plane's trace, and the piece on the other side takes the rest. So pieces together have the
 * pixels of the whole, each once, whatever is rounded, and neighbours of the whole notice nothing. */
#ifndef LIM_PIECE_H
#define LIM_PIECE_H

#include "orders.h"

/* On which sides of a plane something lies: none is "on it". */
enum { LIM_SIDE_FRONT = 1, LIM_SIDE_BACK = 2, LIM_SIDE_BOTH = 3 };

/* The pixels that a whole entry may have. false: none. */
bool lim_piece_rect(struct lim_sorter *sorter, uint16_t entry);

/* The sides of the plane of entry `by` on which entry `of` has corners. What was cut to a side is on that. */
uint8_t lim_piece_sides(const struct lim_sorter *sorter, uint16_t of, uint16_t by);

/* Whether there is room for one piece more. */
bool lim_piece_has_room(const struct lim_sorter *sorter);

/* Cuts `entry` in two by the plane of entry `by`; the piece in front of it stays in place. Returns the new entry of the
 * other, in no list yet, or LIM_NONE: there is no room, or it would have too many corners. */
uint16_t lim_piece_split(struct lim_sorter *sorter, uint16_t entry, uint16_t by);

/* Test 5 or 6, on the screen, rounded to sub-pixels as it is painted: whether `part` of entry `of` overlaps entry `by`.
 * LIM_SIDE_BOTH: all of it; else what lies on that side of the plane of `by`, the eye being in front. What only touches
 * does not overlap. */
bool lim_piece_overlaps(struct lim_sorter *sorter, uint16_t of, uint16_t by, uint8_t part);

#endif
