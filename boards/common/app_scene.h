/* SPDX-License-Identifier: MIT
 *
 * The scene that a firmware was compiled for (`limner compile -o DIR/model`), its cameras (`limner render
 * --write-cameras DIR/cameras.h`), and the renderer with all the memory that they ask for. Features that the scene's
 * header switches on are used. There is one in a firmware. */
#ifndef BOARDS_APP_SCENE_H
#define BOARDS_APP_SCENE_H

#include "limner.h"

#include "cameras.h"
#include "model.h"

/* How many lines of h_px the target must be able to lend at any time. */
#define SCENE_LINES(h_px) MODEL_SCENE_LINES(h_px)
#define SCENE_METHOD MODEL_SCENE_METHOD

/* Before any frame. target must outlive them. 0 or what the renderer's functions return. */
LIM_MUST_CHECK int scene_init(const struct lim_target *target);

/* The cameras in turn; frame below CAMERAS_COUNT. */
void scene_camera(uint16_t frame, struct lim_camera *camera);

/* Puts what moves in the scene where it is in that frame of the path: its animation, once over the whole path or, where
 * that is SCENE_FRAMES_PER_S, at that rate as `limner render --fps` has it. */
void scene_place(uint16_t frame);

/* One frame into the target. 0 or what lim_frame() returns. */
LIM_MUST_CHECK int scene_draw(const struct lim_camera *camera);

/* Marks of a frame, which do nothing, for whoever counts what is between them. */
void frame_begin(uint16_t frame);
void frame_end(uint16_t frame);

#endif
