/* SPDX-License-Identifier: MIT
 *
 * A program as newcomers write it: NAME_MEMORY, name_begin(), and a function that pixels are sent to. It prints each
 * frame's number and hash as `limner render --write-hashes` does. C11, and C++11 as well. With SECOND, a header of two
 * scenes, which are drawn in turns in the memory that they share. Exit status 0, or 1 when something failed, or pixels
 * did not come from left to right and from the top down, each once. */
#include "model.h"

#include "cameras.h"
#include "console.h"
#ifdef SECOND
#include "second_cameras.h"
#endif

#ifdef __cplusplus
extern "C" int main(void);
#else
int main(void);
#endif

#ifdef MEM_B
LIM_MEMORY(model_memory, CAMERAS_W_PX, CAMERAS_H_PX, MEM_B, 0, MODEL_SCENE_LINES(CAMERAS_H_PX));
#else
MODEL_MEMORY(CAMERAS_W_PX, CAMERAS_H_PX);
#endif

struct screen {
    uint64_t hash; /* FNV-1a of the bytes as the bus gets them */
    uint32_t next_px;
};

static struct screen screen;

static int put(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    struct screen *to = (struct screen *)ctx;
    const uint8_t *bytes = (const uint8_t *)pixels;

    if (to->next_px != (uint32_t)y_px * CAMERAS_W_PX + x_px || x_px + n_px > CAMERAS_W_PX) return -1;
    to->next_px += n_px;
    for (uint16_t i = 0; i < 2 * n_px; i++)
        to->hash = (to->hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return 0;
}

static void put_frame(uint8_t frame)
{
    char text[] = "0 0123456789abcdef\n";

    text[0] = (char)('0' + frame);
    for (uint8_t i = 0; i < 16; i++)
        text[17 - i] = "0123456789abcdef"[screen.hash >> 4 * i & 15];
    console_put(text);
}

#ifdef MODEL_MOVERS
static int draw(uint8_t frame, const struct lim_camera *camera)
{
    static struct lim_instance instances[MODEL_MOVERS];

    lim_moved_at(model_movers, MODEL_MOVERS, (frame * UINT32_C(1000) + FRAMES_PER_S / 2) / FRAMES_PER_S, instances);
    return lim_movers_frame(model_memory.lim, camera, instances, MODEL_MOVERS);
}
#else
static int draw(uint8_t frame, const struct lim_camera *camera)
{
    (void)frame;
    return lim_frame(model_memory.lim, camera);
}
#endif

#ifdef SECOND
static int begin(uint8_t frame, struct lim_camera *camera)
{
    const bool second = frame % 2 == 1;

    *camera = (second ? second_cameras : cameras)[frame];
    return second ? model_second_begin(&model_memory, put, &screen) : model_first_begin(&model_memory, put, &screen);
}
#else
static int begin(uint8_t frame, struct lim_camera *camera)
{
    *camera = cameras[frame];
    return frame ? 0 : model_begin(&model_memory, put, &screen);
}
#endif

int main(void)
{
    for (uint8_t frame = 0; frame < CAMERAS_COUNT; frame++) {
        struct lim_camera camera;
        screen.hash = UINT64_C(0xcbf29ce484222325);
        screen.next_px = 0;
        if (begin(frame, &camera) || draw(frame, &camera)) return 1;
        if (screen.next_px != UINT32_C(1) * CAMERAS_W_PX * CAMERAS_H_PX) return 1;
        put_frame(frame);
    }
    return 0;
}
