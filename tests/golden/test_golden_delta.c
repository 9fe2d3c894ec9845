/* SPDX-License-Identifier: MIT
 *
 * Delta output to targets of every kind: whole lines and pages, pixels that share bytes, round glass, in little memory
 * and with few runs, with cameras that stand and move, and errors of the target. After every frame it shows what a
 * frame sent whole would; what was sent, window by window and piece by piece, is as in
 * tests/golden/golden_delta.expected. GOLDEN_FRAMES=write writes the file anew. */
#include "core/core.h"
#include "golden_stage.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 46, H_PX = 27, FRAMES = 14, GLASS_ERROR = -77 };

static const struct lim_target_costs costs[] = {
    {11, 16, 1, 1}, {11, 12, 1, 2}, {40, 16, 1, 4}, {3, 1, 8, 1}, {0, 16, 1, 1}};
static const struct {
    const char *name;
    uint16_t runs;
    unsigned part; /* of the memory between the least and the usual, in quarters */
} rooms[] = {{"plenty", 4000, 4}, {"some", 60, 1}, {"least", 4, 0}};

/* What a target was sent, and what it shows. */
struct shown {
    uint16_t lines[H_PX][W_PX + 2], shown[H_PX][W_PX];
    bool is_round;
    uint16_t page_px;
    uint32_t hash;
    long calls, fails_at;
};

static void find_seen(const struct shown *glass, uint16_t y, uint16_t *x0, uint16_t *x1)
{
    const int dy = 2 * y + 1 - H_PX, most = H_PX * H_PX;

    *x0 = 0;
    *x1 = W_PX;
    while (glass->is_round && *x0 < *x1 && (2 * *x0 + 1 - W_PX) * (2 * *x0 + 1 - W_PX) + 2 * dy * dy > most)
        ++*x0, --*x1;
}

static void *lend(void *ctx, uint16_t y)
{
    struct shown *glass = ctx;

    return glass->lines[y];
}

static int done(void *ctx, uint16_t y, uint16_t x, uint16_t n)
{
    struct shown *glass = ctx;
    const uint16_t piece[] = {y, x, n}, first = (uint16_t)(y / glass->page_px * glass->page_px);

    glass->hash = golden_hash(glass->hash, piece, sizeof piece);
    glass->hash = golden_hash(glass->hash, &glass->lines[y][x], n * sizeof glass->lines[y][x]);
    for (uint16_t line = first; line <= y; line++)
        memcpy(&glass->shown[line][x], &glass->lines[line][x], n * sizeof glass->lines[line][x]);
    return glass->calls++ == glass->fails_at ? GLASS_ERROR : 0;
}

static int window(void *ctx, const struct lim_rect *rect)
{
    struct shown *glass = ctx;
    static const struct lim_rect none = {1, 2, 3, 4};

    glass->hash = golden_hash(glass->hash, rect ? rect : &none, sizeof *rect);
    return glass->calls++ == glass->fails_at ? GLASS_ERROR : 0;
}

static void visible(void *ctx, uint16_t y, uint16_t *x0, uint16_t *x1)
{
    find_seen(ctx, y, x0, x1);
}

static struct lim_target target_of(struct shown *glass, enum lim_method method, const struct lim_target_costs *cost)
{
    glass->page_px = cost->page_px;
    return (struct lim_target){.w_px = W_PX,
                               .h_px = H_PX,
                               .format = LIM_RGB565,
                               .method = method,
                               .ctx = glass,
                               .lend = lend,
                               .done = done,
                               .visible = glass->is_round ? visible : NULL,
                               .window = window,
                               .costs = *cost};
}

static void begin(struct simulator *simulator, const struct golden_stage *stage, struct shown *glass,
                  enum lim_method method, const struct lim_target_costs *cost, unsigned part)
{
    const struct lim_target target = target_of(glass, method, cost);
    const struct simulator_setup setup = {W_PX, H_PX, method, SIMULATOR_MEMORY, &core_fast};
    struct error err;

    memset(simulator, 0, sizeof *simulator);
    if (!simulator_init_to(simulator, &stage->scene.scene, &setup, &target, &err)) fail_msg("%s", err.text);
    const size_t least_b = core_fast.mem_min_b(simulator->scene, &simulator->target);
    const size_t mem_b = least_b + (simulator->mem_b - least_b) * part / 4;
    assert_int_equal(core_fast.init(simulator->lim, simulator->scene, &simulator->target, simulator->mem, mem_b), 0);
}

/* It stands, moves a little, and jumps. */
static struct lim_camera camera_at(const struct golden_stage *stage, unsigned frame)
{
    struct lim_camera camera;
    struct error err;

    if (!camera_path_to_camera(&stage->path, frame / 5, &stage->lens, &stage->scene.grid, &camera, &err))
        fail_msg("%s", err.text);
    if (frame % 5 > 1) camera.yaw += (frame % 5) << 20;
    return camera;
}

static void assert_shows_the_same(const struct shown *glass, const struct shown *whole)
{
    for (uint16_t y = 0; y < H_PX; y++) {
        uint16_t x0, x1;
        find_seen(glass, y, &x0, &x1);
        assert_memory_equal(&glass->shown[y][x0], &whole->shown[y][x0], (x1 - x0) * sizeof glass->shown[y][x0]);
    }
}

static void put_target(const struct golden_stage *stage, enum lim_method method, const struct lim_target_costs *cost,
                       bool is_round, size_t room)
{
    static struct shown glass, whole;
    struct simulator simulator, other;
    uint32_t sent[4] = {0};
    struct error err;

    memset(&glass, 0, sizeof glass);
    glass.is_round = whole.is_round = is_round;
    glass.hash = GOLDEN_HASH;
    begin(&simulator, stage, &glass, method, cost, rooms[room].part);
    begin(&other, stage, &whole, method, cost, 4);
    if (!simulator_set_delta(&simulator, rooms[room].runs, &err)) fail_msg("%s", err.text);
    for (unsigned frame = 0; frame < FRAMES; frame++) {
        const struct lim_camera camera = camera_at(stage, frame);
        glass.calls = 0;
        glass.fails_at = frame % 6 == 3 ? (long)(frame + room) : -1;
        const int code = simulator_draw(&simulator, &camera);
        assert_int_equal(code, glass.fails_at >= 0 && glass.calls > glass.fails_at ? GLASS_ERROR : 0);
        const struct lim_delta_stats *delta = &simulator_stats(&simulator)->delta;
        const uint32_t counts[] = {delta->pixels, delta->windows, delta->runs_max, delta->lines_whole};
        for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
            sent[i] += counts[i];
        whole.fails_at = -1;
        assert_int_equal(simulator_draw(&other, &camera), 0);
        if (!code) assert_shows_the_same(&glass, &whole);
    }
    golden_put("%s %u %u B %u bits %u lines %u columns %s %s: %08x, pixels %u, windows %u, runs %u, lines %u\n",
               stage->name, method, cost->window_b, cost->pixel_bits, cost->page_px, cost->x_align_px,
               is_round ? "round" : "square", rooms[room].name, glass.hash, sent[0], sent[1], sent[2], sent[3]);
    simulator_free(&simulator);
    simulator_free(&other);
}

static void changes_are_sent_as_they_were(void **state)
{
    static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_SCANLINE, LIM_NEWELL};
    struct golden_stage stage;

    (void)state;
    for (size_t scene = 0; golden_open(&stage, scene); scene++) {
        const bool wanted = strcmp(stage.name, "rooms.obj") == 0 || strcmp(stage.name, "glass.obj") == 0 ||
                            strcmp(stage.name, "textured") == 0;
        for (size_t method = 0; wanted && method < sizeof orders / sizeof *orders; method++)
            for (size_t cost = 0; cost < sizeof costs / sizeof *costs; cost++)
                for (size_t room = 0; room < sizeof rooms / sizeof *rooms; room++) {
                    if (orders[method] == LIM_NEWELL && (room || strcmp(stage.name, "rooms.obj") != 0)) continue;
                    put_target(&stage, orders[method], &costs[cost], false, room);
                    put_target(&stage, orders[method], &costs[cost], true, room);
                }
        golden_close(&stage);
    }
    golden_compare("tests/golden/golden_delta.expected");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(changes_are_sent_as_they_were)};

    return cmocka_run_group_tests_name("golden_delta", tests, NULL, NULL);
}
