/* SPDX-License-Identifier: MIT
 *
 * Which sectors of a map are doors and lifts: by the specials of its lines. A door's ceiling goes up and comes down
 * again, a lift's floor goes down and comes up. */
#ifndef SIM_LEVEL_MOVES_H
#define SIM_LEVEL_MOVES_H

#include "levels/level.h"
#include "model/model.h"

/* --doors: as the map has them, all open and all lifts down, or objects that move. */
enum level_doors { LEVEL_DOORS_CLOSED, LEVEL_DOORS_OPEN, LEVEL_DOORS_MOVE };

/* What all maps are read with from now on, by this process and its children. */
void level_doors_set(enum level_doors doors);
enum level_doors level_doors(void);
bool level_doors_parse(const char *text, enum level_doors *out, struct error *err);

/* Of a sector, in its units; in those of an object that moves, a face's height is that at rest. */
struct level_move {
    enum model_kind kind; /* MODEL_MOVES: it stays */
    int rest, moved;      /* heights: a door's ceiling when it is closed and open, a lift's floor up and down */
    int speed;            /* units a tic */
    int wait_tics;
    uint16_t mover; /* from 1, of the model; 0: it has none (yet) */
};
enum { LEVEL_TICS_A_S = 35 };

/* Units: how far a door goes up beyond what is seen of its way, a lift down, and how far behind its lines a door's
 * sides are. So nothing that moves is ever in one plane with what stands still and looks the same way, nor so near to
 * it that the renderer takes it for that, which is some scene units. */
enum { LEVEL_MOVE_SLACK = 1 };

/* One for each sector; free() it. */
struct level_move *level_moves_find(const struct level *level);

/* Doors open, lifts down: what stands still behind what moves. */
void level_moves_open(const struct level_move *moves, struct level *level);

/* Adds a mover for a sector to the model; its origin is a place of it, in metres, at rest. */
uint16_t level_mover_add(struct model *model, const struct level_move *move, size_t sector, const double origin_m[3]);

/* When all are there: each gets its keys, and all of them last as long. */
void level_movers_finish(struct model *model, const struct level_move *moves, size_t count);

#endif
