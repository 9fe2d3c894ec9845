/* SPDX-License-Identifier: MIT
 *
 * The lens from an angle of view, in 64 bits: done once, not once a frame. */
#include "camera.h"

#include "target.h"

static bool in_range(uint64_t tan_q28)
{
    return tan_q28 >= LIM_TAN_MIN_Q28 && tan_q28 <= LIM_TAN_MAX_Q28;
}

int lim_camera_set_fov(struct lim_camera *camera, uint32_t fov_y, uint16_t w_px, uint16_t h_px)
{
    LIM_ASSERT(camera);
    if (fov_y >> 31 || !w_px || !h_px) return LIM_ERR_CAMERA;
    const uint32_t sine_q30 = (uint32_t)lim_sin_q30(fov_y / 2), cosine_q30 = (uint32_t)lim_cos_q30(fov_y / 2);
    const uint64_t tan_y_q28 = (((uint64_t)sine_q30 << 28) + cosine_q30 / 2) / cosine_q30;
    const uint64_t tan_x_q28 = (tan_y_q28 * w_px + h_px / 2) / h_px;
    if (!in_range(tan_x_q28) || !in_range(tan_y_q28)) return LIM_ERR_CAMERA;
    camera->tan_x_q28 = (uint32_t)tan_x_q28;
    camera->tan_y_q28 = (uint32_t)tan_y_q28;
    return LIM_OK;
}
