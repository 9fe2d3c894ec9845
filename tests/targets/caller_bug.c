/* SPDX-License-Identifier: MIT
 *
 * A program with a bug of the kind that LIM_ASSERT is for: BUG says which. It prints "before", does it, and prints
 * "after" if it gets there. 0: none; 11: memory that begins at an odd place, which is a bug where words have to be
 * aligned; 12: a scene of another making, which claims less depth than its tree has. Exit status 0, or 1 when a call
 * fails that has no bug. */
#include "model.h"

#include "console.h"

enum { W_PX = 16, H_PX = 16 };

int main(void);

static struct lim lim;
static union {
    uint8_t bytes[MODEL_SCENE_MEM_B(H_PX) + 64];
    void *aligned;
} mem;
static uint32_t line[W_PX / 2];

static void *lend(void *ctx, uint16_t y_px)
{
    (void)ctx, (void)y_px;
    return line;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px, (void)x_px, (void)n_px;
    return 0;
}

#if BUG == 12
#define METHOD LIM_NEAREST_FIRST
#else
#define METHOD MODEL_SCENE_METHOD
#endif

static const struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = METHOD, .lend = lend, .done = done};
static const struct lim_camera camera = {
    .eye_q8 = {0, 0, INT32_C(1) << 22}, .tan_x_q28 = UINT32_C(1) << 28, .tan_y_q28 = UINT32_C(1) << 28, .near_q8 = 256};

/* Known at run time only, or the compiler would warn. */
static void *hidden(void *pointer)
{
    __asm__ volatile("" : "+r"(pointer));
    return pointer;
}

/* A sender without a function. */
static int send_nowhere(void)
{
    struct lim_sender sender = {NULL, NULL, (uint16_t *)(void *)line, sizeof line, 0};
    struct lim_target to;

    return lim_sender_target(hidden(&sender), W_PX, H_PX, LIM_NEAREST_FIRST, &to);
}

static int draw(void)
{
    struct lim *const it = hidden(BUG == 1 ? NULL : &lim);
    struct lim_scene shallow = model_scene;
    const struct lim_scene *const scene = hidden(BUG == 2 ? NULL : &shallow);
    const struct lim_target *const to = hidden(BUG == 3 ? NULL : (void *)&target);
    const struct lim_camera *const from = hidden(BUG == 6 ? NULL : (void *)&camera);
    void *const pools = BUG == 4 ? NULL : mem.bytes + (BUG == 5 ? 2 : BUG == 11);

    if (BUG == 13) return send_nowhere();
    if (BUG == 12) shallow.limits.depth = 2;
    if (BUG != 7) {
        const int err = lim_init(it, scene, to, hidden(pools), sizeof mem - 2);
        if (err) return err;
    }
#if LIM_HAS_ANTIALIAS
    if (BUG == 8 && lim_set_antialias(it, mem.bytes + 2, 0)) return 1;
#endif
#if LIM_HAS_DELTA
    if (BUG == 9 && lim_set_delta(it, mem.bytes + 2, 0)) return 1;
#endif
#if LIM_HAS_MOVERS
    const struct lim_movers_limits too_many = {LIM_INSTANCES_MAX + 1, 1, 0, 0};
    if (BUG == 10 && lim_movers_init(it, mem.bytes, 0, &too_many)) return 1;
#endif
    return lim_frame(it, from);
}

int main(void)
{
    console_put("before\n");
    if (draw()) return 1;
    console_put("after\n");
    return 0;
}
