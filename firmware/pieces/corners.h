/* SPDX-License-Identifier: MIT
 *
 * Corners of the sorted list's pieces, to be compared with planes: in units, whole records exactly, pieces with 12
 * fraction bits, cut by the planes that made them. */
#ifndef LIM_CORNERS_H
#define LIM_CORNERS_H

#include "orders.h"

/* The corners of an entry, in one of two places. NULL: there are too many, or none. */
const struct lim_corners *lim_corners_of(const struct lim_sorter *sorter, uint16_t entry, struct lim_corners places[2]);

/* Those of the part of it on one side of a plane. */
const struct lim_corners *lim_corners_cut(const struct lim_sorter *sorter, uint16_t entry,
                                          const struct lim_plane_unpacked *plane, bool front,
                                          struct lim_corners places[2]);

#endif
