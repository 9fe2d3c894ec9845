/* SPDX-License-Identifier: MIT
 *
 * A convex solid, drawn by any method: where a target fails, at any of its calls, the frame ends and says why; and what
 * was in memory before lim_init() does not matter. */
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "rigs/cmocka_ready.h"
#include "rigs/convex_rig.h"
#include "rigs/profiles.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 32, H_PX = 24, RUNS = 400 };

/* What a target's functions may return, and what lim_frame() makes of it. */
static const struct {
    int returned, comes_back;
} answers[] = {{-4711, -4711},           {-1, -1},
               {INT_MIN, INT_MIN},       {1, LIM_ERR_ANSWER},
               {2, LIM_ERR_ANSWER},      {5, LIM_ERR_ANSWER},
               {INT_MAX, LIM_ERR_ANSWER}};

enum stage_set { PLAIN, ANTIALIASED, DELTA, STAGES };

struct failing {
    uint16_t lines[H_PX][W_PX];
    int calls, fails_at, answer;
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
    struct failing *failing = ctx;

    (void)y_px, (void)x_px, (void)n_px;
    return fails(failing, false) ? failing->answer : 0;
}

static int window(void *ctx, const struct lim_rect *rect)
{
    (void)rect;
    return done(ctx, 0, 0, 0);
}

static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_PAINTER, LIM_CONVEX,
                                         LIM_SCANLINE,      LIM_DEPTH,   LIM_NEWELL};
static const enum lim_method mesh_orders[] = {LIM_MESH, LIM_MESH_DEPTH};

/* A renderer and all its memory. */
struct drawing {
    void *lim, *mem, *more;
};

static bool can(enum lim_method method, enum stage_set set)
{
    const bool is_mesh = method == LIM_MESH || method == LIM_MESH_DEPTH;
    return set == PLAIN || (!is_mesh && method != LIM_CONVEX && (set == DELTA || method != LIM_PAINTER));
}

/* From memory full of `before`. */
static struct drawing begin(const struct compiled *scene, const struct core *core, enum lim_method method,
                            enum stage_set set, struct failing *failing, int before)
{
    const struct lim_target target = {.w_px = W_PX,
                                      .h_px = H_PX,
                                      .format = LIM_RGB565,
                                      .method = method,
                                      .ctx = failing,
                                      .lend = lend,
                                      .done = done,
                                      .window = window,
                                      .costs = {.window_b = 5, .pixel_bits = 16, .page_px = 1, .x_align_px = 1}};
    const size_t mem_b = core->mem_b(&scene->scene, &target);
    const size_t more_b = set == DELTA ? LIM_DELTA_MEM_B(W_PX, H_PX, RUNS) : LIM_ANTIALIAS_MEM_B(W_PX);
    struct drawing drawing = {malloc(core->lim_b), malloc(mem_b), malloc(more_b)};

    assert_true(drawing.lim && drawing.mem && drawing.more);
    memset(drawing.lim, before, core->lim_b);
    memset(drawing.mem, before, mem_b);
    memset(drawing.more, before, more_b);
    assert_int_equal(core->init(drawing.lim, &scene->scene, &target, drawing.mem, mem_b), LIM_OK);
    if (set == ANTIALIASED) assert_int_equal(core->set_antialias(drawing.lim, drawing.more, more_b), LIM_OK);
    if (set == DELTA) assert_int_equal(core->set_delta(drawing.lim, drawing.more, more_b), LIM_OK);
    return drawing;
}

static int frame(const struct core *core, const struct drawing *drawing)
{
    const struct lim_camera camera = {
        .eye_q8 = {0, 0, 500 * 256}, .tan_x_q28 = 1 << 28, .tan_y_q28 = 1 << 28, .near_q8 = 256};

    return core->frame(drawing->lim, &camera);
}

static void end(struct drawing *drawing)
{
    free(drawing->lim);
    free(drawing->mem);
    free(drawing->more);
}

static int draw(const struct compiled *scene, const struct core *core, enum lim_method method, struct failing *failing,
                int before)
{
    struct drawing drawing = begin(scene, core, method, PLAIN, failing, before);
    const int code = frame(core, &drawing);

    end(&drawing);
    return code;
}

struct trouble {
    const struct compiled *scene;
    const struct core *core;
    enum lim_method method;
    enum stage_set set;
    const struct failing *golden; /* a frame without trouble */
};

/* Whether it came to the n-th call. The next frame is whole again. */
static bool fail_at(const struct trouble *trouble, bool lends, size_t answer, int n)
{
    struct failing failing = {.fails_at = n, .answer = answers[answer].returned, .lends_nothing = lends};
    struct drawing drawing = begin(trouble->scene, trouble->core, trouble->method, trouble->set, &failing, 0);
    const int code = frame(trouble->core, &drawing);
    const bool failed = failing.failed;

    assert_int_equal(code, !failed ? LIM_OK : lends ? LIM_ERR_TARGET : answers[answer].comes_back);
    assert_false(failing.goes_on);
    failing.failed = false;
    failing.fails_at = -1;
    assert_int_equal(frame(trouble->core, &drawing), LIM_OK);
    if (failed) assert_memory_equal(failing.lines, trouble->golden->lines, sizeof failing.lines);
    end(&drawing);
    return failed;
}

static void try_set(const struct compiled *scene, const struct core *core, enum lim_method method, enum stage_set set)
{
    struct failing golden = {.fails_at = -1};
    const struct trouble trouble = {scene, core, method, set, &golden};
    struct drawing drawing = begin(scene, core, method, set, &golden, 0);
    int lent = 0, sent = 0;

    assert_int_equal(frame(core, &drawing), LIM_OK);
    end(&drawing);
    while (fail_at(&trouble, true, 0, lent))
        lent++;
    for (size_t i = 0; i < sizeof answers / sizeof *answers; i++)
        for (sent = 0; fail_at(&trouble, false, i, sent);)
            sent++;
    assert_true(lent > 0 && sent >= H_PX);
}

static void try_errors(const struct compiled *scene, const struct core *core, enum lim_method method)
{
    for (enum stage_set set = PLAIN; set < STAGES; set++)
        if (can(method, set)) try_set(scene, core, method, set);
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

static void try_tree(const struct mesh *mesh, const struct core *core, enum tree_kind tree, trial *one)
{
    const bool is_mesh = tree == TREE_MESH;
    const enum lim_method *const draws = is_mesh ? mesh_orders : orders;
    const size_t count = is_mesh ? sizeof mesh_orders / sizeof *mesh_orders : sizeof orders / sizeof *orders;
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "auto",
                                            .core = core,
                                            .tree = tree,
                                            .method = is_mesh ? method_parse("mesh-depth", NULL) : NULL};
    struct compiled scene;
    struct error err;

    if (!compile_mesh(mesh, &options, &scene, &err)) fail_msg("%s", err.text);
    for (size_t i = 0; i < count; i++)
        one(&scene, core, draws[i]);
    compiled_free(&scene);
}

static void try_all(trial *one)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_or_sub_bits(found);
    struct random random = {801};
    struct mesh mesh = mesh_rig(200.0);

    convex_rig_add(&mesh, &random, 4);
    for (size_t k = 0; k < count; k++) {
        try_tree(&mesh, found[k], TREE_AUTO, one);
        try_tree(&mesh, found[k], TREE_MESH, one);
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
