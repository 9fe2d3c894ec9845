/* SPDX-License-Identifier: MIT */
#include "fuzz_view.h"

#include "eye.h"
#include "fuzz_frame.h"

/* low .. high; most values of any size about as likely. */
static uint32_t scaled(struct fuzz_bytes *bytes, uint32_t value, uint32_t low, uint32_t high)
{
    return low + (value % (high - low + 1) >> fuzz_below(bytes, 32));
}

struct lim_camera fuzz_legal_camera(struct fuzz_bytes *bytes)
{
    struct lim_camera camera = fuzz_camera_from(bytes);
    const uint8_t near_by = fuzz_below(bytes, 24);

    for (int i = 0; i < 3; i++)
        camera.eye_q8[i] = camera.eye_q8[i] % LIM_EYE_MAX_Q8 / (1 << near_by);
    camera.tan_x_q28 = scaled(bytes, camera.tan_x_q28, LIM_TAN_MIN_Q28, LIM_TAN_MAX_Q28);
    camera.tan_y_q28 = scaled(bytes, camera.tan_y_q28, LIM_TAN_MIN_Q28, LIM_TAN_MAX_Q28);
    camera.near_q8 = (int32_t)scaled(bytes, (uint32_t)camera.near_q8, 1, LIM_NEAR_MAX_Q8);
    return camera;
}

/* With what eye_q8 may add, below LIM_LONG_EYE_END. */
#define ORIGIN_END (LIM_LONG_EYE_END - (INT32_C(1) << 20) - 1)

void fuzz_view_move_origin(struct lim_camera *camera, const struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    const bool is_near = fuzz_below(bytes, 4);
    const lim_index vertex = fuzz_below(bytes, made->scene.vertex_count);

    for (int i = 0; i < 3; i++) {
        const int32_t away = (int32_t)fuzz_u32(bytes) >> fuzz_below(bytes, 32);
        const int64_t at = is_near ? (int64_t)made->long_vertices[vertex].at[i] + away : away;
        camera->origin[i] = (int32_t)(at < -ORIGIN_END ? -ORIGIN_END : at > ORIGIN_END ? ORIGIN_END : at);
    }
}

void fuzz_view_from(struct fuzz_bytes *bytes, struct fuzz_subject *subject)
{
    struct lim_camera *const next = &subject->cameras[1];

    subject->w_px = (uint16_t)(1 + fuzz_below(bytes, FUZZ_PANEL_SIDE_PX));
    subject->h_px = (uint16_t)(1 + fuzz_below(bytes, FUZZ_PANEL_SIDE_PX));
    subject->cameras[0] = fuzz_legal_camera(bytes);
    *next = subject->cameras[0];
    switch (fuzz_below(bytes, 4)) {
    case 1:
        next->yaw += (uint32_t)fuzz_u16(bytes) << 12;
        break;
    case 2:
        next->eye_q8[0] = (next->eye_q8[0] + (int16_t)fuzz_u16(bytes)) % LIM_EYE_MAX_Q8;
        break;
    case 3:
        *next = fuzz_legal_camera(bytes);
        break;
    default:
        break;
    }
}
