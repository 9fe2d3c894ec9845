/* SPDX-License-Identifier: MIT
 *
 * A target that fails while a convex solid is drawn, at any of its calls and by any method: the frame ends there, and
 * says why. */
#include "cmocka_ready.h"
#include "convex_rig.h"
#include "profiles.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 32, H_PX = 24, ERROR = -4711 };

struct failing {
    uint16_t lines[H_PX][W_PX];
    int calls, fails_at;
    bool lends_nothing, failed, goes_on; /* goes_on: it was called once more after that */
};

static bool fails(struct failing *failing, bool lends)
{
    failing->goes_on |= failing->failed;
    if (lends != failing->lends_nothing || failing->calls++ != failing->fails_at) return false;
    failing->failed = true;
    return true;
}

static void *lend(void *ctx, uint16_t y_px)
{
    struct failing *failing = ctx;

    return fails(failing, true) ? NULL : failing->lines[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)y_px, (void)x_px, (void)n_px;
    return fails(ctx, false) ? ERROR : 0;
}

/* Whether it came to the n-th call. */
static bool fail_at(const struct compiled *scene, const struct core *core, enum lim_method method, bool lends, int n)
{
    struct failing failing = {.fails_at = n, .lends_nothing = lends};
    const struct lim_target target = {.w_px = W_PX,
                                      .h_px = H_PX,
                                      .format = LIM_RGB565,
                                      .method = method,
                                      .ctx = &failing,
                                      .lend = lend,
                                      .done = done};
    const struct lim_camera camera = {
        .eye_q8 = {0, 0, 500 * 256}, .tan_x_q28 = 1 << 28, .tan_y_q28 = 1 << 28, .near_q8 = 256};
    const size_t mem_b = core->mem_b(&scene->scene, &target);
    void *lim = calloc(1, core->lim_b), *mem = malloc(mem_b);

    assert_true(lim && mem);
    assert_int_equal(core->init(lim, &scene->scene, &target, mem, mem_b), LIM_OK);
    const int code = core->frame(lim, &camera);
    assert_int_equal(code, !failing.failed ? LIM_OK : lends ? LIM_ERR_TARGET : ERROR);
    assert_false(failing.goes_on);
    free(lim);
    free(mem);
    return failing.failed;
}

static void an_error_ends_the_frame_and_comes_through(void **state)
{
    static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_PAINTER, LIM_CONVEX, LIM_SCANLINE, LIM_DEPTH};
    struct random random = {801};
    struct mesh mesh = mesh_rig(200.0);

    (void)state;
    convex_rig_add(&mesh, &random, 4);
    for (size_t k = 0; cores[k]; k++) {
        struct compiled scene;
        struct error err;
        const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .core = cores[k]};
        if (!compile_mesh(&mesh, &options, &scene, &err)) fail_msg("%s", err.text);
        for (size_t i = 0; i < sizeof orders / sizeof *orders; i++) {
            int lent = 0, sent = 0;
            while (fail_at(&scene, cores[k], orders[i], true, lent))
                lent++;
            while (fail_at(&scene, cores[k], orders[i], false, sent))
                sent++;
            assert_true(lent > 0 && sent >= H_PX);
        }
        compiled_free(&scene);
    }
    mesh_rig_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(an_error_ends_the_frame_and_comes_through)};

    return cmocka_run_group_tests_name("target_errors", tests, NULL, NULL);
}
