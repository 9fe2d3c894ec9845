/* SPDX-License-Identifier: MIT
 *
 * Corners of the sorted list's pieces, to be compared with planes: in units, whole records exactly, pieces with 12
 * fraction bits, cut by the planes that made them. */
#ifndef LIM_CORNERS_H
#define LIM_CORNERS_H

#include "orders.h"
#include "view/plane_unpacked.h"

/* Holds something that moves, along the scene's axes. |coordinate| <= 2^28. */
struct lim_reach {
    int32_t low_q12[3], high_q12[3];
};

/* Keeps it with an entry. */
void lim_entry_set_extent(struct lim_sorter *sorter, uint16_t entry, struct lim_reach reach);

/* The corner of a record, in units of the scene. */
void lim_entry_corner(const struct lim_sorter *sorter, uint16_t entry, lim_index vertex, int32_t at_q12[3]);

/* Of the corners of an entry, in one of two places, those of the part on one side of a plane, in the other. NULL: as
 * below. */
const struct lim_corners *lim_corners_part(const struct lim_sorter *sorter, uint16_t entry,
                                           const struct lim_corners *whole, const struct lim_plane_unpacked *plane,
                                           bool front, struct lim_corners places[2]);

/* Those of the part of it on one side of a plane. */
const struct lim_corners *lim_corners_cut(const struct lim_sorter *sorter, uint16_t entry,
                                          const struct lim_plane_unpacked *plane, bool front,
                                          struct lim_corners places[2]);

/* The corners of an entry, in one of two places or where they are kept until others are asked for. NULL: there are too
 * many, or none. */
const struct lim_corners *lim_corners_of(const struct lim_sorter *sorter, uint16_t entry, struct lim_corners places[2]);

/* Cuts an entry's corners by a plane, and keeps both parts: that in front as what cut `cut` has made, an even number,
 * the other as what the next one has. false: a part would have too many corners, or too few; what was kept is void. */
bool lim_corners_split(const struct lim_sorter *sorter, uint16_t entry, const struct lim_plane_unpacked *plane,
                       uint16_t cut);

#endif
