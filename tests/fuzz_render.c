/* SPDX-License-Identifier: MIT
 *
 * Any valid scene under any legal camera, in every profile, method and size of memory. */
#include "fuzz_frame.h"
#include "fuzz_scene.h"
#include "lim_check.h"

/* low .. high; most values of any size about as likely. */
static uint32_t scaled(struct fuzz_bytes *bytes, uint32_t value, uint32_t low, uint32_t high)
{
    return low + (value % (high - low + 1) >> fuzz_below(bytes, 32));
}

static struct lim_camera legal_camera(struct fuzz_bytes *bytes)
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

static const char *run(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};
    struct fuzz_frame frame = {.is_ordered = true};
    struct fuzz_scene made;
    struct error err;

    const uint8_t choice = fuzz_u8(&bytes);
    frame.w_px = (uint16_t)(1 + fuzz_below(&bytes, FUZZ_SIDE_MAX_PX));
    frame.h_px = (uint16_t)(1 + fuzz_below(&bytes, FUZZ_SIDE_MAX_PX));
    frame.camera = legal_camera(&bytes);
    fuzz_scene_make(&made, &bytes);
    frame.scene = &made.scene;
    if (!lim_check(frame.scene, &err)) return "a valid scene was refused";
    return fuzz_draw(&frame, choice);
}

const struct fuzz_target fuzz_render = {"render", run, NULL};
