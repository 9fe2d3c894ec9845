/* SPDX-License-Identifier: MIT
 *
 * Draws an exported scene, `limner export -o DIR/model`, from every camera of cameras.h by the one function that a
 * newcomer writes, and prints each frame's number and hash as `limner render --write-hashes` does. Pixels must come
 * from left to right and from the top down, each once. Exit status 1: the renderer failed, or they did not. */
#include "model.h"

#include "cameras.h"
#include "console.h"

#define FNV_OFFSET UINT64_C(0xcbf29ce484222325)
#define FNV_PRIME UINT64_C(0x100000001b3)

#ifndef TIME_MS
#define TIME_MS(frame) (((frame)*UINT32_C(1000) + 7) / 15) /* as the simulator places what moves */
#endif

MODEL_MEMORY(CAMERAS_W_PX, CAMERAS_H_PX);

struct drawn {
    uint64_t hash;
    uint32_t px;
};

int main(void);

static int take(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    struct drawn *drawn = (struct drawn *)ctx;
    const uint8_t *bytes = (const uint8_t *)pixels;

    if (drawn->px != (uint32_t)y_px * CAMERAS_W_PX + x_px || x_px + n_px > CAMERAS_W_PX) return -1;
    for (uint32_t i = 0; i < 2u * n_px; i++)
        drawn->hash = (drawn->hash ^ bytes[i]) * FNV_PRIME;
    drawn->px += n_px;
    return 0;
}

static void put(uint16_t frame, uint64_t hash)
{
    char line[] = "     0123456789abcdef\n";
    uint8_t at = 4; /* behind the last digit */

    for (uint8_t i = 0; i < 16; i++)
        line[5 + i] = "0123456789abcdef"[hash >> (60 - 4 * i) & 15u];
    do
        line[--at] = (char)('0' + frame % 10);
    while (frame /= 10);
    console_put(line + at);
}

static int draw(uint16_t frame, const struct lim_camera *camera)
{
#ifdef MODEL_MOVERS
    static struct lim_instance instances[MODEL_MOVERS];
    lim_moved_at(model_movers, MODEL_MOVERS, TIME_MS(frame), instances);
    return lim_movers_frame(model_memory.lim, camera, instances, MODEL_MOVERS);
#else
    (void)frame;
    return lim_frame(model_memory.lim, camera);
#endif
}

int main(void)
{
    struct drawn drawn;
    int err = model_begin(&model_memory, take, &drawn);

    for (uint16_t frame = 0; !err && frame < CAMERAS_COUNT; frame++) {
        const struct lim_camera camera = cameras[frame];
        drawn.hash = FNV_OFFSET;
        drawn.px = 0;
        err = draw(frame, &camera);
        if (drawn.px != (uint32_t)CAMERAS_W_PX * CAMERAS_H_PX) err = err ? err : -1;
        put(frame, drawn.hash);
    }
    return err != 0;
}
