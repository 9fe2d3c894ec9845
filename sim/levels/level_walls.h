/* SPDX-License-Identifier: MIT
 *
 * Walls: what a line's sides show above, below and between the sectors beside it. */
#ifndef SIM_LEVEL_WALLS_H
#define SIM_LEVEL_WALLS_H

#include "levels/level.h"
#include "levels/level_faces.h"
#include "levels/level_moves.h"
#include "levels/level_sectors.h"

/* Between the sectors that there are (level_sectors.h), also where lines say otherwise or there is none, so that
 * nothing is open. moves: of each sector, whose heights in *level are those of open doors; those that have a mover get
 * their sides as well; NULL: none moves. sky: the index of the look of the sky's texture. */
void level_walls_add(const struct level *level, const struct level_sectors *sectors, const struct level_move *moves,
                     size_t sky, struct level_faces *faces);

#endif
