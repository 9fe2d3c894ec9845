/* SPDX-License-Identifier: MIT */
#include "walker.h"

#include "board.h"
#include "camera.h"
#include "eye.h"

#define TURN_STEP (UINT32_C(1) << 24)
enum { NEAR_STEPS = 4, BOARD_WALK = BOARD_UP | BOARD_DOWN | BOARD_LEFT | BOARD_RIGHT };

/* A step that would leave the renderer's range is not made. */
static void go(struct lim_camera *camera, int32_t step_q8)
{
    const int32_t x_q8 = camera->eye_q8[0] - lim_mul_q30(lim_sin_q30(camera->yaw), step_q8);
    const int32_t z_q8 = camera->eye_q8[2] - lim_mul_q30(lim_cos_q30(camera->yaw), step_q8);

    if (abs_s32(x_q8) >= LIM_EYE_MAX_Q8 || abs_s32(z_q8) >= LIM_EYE_MAX_Q8) return;
    camera->eye_q8[0] = x_q8;
    camera->eye_q8[2] = z_q8;
}

static void step(struct lim_camera *camera, uint8_t pressed)
{
    const int32_t step_q8 = camera->near_q8 / NEAR_STEPS;

    if (pressed & BOARD_LEFT) camera->yaw += TURN_STEP;
    if (pressed & BOARD_RIGHT) camera->yaw -= TURN_STEP;
    if (pressed & BOARD_UP) go(camera, step_q8);
    if (pressed & BOARD_DOWN) go(camera, -step_q8);
}

void walker_frame(struct walker *walker, uint8_t buttons, struct lim_camera *camera)
{
    walker->released = (uint8_t)(walker->released | ~(unsigned)buttons);
    const uint8_t pressed = buttons & walker->released;

    if (pressed & BOARD_SELECT) {
        walker->walking = false;
    } else if (pressed & BOARD_WALK) {
        if (!walker->walking) walker->camera = *camera;
        walker->walking = true;
        step(&walker->camera, pressed);
    }
    if (walker->walking) *camera = walker->camera;
}
