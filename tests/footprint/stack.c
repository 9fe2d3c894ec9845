/* SPDX-License-Identifier: MIT
 *
 * Prints how much stack lim_init() and lim_frame() really use, over a list of cameras: what lies below the
 * stack pointer is painted beforehand, and the lowest word that changed counts. For Cortex-M only; the
 * target's own functions use no stack. Compiled for a scene (model.h) and its cameras (cameras.h). */
#include "limner.h"

#include "cameras.h"
#include "console.h"
#include "model.h"

enum { PAINTED_WORDS = 4096 };
#define PAINT UINT32_C(0xA5C35A3C)

static struct lim lim;
static uint32_t mem[MODEL_SCENE_MEM_B(CAMERAS_H_PX) / 4];
static uint32_t line[(CAMERAS_W_PX + 1) / 2];

int main(void);

static void *lend(void *ctx, uint16_t y_px)
{
    (void)ctx;
    (void)y_px;
    return line;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx;
    (void)y_px;
    (void)x_px;
    (void)n_px;
    return 0;
}

static inline volatile uint32_t *stack_pointer(void)
{
    volatile uint32_t *pointer;

    __asm__ volatile("mov %0, sp" : "=r"(pointer));
    return pointer;
}

static void put_decimal(uint32_t number)
{
    char digits[12] = {0};
    uint8_t at = sizeof digits - 1;

    do
        digits[--at] = (char)('0' + number % 10);
    while (number /= 10);
    console_put(&digits[at]);
    console_put("\n");
}

/* Both in one function each, so that what is called begins right at the painted words. */
__attribute__((noinline)) static uint32_t init_stack_b(const struct lim_target *target, int *err)
{
    volatile uint32_t *const top = stack_pointer(), *at = top - PAINTED_WORDS;

    for (volatile uint32_t *word = at; word < top; word++)
        *word = PAINT;
    *err = lim_init(&lim, &model_scene, target, mem, sizeof mem);
    while (at < top && *at == PAINT)
        at++;
    return (uint32_t)(top - at) * 4;
}

__attribute__((noinline)) static uint32_t frame_stack_b(const struct lim_camera *camera, int *err)
{
    volatile uint32_t *const top = stack_pointer(), *at = top - PAINTED_WORDS;

    for (volatile uint32_t *word = at; word < top; word++)
        *word = PAINT;
    *err = lim_frame(&lim, camera);
    while (at < top && *at == PAINT)
        at++;
    return (uint32_t)(top - at) * 4;
}

int main(void)
{
    const struct lim_target target = {.w_px = CAMERAS_W_PX,
                                      .h_px = CAMERAS_H_PX,
                                      .format = LIM_RGB565,
                                      .method = MODEL_SCENE_METHOD,
                                      .ctx = NULL,
                                      .lend = lend,
                                      .done = done};
    int err;
    uint32_t worst_b = init_stack_b(&target, &err);

    for (uint16_t i = 0; i < CAMERAS_COUNT && !err; i++) {
        const uint32_t used_b = frame_stack_b(&cameras[i], &err);
        if (used_b > worst_b) worst_b = used_b;
    }
    put_decimal(worst_b);
    return err != 0;
}
