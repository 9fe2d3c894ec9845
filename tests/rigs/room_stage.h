/* SPDX-License-Identifier: MIT
 *
 * A random building, compiled, to be looked at from random viewpoints: what tests of frames begin with. */
#ifndef TESTS_ROOM_STAGE_H
#define TESTS_ROOM_STAGE_H

#include "limner.h"
#include "room_scene.h"

struct room_stage {
    struct room_scene room;
    struct compiled scene;
    struct random random;
};

/* For cmocka: *state is a struct room_stage from here on, the same for the same seed. */
int room_stage_set_up(void **state, uint32_t seed);
int room_stage_tear_down(void **state);

/* From the next viewpoint, with a lens of 60 degrees for so many pixels. */
struct lim_camera room_stage_view(struct room_stage *stage, unsigned w_px, unsigned h_px);

#endif
