/* SPDX-License-Identifier: MIT
 *
 * Keyframed rigid motion: a table in flash, written by `limner compile` from a model's animations. Between two keys a
 * position moves along a straight line, an orientation turns about one axis, both evenly. */
#ifndef LIM_MOTION_H
#define LIM_MOTION_H

#include "instance.h"

LIM_C_BEGIN

struct lim_motion_key {
    uint32_t time_ms;    /* ascending */
    int32_t at_q8[3];    /* units of the static scene */
    int16_t turn_q15[4]; /* a quaternion x, y, z, w of length 1, within rounding */
    uint16_t arc;        /* half the angle to the next key's orientation; a full turn is 2^16, this below 2^14 */
};

struct lim_motion {
    const LIM_FLASH struct lim_motion_key *keys;
    uint16_t count; /* at least 1 */
    bool repeats;   /* after the last key comes the first; else the last one stays */
};

/* An object of a compiled model, and how its animation moves it. */
struct lim_moved {
    const struct lim_scene *object;
    struct lim_motion motion;
    uint8_t finer_bits; /* lim_instance.finer_bits */
};

/* Sets an instance for each of `count` objects as they are at a time. by_centre stays as it is. */
void lim_moved_at(const struct lim_moved *moved, uint16_t count, uint32_t time_ms, struct lim_instance *instances);

/* Sets where the instance is, and its axes: within 2^-14 of a unit vector, no component beyond -1..1. Before its first
 * key a motion is there already. Keys that break the bounds above give other places and axes that are no rotation, and
 * still nothing overflows. */
/*@ requires \valid_read(motion) && motion->count >= 1 && \valid_read(motion->keys + (0 .. motion->count - 1));
    requires \valid(instance) && \separated(instance, motion);
    requires \separated(instance, motion->keys + (0 .. motion->count - 1));
    assigns instance->at_q8[0 .. 2], instance->axes_q30[0 .. 8];
    ensures \forall integer i; 0 <= i < 9 ==> -1073741824 <= instance->axes_q30[i] <= 1073741824; */
void lim_motion_at(const struct lim_motion *motion, uint32_t time_ms, struct lim_instance *instance);

LIM_C_END

#endif
