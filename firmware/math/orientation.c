/* SPDX-License-Identifier: MIT
 *
 * Yaw about the upright axis, then pitch, then roll about the axis of view: each turns two of the axes in
 * their plane. */
#include "math/orientation.h"

#include "camera.h"
#include "math/fixed.h"

/* Turns a away from b, and b towards a. */
static LIM_RARE void rotate(int32_t a_q30[3], int32_t b_q30[3], uint32_t angle)
{
    const int32_t sine_q30 = lim_sin_q30(angle), cosine_q30 = lim_cos_q30(angle);

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t was_a_q30 = a_q30[i], was_b_q30 = b_q30[i];
        a_q30[i] = lim_mul_q30(was_a_q30, cosine_q30) - lim_mul_q30(was_b_q30, sine_q30);
        b_q30[i] = lim_mul_q30(was_b_q30, cosine_q30) + lim_mul_q30(was_a_q30, sine_q30);
    }
}

void lim_orientation_set(int32_t axes_q30[9], const struct lim_camera *camera)
{
    int32_t *right_q30 = axes_q30, *down_q30 = axes_q30 + 3, *ahead_q30 = axes_q30 + 6;

    for (uint_fast8_t i = 0; i < 9; i++)
        axes_q30[i] = 0;
    right_q30[0] = INT32_C(1) << 30;
    down_q30[1] = ahead_q30[2] = -(INT32_C(1) << 30);
    rotate(ahead_q30, right_q30, camera->yaw);
    rotate(ahead_q30, down_q30, camera->pitch);
    rotate(down_q30, right_q30, camera->roll);
}
