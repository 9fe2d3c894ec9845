/* SPDX-License-Identifier: MIT */
#include "display.h" /* yours: display_send() sends a piece of a line; 0, or a negative error */
#include "teapot.h"  /* the compiled scene */

TEAPOT_MEMORY(240, 240); /* teapot_memory: the renderer, what it works in, and a line of pixels */
static struct lim_camera camera;

int main(void)
{
    static const int32_t target_q8[3] = TEAPOT_POINT_Q8(0, 0, 0);
    int err = teapot_begin(&teapot_memory, display_send, NULL);
    if (!err) err = lim_camera_set_fov(&camera, LIM_DEGREES(50), 240, 240);
    camera.near_q8 = TEAPOT_M_Q8(0.1);
    for (uint32_t frame = 0; !err && frame < 3; frame++) {
        lim_orbit(&camera, target_q8, TEAPOT_M_Q8(4.5), frame * LIM_DEGREES(30), LIM_DEGREES(-30));
        err = lim_frame(teapot_memory.lim, &camera);
    }
    return err != 0;
}
