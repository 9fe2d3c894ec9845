/* SPDX-License-Identifier: MIT
 *
 * Draws a scene's first camera by the depth sort with as many comparisons as it wants, and with 1, 4, 16 ... of them,
 * between the marks of a frame. Prints a line a frame: the limit, the comparisons, the entries, and what was left in
 * all and for want of comparisons. Exit status 0, or 1 when a frame fails or leaves a pixel out. */
#include "app_scene.h"
#include "console.h"

enum { FRAMES = 8 };

static struct lim lim;
static void *mem[(MODEL_SCENE_MEM_B(CAMERAS_H_PX) + sizeof(void *) - 1) / sizeof(void *)];
static uint16_t line[CAMERAS_W_PX];
static uint32_t painted_px;

int main(void);

static void *lend(void *ctx, uint16_t y_px)
{
    (void)ctx, (void)y_px;
    return line;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px, (void)x_px;
    painted_px += n_px;
    return 0;
}

static void put(uint32_t number, const char *after)
{
    char digits[11];
    uint8_t at = sizeof digits - 1;

    digits[at] = 0;
    do
        digits[--at] = (char)('0' + number % 10);
    while (number /= 10);
    console_put(&digits[at]);
    console_put(after);
}

static int draw(uint16_t frame, uint32_t most)
{
    const struct lim_newell_options options = {.most = most};
    struct lim_camera camera;

    scene_camera(0, &camera);
    lim_newell_set(&lim, &options);
    painted_px = 0;
    frame_begin(frame);
    const int err = lim_frame(&lim, &camera);
    frame_end(frame);
    const struct lim_stats *stats = lim_stats(&lim);
    put(most, " ");
    put(stats->newell.comparisons, " ");
    put(stats->sorted, " ");
    put(stats->newell.forced, " ");
    put(stats->newell.forced_by[LIM_FORCED_EFFORT], "\n");
    return err || painted_px != (uint32_t)CAMERAS_W_PX * CAMERAS_H_PX;
}

int main(void)
{
    const struct lim_target target = {.w_px = CAMERAS_W_PX,
                                      .h_px = CAMERAS_H_PX,
                                      .format = LIM_RGB565,
                                      .method = SCENE_METHOD,
                                      .lend = lend,
                                      .done = done};
    int err = lim_init(&lim, &model_scene, &target, mem, sizeof mem);

    for (uint16_t frame = 0; frame < FRAMES && !err; frame++)
        err = draw(frame, frame ? UINT32_C(1) << 2 * (frame - 1) : 0);
    return err != 0;
}
