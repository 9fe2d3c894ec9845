/* SPDX-License-Identifier: MIT */
#include "angle.h"
#include "display.h" /* yours: display_line() sends a piece of a line; 0, or a negative error */
#include "limner.h"
#include "teapot.h" /* the compiled scene */

#define M_Q8(metres) ((int32_t)((metres)*TEAPOT_UNITS_PER_M * 256))

static _Alignas(4) uint16_t line[240];            /* one line in RGB565, as the bus takes it */
static uint32_t mem[TEAPOT_SCENE_MEM_B(240) / 4]; /* with less the same frames take longer */
static struct lim lim;

static void *lend(void *ctx, uint16_t y_px)
{
    return y_px < 240 ? ctx : NULL;
}
static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    return display_line(y_px, x_px, (uint16_t *)ctx + x_px, n_px);
}
int main(void)
{
    struct lim_target target = {
        .w_px = 240, .h_px = 240, .method = TEAPOT_SCENE_METHOD, .ctx = line, .lend = lend, .done = done};
    struct lim_camera camera = {.eye_q8[1] = M_Q8(2.0), .pitch = 0 - LIM_ANGLE_QUARTER / 3, .near_q8 = M_Q8(0.1)};
    int err = lim_init(&lim, &teapot_scene, &target, mem, sizeof mem);
    if (!err) err = lim_camera_set_fov(&camera, LIM_ANGLE_QUARTER / 9 * 5, 240, 240);
    for (int frame = 0; !err && frame < 3; frame++, camera.yaw += LIM_ANGLE_QUARTER / 3) {
        camera.eye_q8[0] = (int32_t)((int64_t)lim_sin_q30(camera.yaw) * M_Q8(3.9) >> 30);
        camera.eye_q8[2] = (int32_t)((int64_t)lim_cos_q30(camera.yaw) * M_Q8(3.9) >> 30);
        err = lim_frame(&lim, &camera);
    }
    return err != 0;
}
