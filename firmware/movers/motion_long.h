/* SPDX-License-Identifier: MIT
 *
 * Motion in a scene of many scales: whole units beside those that a key counts in 1/256 of a unit. */
#ifndef LIM_MOTION_LONG_H
#define LIM_MOTION_LONG_H

#include "scene.h"

/* Sets lim_instance.origin, and adds to at_q8 what is left of a unit: the part t of the way between two keys. */
void lim_motion_go_far(const struct lim_motion *motion, uint16_t from, uint16_t to, uint32_t t_q31,
                       struct lim_instance *instance);

#endif
