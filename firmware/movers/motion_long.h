/* SPDX-License-Identifier: MIT
 *
 * Motion in a scene of many scales: whole units beside those that a key counts in 1/256 of a unit. */
#ifndef LIM_MOTION_LONG_H
#define LIM_MOTION_LONG_H

#include "scene.h"

/* Sets lim_instance.origin, and adds to at_q8 what is left of a unit: the part t of the way between two keys. */
/*@ requires \valid_read(motion) && \valid(instance) && t_q31 <= 2147483648;
    assigns instance->at_q8[0 .. 2], instance->origin[0 .. 2]; */
void lim_motion_go_far(const struct lim_motion *motion, uint16_t from, uint16_t to, uint32_t t_q31,
                       struct lim_instance *instance);

#endif
