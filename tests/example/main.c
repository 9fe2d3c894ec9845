/* SPDX-License-Identifier: MIT
 *
 * The renderer in one's own firmware: everything there is to it. Compiled with the scene's header
 * as configuration (-DLIM_CONFIG='"teapot.h"'). The display is yours: display_line() here stands
 * for whatever sends a line of pixels to it. */
#include "limner.h"

#include "display.h"
#include "teapot.h"

enum { W_PX = 240, H_PX = 240, FRAMES = 3 };

/* One line of pixels, lent to the renderer and sent when it comes back. */
static uint32_t line[W_PX / 2];

static void *lend(void *ctx, uint16_t y_px)
{
    (void)ctx;
    (void)y_px;
    return line;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx;
    return display_line(y_px, x_px, (const uint16_t *)(const void *)line + x_px, n_px);
}

/* All of the renderer's memory; the linker says if it does not fit. */
static struct lim lim;
static uint32_t mem[TEAPOT_SCENE_MEM_B(H_PX) / 4];

int main(void)
{
    const struct lim_target target = {W_PX, H_PX, LIM_RGB565, LIM_NEAREST_FIRST, NULL, lend, done};
    struct lim_camera camera = {.near_q8 = 256 * 16};
    int err = lim_init(&lim, &teapot_scene, &target, mem, sizeof mem);

    if (!err) err = lim_camera_set_fov(&camera, (uint32_t)(UINT64_C(60) * 4294967296 / 360), W_PX, H_PX);
    camera.eye_q8[1] = INT32_C(8000) * 256;
    camera.eye_q8[2] = INT32_C(70000) * 256;
    for (int frame = 0; frame < FRAMES && !err; frame++) {
        camera.yaw = (uint32_t)frame * UINT32_C(0x01000000); /* 1.4 degrees a frame */
        err = lim_frame(&lim, &camera);
    }
    return err != 0;
}
