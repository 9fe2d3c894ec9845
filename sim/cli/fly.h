/* SPDX-License-Identifier: MIT
 *
 * Flying the camera with keys, for `limner view`: what the window and the terminal share. */
#ifndef SIM_FLY_H
#define SIM_FLY_H

#include "render/simulator.h"
#include "scene/moving.h"

enum fly_key {
    FLY_FORWARD,
    FLY_BACK,
    FLY_LEFT,
    FLY_RIGHT,
    FLY_UP,
    FLY_DOWN,
    FLY_TURN_LEFT,
    FLY_TURN_RIGHT,
    FLY_LOOK_UP,
    FLY_LOOK_DOWN,
    FLY_KEYS
};

struct flight {
    struct simulator *simulator;
    struct lim_camera camera;
    double step_q8;        /* a move, units */
    struct moving *moving; /* NULL: nothing moves */
    bool began;
    double began_s; /* when the first frame was drawn */
};

/* One line for people. */
extern const char FLY_HELP[];

/* Steps of 0.1 m, less in a scene smaller than 10 m. `moving`: what the simulator has been given, or NULL. */
void flight_init(struct flight *flight, struct simulator *simulator, const struct lim_camera *camera,
                 const struct grid *grid, struct moving *moving);

/* Draws a frame. What moves is where it is this long after the first one. */
bool flight_frame(struct flight *flight, struct error *err);

/* Moves or turns by one step; a move out of the renderer's range is not made. */
void flight_key(struct flight *flight, enum fly_key key);

enum flight_end {
    FLIGHT_ENDED,      /* the user left */
    FLIGHT_IMPOSSIBLE, /* no display that anybody sees, or built without SDL2 */
    FLIGHT_FAILED      /* err says why */
};

/* Flies in an SDL2 window. */
enum flight_end window_fly(struct flight *flight, struct error *err);

/* Flies in the terminal. Without one on both ends it fails, but for LIMNER_DUMP and LIMNER_CHECK (dump.h) shows one
 * picture. */
enum flight_end terminal_fly(struct flight *flight, struct error *err);

#endif
