/* SPDX-License-Identifier: MIT
 *
 * Any bits as a camera, and as a field of view to make one with: refused or drawn. */
#include "fuzz_frame.h"
#include "fuzz_room.h"

#include <stdlib.h>

enum { SIDE_PX = 4 };

static const char *run(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};
    struct fuzz_frame frame = {.scene = &fuzz_room()->scene, .w_px = SIDE_PX, .h_px = SIDE_PX, .is_ordered = true};

    const uint8_t choice = fuzz_u8(&bytes);
    frame.camera = fuzz_camera_from(&bytes);
    if (bytes.left_b) {
        const uint32_t fov_y = fuzz_u32(&bytes);
        const uint16_t w_px = fuzz_u16(&bytes), h_px = fuzz_u16(&bytes);
        const struct lim_camera before = frame.camera;
        const int err = lim_camera_set_fov(&frame.camera, fov_y, w_px, h_px);
        const bool changed = frame.camera.tan_x_q28 != before.tan_x_q28 || frame.camera.tan_y_q28 != before.tan_y_q28;
        if (err && changed) return "a field of view was refused, and taken";
        if (!err && (frame.camera.tan_x_q28 < LIM_TAN_MIN_Q28 || frame.camera.tan_x_q28 > LIM_TAN_MAX_Q28 ||
                     frame.camera.tan_y_q28 < LIM_TAN_MIN_Q28 || frame.camera.tan_y_q28 > LIM_TAN_MAX_Q28))
            return "a field of view made an illegal camera";
    }
    return fuzz_draw(&frame, choice);
}

const struct fuzz_target fuzz_camera = {"camera", run, NULL};
