/* SPDX-License-Identifier: MIT
 *
 * Walking with buttons: the camera follows its path until up, down, left or right is pressed, and from there goes
 * forward or back, or turns, a step a frame for as long as a button is down; select gives it back to the path. A button
 * counts once it was seen released: what is stuck, or reads as down before it was ever touched, walks nowhere.
 *
 * Steps: a quarter of the near plane's distance (2.5 cm for the usual 10 cm) on the level, however the view is
 * pitched,
 *
 *     x -= near / 4 * sin(yaw), z -= near / 4 * cos(yaw),
 *
 * and 1/256 of a full turn.
 *
 * With a scene's solid it is a body, which walls stop: twice the near plane's distance to each side of the eye. If
 * there is a floor within 32 of these distances below the eye, it stands on it, as high as the eye was, climbs steps of
 * a quarter of that, and falls; else it floats.
 *
 * In a map of Doom (BOARD_PLAYER) it is as large and as fast as the player, for a near plane at 10 cm: 0.5 m to each
 * side, 0.4 m over the eye, up steps of 0.6 of the eye's height, 0.25 m a frame, and 1/64 of a full turn. */
#ifndef BOARDS_WALKER_H
#define BOARDS_WALKER_H

#include "camera.h"
#include "collide.h"

/* 0: nothing stops it, and nothing of that is linked. */
#ifndef BOARD_WALLS
#define BOARD_WALLS 1
#endif

#ifndef BOARD_PLAYER
#define BOARD_PLAYER 0
#endif

/* Of who is stopped by walls. */
struct walker_body {
    const struct lim_solid *solid; /* the caller's; NULL: nothing stops it */
    struct lim_walker feet;        /* if it has some */
    int32_t eye_q8;                /* how high its eye is above its feet; 0: it floats */
};

/* All zero: on the path, and no button was seen released. */
struct walker {
    struct lim_camera camera; /* the walker's, if there is one */
    LIM_OPTIONAL(struct walker_body, body, BOARD_WALLS);
    uint8_t released; /* buttons that were seen so, and count */
    bool walking;
};

/* What stops it. Said before the first walk. */
static inline void walker_set_solid(struct walker *walker, const struct lim_solid *solid)
{
    if (BOARD_WALLS) walker->body->solid = solid;
}

/* Once a frame. buttons: enum board_button, those that are down. camera: in, the path's; out, the one to draw. */
void walker_frame(struct walker *walker, uint8_t buttons, struct lim_camera *camera);

#endif
