/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include "math/orientation.h"

#if LIM_HAS_MOVERS

void lim_instance_turn(struct lim_instance *instance, uint32_t yaw, uint32_t pitch, uint32_t roll)
{
    LIM_ASSERT(instance);
    const struct lim_camera turned = {.yaw = yaw, .pitch = pitch, .roll = roll};

    lim_orientation_set(instance->axes_q30, &turned); /* to the right, down, ahead: x, -y, -z */
    for (uint_fast8_t i = 3; i < 9; i++)
        instance->axes_q30[i] = -instance->axes_q30[i];
}

#endif
