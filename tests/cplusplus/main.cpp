/* SPDX-License-Identifier: MIT
 *
 * A firmware whose main file is C++: it includes its scene's header, and no flag says which scene that is. It prints
 * each frame's number and hash as `limner render --write-hashes` does. Compiled freestanding, where main() has no
 * linkage of its own. */
#include "model.h"

#include "cameras.h"
#include "console.h"

#ifndef MEM_B
#define MEM_B MODEL_SCENE_MEM_B(CAMERAS_H_PX)
#endif

namespace
{

struct Screen {
    alignas(4) uint16_t line[CAMERAS_W_PX];
    uint64_t hash; /* FNV-1a of the bytes as the bus gets them */

    void put_byte(uint8_t byte) { hash = (hash ^ byte) * UINT64_C(0x100000001b3); }
};

lim renderer;
uint32_t mem[MEM_B / 4];
Screen screen;

void *lend(void *ctx, uint16_t)
{
    return static_cast<Screen *>(ctx)->line;
}

int done(void *ctx, uint16_t, uint16_t x_px, uint16_t n_px)
{
    Screen *to = static_cast<Screen *>(ctx);
    const uint8_t *bytes = reinterpret_cast<const uint8_t *>(to->line + x_px);

    for (uint16_t i = 0; i < 2 * n_px; i++)
        to->put_byte(bytes[i]);
    return 0;
}

void put_frame(uint8_t frame)
{
    char text[] = "0 0123456789abcdef\n";

    text[0] = static_cast<char>('0' + frame);
    for (uint8_t i = 0; i < 16; i++)
        text[17 - i] = "0123456789abcdef"[screen.hash >> 4 * i & 15];
    console_put(text);
}

int draw()
{
    lim_target target = lim_target();
    target.w_px = CAMERAS_W_PX;
    target.h_px = CAMERAS_H_PX;
    target.format = LIM_RGB565;
    target.method = MODEL_SCENE_METHOD;
    target.ctx = &screen;
    target.lend = lend;
    target.done = done;
    int err = lim_init(&renderer, &model_scene, &target, mem, sizeof mem);

    for (uint8_t frame = 0; frame < CAMERAS_COUNT && !err; frame++) {
        screen.hash = UINT64_C(0xcbf29ce484222325);
        err = lim_frame(&renderer, &cameras[frame]);
        if (!err) put_frame(frame);
    }
    return err;
}

} // namespace

extern "C" int main()
{
    return draw() != 0;
}
