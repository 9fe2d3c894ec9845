/* SPDX-License-Identifier: MIT
 *
 * On which side of a node's plane is the eye? Decided exactly, in integers: a 32-bit test settles
 * nearly every case, a 64-bit one the rest. */
#ifndef LIM_EYE_H
#define LIM_EYE_H

#include "scene.h"

#define LIM_EYE_MAX_Q8 (INT32_C(1) << 28) /* |eye_q8| stays below: 64-bit plane values cannot overflow */

struct lim_eye {
    int32_t at_q8[3];    /* units */
    int16_t reduced[3];  /* floor(at / 2^shift), 16 bits whatever the distance */
    uint8_t shift;       /* 0 inside the 16-bit cube of the scene */
    int32_t large_slack; /* how far the filter of a LARGE plane can be off, in its own scale */
};

void lim_eye_set(struct lim_eye *eye, const int32_t at_q8[3]);

/* 1: in front of the node's plane, -1: behind it, 0: exactly on it. */
int8_t lim_eye_side(const struct lim_eye *eye, const struct lim_scene *scene, const LIM_FLASH struct lim_node *node);

#endif
