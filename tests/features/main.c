/* SPDX-License-Identifier: MIT
 *
 * Renders a list of cameras by every method that this build has, into a framebuffer, and prints each
 * frame's number and hash as `limner render --write-hashes` does, method by method. Compiled for a scene
 * (model.h), its cameras (cameras.h) and a choice of features. */
#include "limner.h"

#include "cameras.h"
#include "model.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

enum { LINE_PX = (CAMERAS_W_PX + 1) / 2 * 2 };

static void *lend(void *ctx, uint16_t y_px)
{
    uint16_t *frame = ctx;
    return frame + (size_t)y_px * LINE_PX;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx;
    return y_px < CAMERAS_H_PX && x_px + n_px <= CAMERAS_W_PX ? 0 : -1;
}

/* FNV-1a, 64 bits, of the bytes as the bus gets them. */
static uint64_t hash_of(const uint16_t *frame)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t y = 0; y < CAMERAS_H_PX; y++) {
        const uint8_t *bytes = (const uint8_t *)(frame + y * LINE_PX);
        for (size_t i = 0; i < 2 * CAMERAS_W_PX; i++)
            hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    }
    return hash;
}

/* In parts, a quantum at a time, if there are such: then a frame that is drawn at once is made of them as well. */
static int draw(struct lim *lim, const struct lim_camera *camera, bool in_parts)
{
#if LIM_HAS_STREAM
    if (in_parts) {
        const int err = lim_frame_begin(lim, camera);
        while (!err && lim_frame_work(lim))
            continue;
        return err ? err : lim_frame_paint(lim);
    }
#endif
    (void)in_parts;
    return lim_frame(lim, camera);
}

static int render(enum lim_method method, bool in_parts)
{
    static uint32_t frame[CAMERAS_H_PX * LINE_PX / 2];
    static struct lim lim;
    const struct lim_target target = {.w_px = CAMERAS_W_PX,
                                      .h_px = CAMERAS_H_PX,
                                      .format = LIM_RGB565,
                                      .method = method,
                                      .ctx = frame,
                                      .lend = lend,
                                      .done = done};
    const size_t mem_b = lim_mem_b(&model_scene, &target);
    void *mem = malloc(mem_b);
    int err = mem ? lim_init(&lim, &model_scene, &target, mem, mem_b) : LIM_ERR_MEMORY;
    for (size_t i = 0; i < CAMERAS_COUNT && !err; i++) {
        err = draw(&lim, &cameras[i], in_parts);
        if (!err) printf("%zu %016" PRIx64 "\n", i, hash_of((const uint16_t *)frame));
    }
    if (!LIM_HAS_STATS && lim_stats(&lim)->pixels_painted) err = -1;
    free(mem);
    return err;
}

int main(void)
{
    int err = 0;
    for (int in_parts = 0; in_parts <= LIM_HAS_STREAM; in_parts++) {
        if (!err && LIM_HAS_NEAREST) err = render(LIM_NEAREST_FIRST, in_parts);
        if (!err && LIM_HAS_SCANLINE) err = render(LIM_SCANLINE, in_parts);
    }
    if (!err && LIM_HAS_PAINTER) err = render(LIM_PAINTER, false);
    if (!err && LIM_HAS_CONVEX && MODEL_SCENE_METHOD == LIM_CONVEX) err = render(LIM_CONVEX, false);
    if (err) fprintf(stderr, "error %d\n", err);
    return err ? EXIT_FAILURE : EXIT_SUCCESS;
}
