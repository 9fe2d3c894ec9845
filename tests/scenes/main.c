/* SPDX-License-Identifier: MIT
 *
 * Two scenes in one program, one after the other in one block of memory: prints each frame's number and hash
 * as `limner render --write-hashes` does. level.h has both scenes; each has its cameras, as many and for
 * the same screen. */
#include "limner.h"

#include "console.h"
#include "level.h"

#define cameras teapot_cameras
#include "teapot_cameras.h"
#undef cameras
#undef CAMERAS_H
#define cameras glass_cameras
#include "glass_cameras.h"
#undef cameras

static struct lim lim;
static uint32_t mem[LEVEL_SCENE_MEM_B(CAMERAS_H_PX) / 4];
static uint32_t line[(CAMERAS_W_PX + 1) / 2];

int main(void);

static void *lend(void *ctx, uint16_t y_px)
{
    (void)ctx;
    (void)y_px;
    return line;
}

/* FNV-1a, 64 bits, of the bytes as the bus gets them. */
static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    uint64_t *hash = ctx;
    const uint8_t *bytes = (const uint8_t *)line + 2 * x_px;

    (void)y_px;
    for (uint16_t i = 0; i < 2 * n_px; i++)
        *hash = (*hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return 0;
}

static void put_frame(uint16_t frame, uint64_t hash)
{
    char text[] = "0 0123456789abcdef\n";

    text[0] = (char)('0' + frame);
    for (uint8_t i = 0; i < 16; i++)
        text[2 + i] = "0123456789abcdef"[hash >> (60 - 4 * i) & 15];
    console_put(text);
}

static int render(const struct lim_scene *scene, enum lim_method method, const struct lim_camera *cameras)
{
    uint64_t hash;
    const struct lim_target target = {.w_px = CAMERAS_W_PX,
                                      .h_px = CAMERAS_H_PX,
                                      .format = LIM_RGB565,
                                      .method = method,
                                      .ctx = &hash,
                                      .lend = lend,
                                      .done = done};
    int err = lim_init(&lim, scene, &target, mem, sizeof mem);

    for (uint16_t frame = 0; frame < CAMERAS_COUNT && !err; frame++) {
        hash = UINT64_C(0xcbf29ce484222325);
        err = lim_frame(&lim, &cameras[frame]);
        if (!err) put_frame(frame, hash);
    }
    return err;
}

int main(void)
{
    int err = render(&level_teapot_scene, LEVEL_TEAPOT_SCENE_METHOD, teapot_cameras);

    if (!err) err = render(&level_glass_scene, LEVEL_GLASS_SCENE_METHOD, glass_cameras);
    if (!err) err = render(&level_teapot_scene, LEVEL_TEAPOT_SCENE_METHOD, teapot_cameras);
    return err != 0;
}
