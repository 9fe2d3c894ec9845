/* SPDX-License-Identifier: MIT
 *
 * The scene that a firmware was compiled for (`limner compile -o DIR/model`), its cameras (`limner render
 * --write-cameras DIR/cameras.h`), and the renderer with all the memory that they ask for. Features that the scene's
 * header switches on are used. There is one in a firmware. */
#ifndef BOARDS_APP_SCENE_H
#define BOARDS_APP_SCENE_H

#include "limner.h"

#include "cameras.h"
#include "collide.h"
#include "model.h"
#include "screen_work.h"

/* How many lines of h_px the target must be able to lend at any time. */
#define SCENE_LINES(h_px) MODEL_SCENE_LINES(h_px)
#define SCENE_METHOD MODEL_SCENE_METHOD

/* How many frames are announced before the one that is drawn: with two renderers one, of which it is found out what is
 * seen while the other is on its way. What is painted or filled at once has nothing to be done ahead. */
#ifndef SCENE_RENDERERS
#define SCENE_RENDERERS 1
#endif
#if SCENE_RENDERERS > 1 && LIM_HAS_SPANS && !LIM_HAS_FILLED
#define SCENE_AHEAD 1
#else
#define SCENE_AHEAD 0
#endif

/* Before any frame. target must outlive them. 0 or what the renderer's functions return. */
LIM_MUST_CHECK int scene_init(const struct lim_target *target);

/* The cameras in turn; frame below CAMERAS_COUNT. */
void scene_camera(uint16_t frame, struct lim_camera *camera);

/* What stops a walker in it; NULL: nothing, as it is a mesh, or BOARD_WALLS is 0. */
const struct lim_solid *scene_solid(void);

/* The frame of the path that is next to be announced: its camera, which is read until the frame is drawn, and where
 * what moves in the scene is then (its animation, once over the whole path or, where that is SCENE_FRAMES_PER_S, at
 * that rate as `limner render --fps` has it). */
void scene_announce(uint16_t frame, const struct lim_camera *camera);

/* Something else was shown meanwhile: the next frame is sent whole. */
void scene_refresh(void);

/* Draws the frame that was announced, or of two the earlier one, into the target. 0 or what lim_frame() returns. */
LIM_MUST_CHECK int scene_draw(void);

/* For screen_set_bus(): a little of the frame that is not being drawn yet, if SCENE_AHEAD; else nothing. */
screen_work scene_work;

/* Marks of a frame, which do nothing, for whoever counts what is between them. */
void frame_begin(uint16_t frame);
void frame_end(uint16_t frame);

#endif
