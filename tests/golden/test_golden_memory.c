/* SPDX-License-Identifier: MIT
 *
 * The renderer in every amount of memory from the least on: a byte less is refused, pictures are the same in all of
 * them where the method promises that, and pixels, statistics and what frames leave in memory are as in
 * tests/golden/golden_memory.expected. A picture in little memory is drawn in many walks, so this is where pools run
 * out: of gaps, active polygons, retained cells, pieces, layers, cuts of movers, runs of delta output.
 * GOLDEN_FRAMES=write writes the file anew. */
#include "core/core.h"
#include "golden_state.h"
#include "lines/smooth.h"
#include "pixels/delta.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "scene/moving.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 38, H_PX = 22, STEPS = 5 };

struct trial {
    struct simulator simulator;
    struct golden_stage *stage;
    const struct golden_way *way;
    struct lim_camera camera;
    uint32_t hash, bands, memory;
    uint32_t picture; /* of the first frame, 0 before that */
};

/* What lends its memory anew. */
static bool init_in(struct trial *trial, size_t mem_b)
{
    struct simulator *simulator = &trial->simulator;
    const struct core *core = simulator->core;

    free(simulator->mem);
    simulator->mem = malloc(mem_b);
    assert_non_null(simulator->mem);
    simulator->mem_b = mem_b;
    free(simulator->mover_mem);
    simulator->mover_mem = NULL;
    const int code = core->init(simulator->lim, simulator->scene, &simulator->target, simulator->mem, mem_b);
    if (code) assert_int_equal(code, LIM_ERR_MEMORY);
    if (code || !golden_turn_on(simulator, trial->stage, trial->way)) return false;
    golden_state_clear(simulator, trial->stage);
    return true;
}

/* Newell's cuts depend on how many pieces there is room for. Antialiased glass and textures are rounded otherwise on a
 * line that is drawn alone; and what moves has another order in a few pixels of edges where a pixel is. */
static bool is_always_the_same(const struct trial *trial)
{
    const struct lim_scene *scene = &trial->stage->scene.scene;
    const bool is_mixed = scene->limits.layers || scene->textures || trial->stage->moving.count;

    return trial->way->method != LIM_NEWELL && (trial->way->special != GOLDEN_ANTIALIAS || !is_mixed);
}

static void draw(struct trial *trial)
{
    const int code = simulator_draw(&trial->simulator, &trial->camera);
    const struct lim_stats *stats = simulator_stats(&trial->simulator);

    const uint32_t picture = golden_hash_frame(GOLDEN_HASH, &trial->simulator);

    assert_int_equal(code, LIM_OK);
    if (!trial->picture) trial->picture = picture;
    if (is_always_the_same(trial)) assert_int_equal(picture, trial->picture);
    trial->bands += stats->bands;
    trial->hash = golden_hash(trial->hash ^ picture, stats, sizeof *stats);
    const uint32_t left = golden_state(&trial->simulator);
    trial->memory = golden_hash(trial->memory, &left, sizeof left);
}

/* Room for all movers that there are, and for one less, which leaves it out. */
static void draw_with_movers(struct trial *trial)
{
    struct moving *moving = &trial->stage->moving;
    const struct lim_movers_limits whole = moving->limits;

    for (unsigned less = 0; less < 2; less++) {
        moving->limits.instances = (uint16_t)(whole.instances - less);
        trial->picture = 0;
        assert_true(init_in(trial, trial->simulator.mem_b));
        draw(trial);
        trial->hash = golden_hash(trial->hash, &moving->limits, sizeof moving->limits);
    }
    moving->limits = whole;
}

static void draw_in_all(struct trial *trial)
{
    const struct simulator *simulator = &trial->simulator;
    const size_t least_b = simulator->core->mem_min_b(simulator->scene, &simulator->target);
    const size_t most_b = simulator->core->mem_b(simulator->scene, &simulator->target);
    const size_t beside_b[] = {most_b - 1, most_b, most_b + 1, most_b + 333, most_b + 5000};

    assert_true(least_b <= most_b);
    assert_false(init_in(trial, least_b - 1));
    for (size_t step = 0; step < STEPS; step++) {
        assert_true(init_in(trial, least_b + (most_b - least_b) * step / STEPS));
        draw(trial);
    }
    for (size_t i = least_b == most_b; i < sizeof beside_b / sizeof *beside_b; i++) {
        assert_true(init_in(trial, beside_b[i]));
        draw(trial);
    }
    if (trial->stage->moving.count) draw_with_movers(trial);
    golden_put("%s %s %s: %zu to %zu B, bands %u, %08x, memory %08x\n", trial->stage->name, simulator->core->name,
               trial->way->name, least_b, most_b, trial->bands, trial->hash, trial->memory);
}

static void put_scene(struct golden_stage *stage)
{
    struct trial trial = {.stage = stage};
    struct lens lens = stage->lens;
    struct error err;

    if (stage->moving.count) moving_pose(&stage->moving, moving_time_s(&stage->moving, 1, GOLDEN_FRAMES));
    assert_true(lens_init(&lens, 70, lens_default_near_m(&stage->scene.grid), W_PX, H_PX, &err));
    assert_true(camera_path_to_camera(&stage->path, 1, &lens, &stage->scene.grid, &trial.camera, &err));
    for (size_t k = 0; cores[k]; k++)
        for (trial.way = golden_ways; trial.way->name; trial.way++) {
            trial.hash = trial.memory = GOLDEN_HASH;
            trial.bands = trial.picture = 0;
            if (golden_begin(&trial.simulator, stage, cores[k], trial.way, W_PX, H_PX)) draw_in_all(&trial);
            simulator_free(&trial.simulator);
        }
}

static void in_any_memory_frames_are_what_they_were(void **state)
{
    struct golden_stage stage;

    (void)state;
    for (size_t scene = 0; golden_open(&stage, scene); scene++) {
        put_scene(&stage);
        golden_close(&stage);
    }
    golden_compare("tests/golden/golden_memory.expected");
}

/* In each profile and method: all of what antialiasing and delta output ask for, or an error. */
static void a_byte_less_than_is_asked_for_is_refused(void **state)
{
    static uint32_t lent[1 << 14];
    struct golden_stage stage;

    (void)state;
    assert_true(golden_open(&stage, 0));
    for (size_t k = 0; cores[k]; k++)
        for (const struct golden_way *way = golden_ways; way->name; way++) {
            const size_t smooth_b = LIM_ANTIALIAS_MEM_B(W_PX), runs_b = LIM_DELTA_MEM_B(W_PX, H_PX, 1);
            struct simulator simulator;
            if (way->special == GOLDEN_PLAIN && golden_begin(&simulator, &stage, cores[k], way, W_PX, H_PX)) {
                const bool can = way->method != LIM_PAINTER && way->method != LIM_CONVEX;
                const int err = can ? LIM_OK : LIM_ERR_TARGET, less = can ? LIM_ERR_MEMORY : LIM_ERR_TARGET;
                assert_int_equal(cores[k]->set_antialias(simulator.lim, lent, smooth_b - 1), less);
                assert_int_equal(cores[k]->set_antialias(simulator.lim, lent, smooth_b), err);
                assert_int_equal(cores[k]->set_antialias(simulator.lim, NULL, 0), LIM_OK);
                assert_int_equal(cores[k]->set_delta(simulator.lim, lent, runs_b - 4), LIM_ERR_MEMORY);
                assert_int_equal(cores[k]->set_delta(simulator.lim, lent, runs_b + 4), LIM_OK);
                assert_int_equal(cores[k]->set_delta(simulator.lim, NULL, 0), LIM_OK);
            }
            simulator_free(&simulator);
        }
    golden_close(&stage);
}

/* Between the renderer and a simulator's target: its n-th call of either kind fails. */
static struct {
    struct lim_target inner;
    long calls, fails_at, late;
    bool lends_nothing, failed; /* lend() fails, or done() */
} between;

enum { TARGET_ERROR = -4711 };

static bool fails(bool lends)
{
    if (between.failed) between.late++;
    if (lends != between.lends_nothing || between.calls++ != between.fails_at) return false;
    between.failed = true;
    return true;
}

static void *lend_between(void *ctx, uint16_t y)
{
    return fails(true) ? NULL : between.inner.lend(ctx, y);
}

static int done_between(void *ctx, uint16_t y, uint16_t x, uint16_t n)
{
    const int err = between.inner.done(ctx, y, x, n);

    return fails(false) ? TARGET_ERROR : err;
}

/* Whether it came to the n-th call. */
static bool fail_target(struct trial *trial, bool lends, long n)
{
    between.calls = between.late = 0;
    between.fails_at = n;
    between.lends_nothing = lends;
    between.failed = false;
    assert_true(init_in(trial, trial->simulator.core->mem_min_b(trial->simulator.scene, &between.inner) + 2000));
    const int code = simulator_draw(&trial->simulator, &trial->camera);
    assert_int_equal(code, !between.failed ? LIM_OK : lends ? LIM_ERR_TARGET : TARGET_ERROR);
    assert_int_equal(between.late, 0);
    return between.failed;
}

static unsigned fail_targets(struct golden_stage *stage, const struct core *core, const struct golden_way *way)
{
    struct trial trial = {.stage = stage, .way = way};
    struct simulator *simulator = &trial.simulator;
    struct lens lens;
    struct error err;
    unsigned failed = 0;

    assert_true(lens_init(&lens, 70, lens_default_near_m(&stage->scene.grid), W_PX, H_PX, &err));
    assert_true(camera_path_to_camera(&stage->path, 1, &lens, &stage->scene.grid, &trial.camera, &err));
    if (stage->moving.count) moving_pose(&stage->moving, moving_time_s(&stage->moving, 1, GOLDEN_FRAMES));
    if (golden_begin(simulator, stage, core, way, W_PX, H_PX)) {
        between.inner = simulator->target;
        simulator->target.lend = lend_between;
        simulator->target.done = done_between;
        for (int lends = 0; lends < 2; lends++)
            for (long n = 0; fail_target(&trial, lends, n); n += 1 + n)
                failed++;
    }
    simulator_free(simulator);
    return failed;
}

/* All profiles, or with little effort another one for each scene. */
static bool is_asked(size_t core, size_t scene)
{
    const size_t every = 4 / (size_t)effort(4);

    return core % every == scene % every;
}

static void an_error_of_the_target_ends_the_frame_and_comes_through(void **state)
{
    struct golden_stage stage;
    unsigned failed = 0;

    (void)state;
    for (size_t scene = 0; golden_open(&stage, scene); scene++) {
        for (size_t k = 0; cores[k]; k++)
            for (const struct golden_way *way = golden_ways; is_asked(k, scene) && way->name; way++)
                failed += fail_targets(&stage, cores[k], way);
        golden_close(&stage);
    }
    print_message("# golden memory: %u errors of targets\n", failed);
    assert_true(failed > (unsigned)effort(3000));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(in_any_memory_frames_are_what_they_were),
                                       cmocka_unit_test(an_error_of_the_target_ends_the_frame_and_comes_through),
                                       cmocka_unit_test(a_byte_less_than_is_asked_for_is_refused)};

    return cmocka_run_group_tests_name("golden_memory", tests, NULL, NULL);
}
