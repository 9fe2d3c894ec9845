/* SPDX-License-Identifier: MIT
 *
 * Textures of what moves are the scene's: each there once, whoever shows it. */
#ifndef SIM_MOVING_TEXTURES_H
#define SIM_MOVING_TEXTURES_H

#include "scene/moving.h"

/* The scene gets whatever its objects show and it has not; their records name the scene's textures then, and their
 * scenes lead into its arrays. Each object's image stays what it is, with textures of its own: a scene for itself.
 * false: together they are too many for the scene's indices; then objects show their records' colours. */
bool moving_share_textures(struct moving *moving, struct compiled *scene);

#endif
