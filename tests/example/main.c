/* SPDX-License-Identifier: MIT
 *
 * The renderer in one's own firmware: everything there is to it. Compiled for the scene and the
 * display (-DLIM_CONFIG='"teapot.h"' -DLIM_MAX_SIDE_PX=240). The display is yours: display_line()
 * here stands for whatever sends a line of pixels to it. */
#include "limner.h"

#include "angle.h"
#include "display.h"
#include "teapot.h"

/* What the scene asks for. With less, down to lim_mem_min_b(), the same frames take longer. */
#ifndef MEM_B
#define MEM_B TEAPOT_SCENE_MEM_B(DISPLAY_H_PX)
#endif

/* Both are constants once compiled: no floating point is left at run time. */
#define UNITS(metres) ((int32_t)((metres)*TEAPOT_UNITS_PER_M))
#define DEGREES(angle) ((uint32_t)((angle)*UINT64_C(4294967296) / 360)) /* a full turn is 2^32 */

enum { FRAMES = 3 };

/* One line of pixels, lent to the renderer and sent when it comes back. */
static _Alignas(4) uint16_t line[DISPLAY_W_PX];

/* All of the renderer's memory; the linker says if it does not fit. */
static struct lim lim;
static uint32_t mem[MEM_B / 4];

static void *lend(void *ctx, uint16_t y_px)
{
    (void)ctx;
    (void)y_px;
    return line;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx;
    return display_line(y_px, x_px, line + x_px, n_px);
}

/* Puts the eye on a circle around the model, looking at it from above. */
static void orbit(struct lim_camera *camera, uint32_t angle)
{
    camera->eye_q8[0] = (int32_t)((int64_t)lim_sin_q30(angle) * UNITS(3.9) >> 22);
    camera->eye_q8[1] = UNITS(2.0) * 256;
    camera->eye_q8[2] = (int32_t)((int64_t)lim_cos_q30(angle) * UNITS(3.9) >> 22);
    camera->yaw = angle;
    camera->pitch = 0 - DEGREES(28);
}

int main(void)
{
    const struct lim_target target = {.w_px = DISPLAY_W_PX,
                                      .h_px = DISPLAY_H_PX,
                                      .format = LIM_RGB565,
                                      .method = TEAPOT_SCENE_METHOD,
                                      .ctx = NULL,
                                      .lend = lend,
                                      .done = done};
    struct lim_camera camera = {.near_q8 = UNITS(0.1) * 256};
    int err = lim_init(&lim, &teapot_scene, &target, mem, sizeof mem);

    if (!err) err = lim_camera_set_fov(&camera, DEGREES(52), DISPLAY_W_PX, DISPLAY_H_PX);
    for (uint32_t frame = 0; frame < FRAMES && !err; frame++) {
        orbit(&camera, DEGREES(15) + frame * DEGREES(30));
        err = lim_frame(&lim, &camera);
    }
    return err != 0;
}
