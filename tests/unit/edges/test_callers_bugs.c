/* SPDX-License-Identifier: MIT
 *
 * A caller's bug stops the program at LIM_ASSERT, and does not read through NULL, go on, or never come back. Each is
 * made in a process of its own, which has to end by the trap that LIM_ASSERT is here. */
#include "collide.h"
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "limner.h"
#include "rigs/cmocka_ready.h"
#include "rigs/convex_rig.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { W_PX = 16, H_PX = 12 };

static struct compiled scene, long_scene;
static uint16_t lines[H_PX][W_PX];
static void *lim; /* of core_fast */
static uint32_t mem[1 << 16];
static void *mover_mem[1 << 16];
static const struct lim_camera camera = {
    .eye_q8 = {0, 0, 500 * 256}, .tan_x_q28 = 1 << 28, .tan_y_q28 = 1 << 28, .near_q8 = 256};
static bool reenters, works;

static void *lend(void *ctx, uint16_t y_px)
{
    (void)ctx;
    return lines[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px, (void)x_px, (void)n_px;
    if (reenters && works) (void)core_fast.work(lim);
    if (reenters) (void)core_fast.frame(lim, &camera);
    return 0;
}

static struct lim_target target(uint16_t w_px)
{
    return (struct lim_target){.w_px = w_px, .h_px = H_PX, .method = LIM_NEAREST_FIRST, .lend = lend, .done = done};
}

static void begin(void)
{
    const struct lim_target usual = target(W_PX);

    assert_int_equal(core_fast.init(lim, &scene.scene, &usual, mem, sizeof mem), LIM_OK);
}

static void no_renderer(void)
{
    (void)core_fast.frame(NULL, &camera);
}

static void no_camera(void)
{
    begin();
    (void)core_fast.frame(lim, NULL);
}

static void no_scene(void)
{
    const struct lim_target usual = target(W_PX);

    (void)core_fast.init(lim, NULL, &usual, mem, sizeof mem);
}

static void no_target(void)
{
    (void)core_fast.init(lim, &scene.scene, NULL, mem, sizeof mem);
}

static void no_memory(void)
{
    const struct lim_target usual = target(W_PX);

    (void)core_fast.init(lim, &scene.scene, &usual, NULL, 0);
}

static void frame_before_begin(void)
{
    memset(lim, 0, core_fast.lim_b);
    (void)core_fast.frame(lim, &camera);
}

/* A renderer that was well before, and was begun again with what cannot be drawn. */
static void frame_after_failed_begin(void)
{
    const struct lim_target none = target(0);

    begin();
    assert_int_equal(core_fast.init(lim, &scene.scene, &none, mem, sizeof mem), LIM_ERR_TARGET);
    (void)core_fast.frame(lim, &camera);
}

static void frame_after_too_little_memory(void)
{
    const struct lim_target usual = target(W_PX);

    begin();
    assert_int_equal(core_fast.init(lim, &scene.scene, &usual, mem, 4), LIM_ERR_MEMORY);
    (void)core_fast.frame(lim, &camera);
}

static void frame_from_done(void)
{
    begin();
    reenters = true;
    (void)core_fast.frame(lim, &camera);
}

static void frame_ahead_from_done(void)
{
    begin();
    assert_int_equal(core_fast.begin(lim, &camera, NULL, 0), LIM_OK);
    reenters = true;
    (void)core_fast.paint(lim);
}

static void no_camera_to_set(void)
{
    assert_int_equal(lim_camera_set_fov(NULL, LIM_DEGREES(60), W_PX, H_PX), LIM_OK);
}

static void no_wireframe(void)
{
    begin();
    core_fast.set_wireframe(lim, NULL);
}

static void no_solid(void)
{
    assert_int_equal(lim_solid_init(NULL, &scene.scene, mem, sizeof mem), LIM_OK);
}

static void no_scene_of_a_solid(void)
{
    struct lim_solid solid;

    assert_int_equal(lim_solid_init(&solid, NULL, mem, sizeof mem), LIM_OK);
}

static void work_from_done(void)
{
    begin();
    reenters = works = true;
    (void)core_fast.frame(lim, &camera);
}

static void instances_that_are_none(void)
{
    begin();
    (void)core_fast.movers_frame(lim, &camera, NULL, 1);
}

/* An object whose coordinates have 32 bits, in a scene of 16 and in one of 32. */
static void move_a_long_object(struct compiled *in)
{
    const struct lim_target usual = target(W_PX);
    const struct lim_movers_limits limits = {.instances = 1, .depth = 64};
    const struct lim_instance instance = {.object = &long_scene.scene,
                                          .axes_q30 = {1 << 30, 0, 0, 0, 1 << 30, 0, 0, 0, 1 << 30}};

    assert_int_equal(core_fast.init(lim, &in->scene, &usual, mem, sizeof mem), LIM_OK);
    assert_int_equal(core_fast.movers_init(lim, mover_mem, sizeof mover_mem, &limits), LIM_OK);
    (void)core_fast.movers_frame(lim, &camera, &instance, 1);
}

static void a_long_object(void)
{
    move_a_long_object(&scene);
}

static void a_long_object_in_a_long_scene(void)
{
    move_a_long_object(&long_scene);
}

/* NULL to functions that take a renderer, or make one. */
static void null_to_begin(void)
{
    assert_int_equal(lim_begin(NULL, &scene.scene, LIM_NEAREST_FIRST, NULL, NULL), LIM_OK);
}

static void null_to_sender_target(void)
{
    struct lim_target made;

    assert_int_equal(lim_sender_target(NULL, W_PX, H_PX, LIM_NEAREST_FIRST, &made), LIM_OK);
}

static void null_to_mem_b(void)
{
    const struct lim_target usual = target(W_PX);

    (void)lim_mem_b(NULL, &usual);
}

static void null_to_mem_min_b(void)
{
    (void)lim_mem_min_b(&scene.scene, NULL);
}

static void null_to_set_antialias(void)
{
    assert_int_equal(lim_set_antialias(NULL, mem, sizeof mem), LIM_OK);
}

static void null_to_set_delta(void)
{
    assert_int_equal(lim_set_delta(NULL, mem, sizeof mem), LIM_OK);
}

static void null_to_set_overlay(void)
{
    lim_set_overlay(NULL, NULL);
}

static void null_to_set_visible(void)
{
    lim_set_visible(NULL, NULL);
}

static void null_to_refresh(void)
{
    lim_refresh(NULL);
}

static void null_to_newell_set(void)
{
    lim_newell_set((struct lim *)lim, NULL);
}

static void null_to_light_set(void)
{
    lim_light_set((struct lim *)lim, NULL);
}

static void null_to_movers_init(void)
{
    assert_int_equal(lim_movers_init(NULL, mem, sizeof mem, NULL), LIM_OK);
}

static void null_to_movers_mem_b(void)
{
    (void)lim_movers_mem_b(&scene.scene, NULL);
}

static void null_to_frame_begin(void)
{
    assert_int_equal(lim_frame_begin(NULL, &camera), LIM_OK);
}

static void null_to_frame_work(void)
{
    (void)lim_frame_work(NULL);
}

static void null_to_frame_paint(void)
{
    assert_int_equal(lim_frame_paint(NULL), LIM_OK);
}

static void null_to_bands(void)
{
    (void)lim_bands(NULL);
}

static void null_to_stats(void)
{
    (void)lim_stats(NULL);
}

/* NULL to what places cameras and objects, and stops walkers. */
static void null_to_look_at(void)
{
    lim_look_at(NULL, camera.eye_q8, camera.eye_q8);
}

static void null_to_orbit(void)
{
    struct lim_camera placed = camera;

    lim_orbit(&placed, NULL, 256, 0, 0);
}

static void null_to_instance_turn(void)
{
    lim_instance_turn(NULL, 0, 0, 0);
}

static void null_to_motion_at(void)
{
    lim_motion_at(NULL, 0, NULL);
}

static void null_to_moved_at(void)
{
    lim_moved_at(NULL, 1, 0, NULL);
}

static void null_to_trace(void)
{
    struct lim_hit hit;

    assert_int_equal(lim_trace(NULL, camera.eye_q8, camera.eye_q8, 0, &hit), LIM_OK);
}

static void null_to_sweep(void)
{
    struct lim_hit hit;

    assert_int_equal(lim_sweep(NULL, camera.eye_q8, camera.eye_q8, camera.eye_q8, 0, &hit), LIM_OK);
}

static void null_to_slide(void)
{
    int32_t at_q8[3] = {0};

    assert_int_equal(lim_slide(NULL, camera.eye_q8, at_q8, at_q8, 0), LIM_OK);
}

static void null_to_walker_move(void)
{
    assert_int_equal(lim_walker_move(NULL, NULL, 0, 0), LIM_OK);
}

static const struct {
    const char *name;
    void (*make)(void);
} bugs[] = {{"no renderer", no_renderer},
            {"no camera", no_camera},
            {"no scene", no_scene},
            {"no target", no_target},
            {"no memory", no_memory},
            {"a frame before begin", frame_before_begin},
            {"a frame after a failed begin", frame_after_failed_begin},
            {"a frame after too little memory", frame_after_too_little_memory},
            {"a frame from done()", frame_from_done},
            {"a frame from done() of one that was begun", frame_ahead_from_done},
            {"no camera to set", no_camera_to_set},
            {"no wireframe", no_wireframe},
            {"no solid", no_solid},
            {"no scene of a solid", no_scene_of_a_solid},
            {"a quantum of work from done()", work_from_done},
            {"instances that are none", instances_that_are_none},
            {"an object of 32 bits in a scene of 16", a_long_object},
            {"an object of 32 bits in a scene of 32", a_long_object_in_a_long_scene},
            {"NULL to lim_begin()", null_to_begin},
            {"NULL to lim_sender_target()", null_to_sender_target},
            {"NULL to lim_mem_b()", null_to_mem_b},
            {"NULL to lim_mem_min_b()", null_to_mem_min_b},
            {"NULL to lim_set_antialias()", null_to_set_antialias},
            {"NULL to lim_set_delta()", null_to_set_delta},
            {"NULL to lim_set_overlay()", null_to_set_overlay},
            {"NULL to lim_set_visible()", null_to_set_visible},
            {"NULL to lim_refresh()", null_to_refresh},
            {"NULL to lim_newell_set()", null_to_newell_set},
            {"NULL to lim_light_set()", null_to_light_set},
            {"NULL to lim_movers_init()", null_to_movers_init},
            {"NULL to lim_movers_mem_b()", null_to_movers_mem_b},
            {"NULL to lim_frame_begin()", null_to_frame_begin},
            {"NULL to lim_frame_work()", null_to_frame_work},
            {"NULL to lim_frame_paint()", null_to_frame_paint},
            {"NULL to lim_bands()", null_to_bands},
            {"NULL to lim_stats()", null_to_stats},
            {"NULL to lim_look_at()", null_to_look_at},
            {"NULL to lim_orbit()", null_to_orbit},
            {"NULL to lim_instance_turn()", null_to_instance_turn},
            {"NULL to lim_motion_at()", null_to_motion_at},
            {"NULL to lim_moved_at()", null_to_moved_at},
            {"NULL to lim_trace()", null_to_trace},
            {"NULL to lim_sweep()", null_to_sweep},
            {"NULL to lim_slide()", null_to_slide},
            {"NULL to lim_walker_move()", null_to_walker_move}};

/* The signal that ended a process which did so; 0: none did. */
static int signal_of(void (*make)(void))
{
    int status = 0;
    const pid_t child = fork();

    assert_true(child >= 0);
    if (child == 0) {
        signal(SIGILL, SIG_DFL);
        signal(SIGTRAP, SIG_DFL);
        alarm(10);
        make();
        _exit(0);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

static void a_trap(void)
{
    LIM_ASSERT(false);
}

static void a_callers_bug_stops_the_program(void **state)
{
    const int trap = signal_of(a_trap);

    (void)state;
    assert_true(trap == SIGILL || trap == SIGTRAP);
    for (size_t i = 0; i < sizeof bugs / sizeof *bugs; i++)
        if (signal_of(bugs[i].make) != trap) fail_msg("%s: it does not stop there", bugs[i].name);
}

/* What the bugs are made with draws, where there is none. */
static void no_bug_stops_nothing(void **state)
{
    (void)state;
    begin();
    for (int i = 0; i < 2; i++) {
        assert_int_equal(core_fast.frame(lim, &camera), LIM_OK);
        assert_int_equal(core_fast.begin(lim, &camera, NULL, 0), LIM_OK);
        while (core_fast.work(lim))
            continue;
        assert_int_equal(core_fast.paint(lim), LIM_OK);
        assert_int_equal(core_fast.paint(lim), LIM_ERR_BEGIN);
    }
}

static int set_up(void **state)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .core = &core_fast};
    struct random random = {802};
    struct mesh mesh = mesh_rig(200.0);
    struct error err;

    (void)state;
    convex_rig_add(&mesh, &random, 3);
    if (!compile_mesh(&mesh, &options, &scene, &err)) fail_msg("%s", err.text);
    mesh.grid.is_long = true;
    if (!compile_mesh(&mesh, &options, &long_scene, &err)) fail_msg("%s", err.text);
    assert_non_null(long_scene.scene.of_32_bits[0]);
    mesh_rig_free(&mesh);
    lim = calloc(1, core_fast.lim_b);
    return lim ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    free(lim);
    compiled_free(&scene);
    compiled_free(&long_scene);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_callers_bug_stops_the_program),
        cmocka_unit_test(no_bug_stops_nothing),
    };

    return cmocka_run_group_tests_name("callers_bugs", tests, set_up, tear_down);
}
