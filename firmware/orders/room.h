/* SPDX-License-Identifier: MIT
 *
 * Room in pools that pass one has filled: the band's lower lines are left for the next band, with what they took. */
#ifndef LIM_ROOM_H
#define LIM_ROOM_H

#include "orders.h"

/* Takes lines away from the band's end, so that pass one can go on where it is. Polygons that are retained move, and
 * what starts on those lines is gone. false: nothing was done; the band is too low, or drawn in a way that keeps more
 * than whole polygons. */
LIM_MUST_CHECK bool lim_room_make(struct lim_nearest *nearest);

/* Keeps cells for polygons that cross a line, from the next band of the frame on; false: there are few enough left. */
LIM_MUST_CHECK bool lim_room_keep(struct lim_nearest *nearest);

#endif
