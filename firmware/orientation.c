/* SPDX-License-Identifier: MIT
 *
 * Yaw about the upright axis, then pitch, then roll about the axis of view: the product of three
 * rotations, written out. */
#include "orientation.h"

#include "angle.h"
#include "fixed.h"

void lim_orientation_set(struct lim_orientation *orientation, const struct lim_camera *camera)
{
    const int32_t sin_yaw = lim_sin_q30(camera->yaw), cos_yaw = lim_cos_q30(camera->yaw);
    const int32_t sin_pitch = lim_sin_q30(camera->pitch), cos_pitch = lim_cos_q30(camera->pitch);
    const int32_t sin_roll = lim_sin_q30(camera->roll), cos_roll = lim_cos_q30(camera->roll);
    const int32_t level_right[3] = {cos_yaw, 0, -sin_yaw};
    const int32_t level_up[3] = {mul_q30(sin_yaw, sin_pitch), cos_pitch, mul_q30(cos_yaw, sin_pitch)};

    orientation->ahead_q30[0] = -mul_q30(sin_yaw, cos_pitch);
    orientation->ahead_q30[1] = sin_pitch;
    orientation->ahead_q30[2] = -mul_q30(cos_yaw, cos_pitch);
    for (uint8_t i = 0; i < 3; i++) {
        orientation->right_q30[i] = mul_q30(level_right[i], cos_roll) - mul_q30(level_up[i], sin_roll);
        orientation->down_q30[i] = -(mul_q30(level_up[i], cos_roll) + mul_q30(level_right[i], sin_roll));
    }
}
