/* SPDX-License-Identifier: MIT
 *
 * A convex solid, drawn by any method: where a target fails, at any of its calls, the frame ends and says why; and what
 * was in memory before lim_init() does not matter. */
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "rigs/cmocka_ready.h"
#include "rigs/convex_rig.h"
#include "rigs/profiles.h"

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

static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_PAINTER, LIM_CONVEX, LIM_SCANLINE, LIM_DEPTH};
enum { ORDERS = sizeof orders / sizeof *orders };

/* A frame, from memory full of `before`. */
static int draw(const struct compiled *scene, const struct core *core, enum lim_method method, struct failing *failing,
                int before)
{
    const struct lim_target target = {
        .w_px = W_PX, .h_px = H_PX, .format = LIM_RGB565, .method = method, .ctx = failing, .lend = lend, .done = done};
    const struct lim_camera camera = {
        .eye_q8 = {0, 0, 500 * 256}, .tan_x_q28 = 1 << 28, .tan_y_q28 = 1 << 28, .near_q8 = 256};
    const size_t mem_b = core->mem_b(&scene->scene, &target);
    void *lim = malloc(core->lim_b), *mem = malloc(mem_b);

    assert_true(lim && mem);
    memset(lim, before, core->lim_b);
    memset(mem, before, mem_b);
    assert_int_equal(core->init(lim, &scene->scene, &target, mem, mem_b), LIM_OK);
    const int code = core->frame(lim, &camera);
    free(lim);
    free(mem);
    return code;
}

/* Whether it came to the n-th call. */
static bool fail_at(const struct compiled *scene, const struct core *core, enum lim_method method, bool lends, int n)
{
    struct failing failing = {.fails_at = n, .lends_nothing = lends};
    const int code = draw(scene, core, method, &failing, 0);

    assert_int_equal(code, !failing.failed ? LIM_OK : lends ? LIM_ERR_TARGET : ERROR);
    assert_false(failing.goes_on);
    return failing.failed;
}

static void try_errors(const struct compiled *scene, const struct core *core, enum lim_method method)
{
    int lent = 0, sent = 0;

    while (fail_at(scene, core, method, true, lent))
        lent++;
    while (fail_at(scene, core, method, false, sent))
        sent++;
    assert_true(lent > 0 && sent >= H_PX);
}

static void try_memory(const struct compiled *scene, const struct core *core, enum lim_method method)
{
    static const int before[] = {1, 0xA5, 0xFF};
    struct failing clean = {.fails_at = -1};

    assert_int_equal(draw(scene, core, method, &clean, 0), LIM_OK);
    for (size_t i = 0; i < sizeof before / sizeof *before; i++) {
        struct failing used = {.fails_at = -1};
        assert_int_equal(draw(scene, core, method, &used, before[i]), LIM_OK);
        assert_int_equal(used.calls, clean.calls);
        assert_memory_equal(used.lines, clean.lines, sizeof clean.lines);
    }
}

typedef void trial(const struct compiled *scene, const struct core *core, enum lim_method method);

static void try_all(trial *one)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_or_sub_bits(found);
    struct random random = {801};
    struct mesh mesh = mesh_rig(200.0);

    convex_rig_add(&mesh, &random, 4);
    for (size_t k = 0; k < count; k++) {
        struct compiled scene;
        struct error err;
        const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .core = found[k]};
        if (!compile_mesh(&mesh, &options, &scene, &err)) fail_msg("%s", err.text);
        for (size_t i = 0; i < ORDERS; i++)
            one(&scene, found[k], orders[i]);
        compiled_free(&scene);
    }
    mesh_rig_free(&mesh);
}

static void an_error_ends_the_frame_and_comes_through(void **state)
{
    (void)state;
    try_all(try_errors);
}

static void what_was_in_memory_does_not_matter(void **state)
{
    (void)state;
    try_all(try_memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_error_ends_the_frame_and_comes_through),
        cmocka_unit_test(what_was_in_memory_does_not_matter),
    };

    return cmocka_run_group_tests_name("target_errors", tests, NULL, NULL);
}
