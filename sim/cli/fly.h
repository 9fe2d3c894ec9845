/* SPDX-License-Identifier: MIT
 *
 * Flying the camera with keys, for `limner view`: what the window and the terminal share. */
#ifndef SIM_FLY_H
#define SIM_FLY_H

#include "collide.h"
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
    FLY_WALLS, /* through them, or not: once a press */
    FLY_KEYS
};

struct flight {
    struct simulator *simulator;
    struct lim_camera camera;
    double step_q8;        /* a move, units */
    bool is_long;          /* the scene is: the camera has an origin */
    struct moving *moving; /* NULL: nothing moves */
    bool began;
    double began_s; /* when the first frame was drawn */
    struct lim_solid solid;
    lim_index *stack;   /* of solid, owned; NULL: nothing stops it, as there is no tree */
    int32_t half_q8[3]; /* of the box around the eye that walls stop */
    bool through_walls;
};

/* One line for people. */
extern const char FLY_HELP[];

/* Steps of 0.1 m, less in a scene smaller than 10 m. `moving`: what the simulator has been given, or NULL. Walls stop a
 * box of twice the near plane's distance to each side, along which it slides; a mesh, which has no tree, stops nothing,
 * and neither does what moves. flight_free() it. */
bool flight_init(struct flight *flight, struct simulator *simulator, const struct lim_scene *scene,
                 const struct lim_camera *camera, const struct grid *grid, struct moving *moving, struct error *err);
void flight_free(struct flight *flight);

/* Draws a frame. What moves is where it is this long after the first one. */
bool flight_frame(struct flight *flight, struct error *err);

/* Moves or turns by one step; a move out of the renderer's range is not made. Where the eye is farther out than bodies
 * may be (collide.h), nothing stops it. */
void flight_key(struct flight *flight, enum fly_key key);

enum flight_end {
    FLIGHT_ENDED,      /* the user left */
    FLIGHT_IMPOSSIBLE, /* no display that anybody sees, or built without SDL2 */
    FLIGHT_FAILED      /* err says why */
};

/* Whether this program has SDL2, without which it opens no window. */
extern const bool window_is_built;

/* Flies in an SDL2 window. */
enum flight_end window_fly(struct flight *flight, struct error *err);

/* Flies in the terminal. Without one on both ends it fails, but for LIMNER_DUMP and LIMNER_CHECK (dump.h) shows one
 * picture. */
enum flight_end terminal_fly(struct flight *flight, struct error *err);

#endif
