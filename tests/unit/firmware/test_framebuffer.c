/* SPDX-License-Identifier: MIT
 *
 * Targets with a framebuffer: nearest first and the painter paint the pictures there that they make of lines, and
 * nothing beside them; then all lines are done, from the top down. What cannot be painted so is lent lines as ever. */
#include "rigs/cmocka_ready.h"
#include "rigs/renderer_pair.h"
#include "rigs/room_stage.h"
#include "rigs/set_rig.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 63, H_PX = 48, STRIDE_PX = 70, BESIDE = 0x5AA5, VIEWS = 40, FAILURE = -77 };

struct canvas {
    struct lim_target target;
    _Alignas(8) uint16_t pixels[H_PX + 1][STRIDE_PX];
    unsigned lent, done, pieces;
    unsigned fails_at; /* which call of done() fails, from 1 on; 0: none */
};

static void *lend(void *ctx, uint16_t y_px)
{
    struct canvas *canvas = ctx;

    assert_true(y_px < H_PX);
    canvas->lent++;
    return canvas->pixels[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct canvas *canvas = ctx;

    if (x_px == 0 && n_px == W_PX) assert_int_equal(y_px, canvas->done);
    canvas->pieces++;
    canvas->done += x_px + n_px == W_PX;
    return canvas->pieces == canvas->fails_at ? FAILURE : 0;
}

static void round_glass(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    (void)ctx;
    renderer_pair_round(W_PX, H_PX, y_px, x0_px, x1_px);
}

/* Two renderers of a scene: one that is lent lines, and one with a framebuffer. */
struct pair {
    struct renderer_pair of;
    struct canvas canvas[2];
};

static struct pair *pair_new(const struct lim_scene *scene, enum lim_method method, bool least)
{
    struct pair *pair = calloc(1, sizeof *pair);

    for (int i = 0; i < 2; i++) {
        struct canvas *canvas = &pair->canvas[i];
        canvas->target = (struct lim_target){
            .w_px = W_PX, .h_px = H_PX, .method = method, .ctx = canvas, .lend = lend, .done = done};
        if (i) canvas->target.framebuffer = (struct lim_framebuffer){canvas->pixels, STRIDE_PX};
        renderer_pair_start(&pair->of, i, scene, &canvas->target, i && least);
    }
    return pair;
}

static void pair_free(struct pair *pair)
{
    renderer_pair_end(&pair->of);
    free(pair);
}

static void wipe(struct canvas *canvas)
{
    canvas->lent = canvas->done = canvas->pieces = 0;
    for (int y = 0; y <= H_PX; y++) {
        for (int x = 0; x < STRIDE_PX; x++)
            canvas->pixels[y][x] = BESIDE;
    }
}

static int draw(struct pair *pair, const struct lim_camera *camera)
{
    wipe(&pair->canvas[0]);
    wipe(&pair->canvas[1]);
    assert_int_equal(lim_frame(&pair->of.lim[0], camera), LIM_OK);
    return lim_frame(&pair->of.lim[1], camera);
}

/* All of it: what lies beside the lines, and below them, is as it was. */
static void assert_same(const struct pair *pair)
{
    assert_memory_equal(pair->canvas[1].pixels, pair->canvas[0].pixels, sizeof pair->canvas[0].pixels);
    assert_int_equal(pair->canvas[1].done, H_PX);
}

static int set_up(void **state)
{
    return room_stage_set_up(state, 815);
}

static struct lim_camera view(struct room_stage *stage)
{
    return room_stage_view(stage, W_PX, H_PX);
}

static void both_orders_paint_the_same_without_lines(void **state)
{
    static const enum lim_method METHODS[] = {LIM_NEAREST_FIRST, LIM_PAINTER};
    struct room_stage *stage = *state;

    for (size_t m = 0; m < sizeof METHODS / sizeof METHODS[0]; m++) {
        struct pair *pair = pair_new(&stage->scene.scene, METHODS[m], false);
        for (int i = 0; i < VIEWS; i++) {
            const struct lim_camera camera = view(stage);
            assert_int_equal(draw(pair, &camera), 0);
            assert_same(pair);
            assert_int_equal(pair->canvas[1].pieces, H_PX);
            assert_int_equal(pair->canvas[1].lent, 0);
        }
        pair_free(pair);
    }
}

/* Nothing can be done ahead, and nothing is. */
static void a_frame_in_parts_is_painted_in_one(void **state)
{
    struct pair *pair = pair_new(&((struct room_stage *)*state)->scene.scene, LIM_NEAREST_FIRST, false);

    for (int i = 0; i < VIEWS / 4; i++) {
        const struct lim_camera camera = view(*state);
        wipe(&pair->canvas[0]);
        wipe(&pair->canvas[1]);
        assert_int_equal(lim_frame(&pair->of.lim[0], &camera), LIM_OK);
        assert_int_equal(lim_frame_begin(&pair->of.lim[1], &camera), LIM_OK);
        assert_false(lim_frame_work(&pair->of.lim[1]));
        assert_int_equal(pair->canvas[1].pieces, 0);
        assert_int_equal(lim_frame_paint(&pair->of.lim[1]), LIM_OK);
        assert_same(pair);
        assert_int_equal(pair->canvas[1].lent, 0);
    }
    pair_free(pair);
}

static void what_cannot_be_one_is_refused(void **state)
{
    static struct canvas canvas;
    static uint32_t mem[16384];
    const struct lim_scene *scene = &((struct room_stage *)*state)->scene.scene;
    struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .ctx = &canvas, .lend = lend, .done = done};
    struct lim lim;
    const struct {
        struct lim_framebuffer framebuffer;
        int code;
    } cases[] = {
        {{canvas.pixels, W_PX + 1}, LIM_OK},
        {{canvas.pixels, W_PX - 1}, LIM_ERR_TARGET},
        {{canvas.pixels, W_PX + 2}, LIM_ERR_TARGET},
        {{canvas.pixels, 0}, LIM_ERR_TARGET},
        {{&canvas.pixels[0][1], STRIDE_PX}, LIM_ERR_TARGET},
        {{NULL, 1}, LIM_OK},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        target.framebuffer = cases[i].framebuffer;
        assert_int_equal(lim_init(&lim, scene, &target, mem, sizeof mem), cases[i].code);
    }
}

/* Without a pixel of what round glass does not show. */
static void round_glass_is_painted_where_it_is_seen(void **state)
{
    struct pair *pair = pair_new(&((struct room_stage *)*state)->scene.scene, LIM_NEAREST_FIRST, false);

    for (int i = 0; i < 2; i++)
        pair->of.lim[i].pass.target.visible = round_glass;
    for (int i = 0; i < VIEWS / 4; i++) {
        const struct lim_camera camera = view(*state);
        assert_int_equal(draw(pair, &camera), 0);
        assert_same(pair);
        for (uint16_t y = 0; y < H_PX; y++) {
            uint16_t x0, x1;
            round_glass(NULL, y, &x0, &x1);
            for (uint16_t x = 0; x < STRIDE_PX; x++)
                assert_int_equal(pair->canvas[1].pixels[y][x] != BESIDE, x >= x0 && x < x1);
        }
    }
    pair_free(pair);
}

static void without_room_for_gaps_some_is_painted_again(void **state)
{
    struct pair *pair = pair_new(&((struct room_stage *)*state)->scene.scene, LIM_NEAREST_FIRST, true);
    int banded = 0;

    for (int i = 0; i < VIEWS; i++) {
        const struct lim_camera camera = view(*state);
        assert_int_equal(draw(pair, &camera), 0);
        assert_same(pair);
        assert_int_equal(pair->canvas[1].lent, 0);
        assert_in_range(lim_bands(&pair->of.lim[1]), 0, H_PX);
        banded += lim_bands(&pair->of.lim[1]) > 0;
    }
    assert_true(banded > 0);
    pair_free(pair);
}

static void what_done_returns_comes_through(void **state)
{
    static const enum lim_method METHODS[] = {LIM_NEAREST_FIRST, LIM_PAINTER};
    struct room_stage *stage = *state;

    for (size_t i = 0; i < sizeof METHODS / sizeof METHODS[0]; i++) {
        struct pair *pair = pair_new(&stage->scene.scene, METHODS[i], false);
        const struct lim_camera camera = view(stage);
        pair->canvas[1].fails_at = 5;
        assert_int_equal(draw(pair, &camera), FAILURE);
        assert_int_equal(pair->canvas[1].pieces, 5);
        pair->canvas[1].fails_at = 0;
        assert_int_equal(draw(pair, &camera), 0);
        assert_same(pair);
        pair_free(pair);
    }
}

/* Draws some views, none of which may be painted so. */
static void assert_lines(struct room_stage *stage, struct pair *pair)
{
    for (int i = 0; i < 4; i++) {
        const struct lim_camera camera = view(stage);
        assert_int_equal(draw(pair, &camera), 0);
        assert_same(pair);
        assert_int_equal(pair->canvas[1].lent, pair->canvas[0].lent);
    }
    pair_free(pair);
}

static void other_orders_come_by_lines(void **state)
{
    static const enum lim_method OTHERS[] = {LIM_SCANLINE, LIM_DEPTH, LIM_NEWELL};
    struct room_stage *stage = *state;

    for (size_t i = 0; i < sizeof OTHERS / sizeof OTHERS[0]; i++)
        assert_lines(stage, pair_new(&stage->scene.scene, OTHERS[i], false));
}

static void outlines_and_glass_come_by_lines(void **state)
{
    static const enum lim_method METHODS[] = {LIM_NEAREST_FIRST, LIM_PAINTER};
    struct room_stage *stage = *state;
    struct lim_scene glass = stage->scene.scene;

    glass.limits.layers = 1; /* says that some of it is transparent, though nothing is */
    for (size_t m = 0; m < sizeof METHODS / sizeof METHODS[0]; m++) {
        struct pair *wire = pair_new(&stage->scene.scene, METHODS[m], false);
        for (int i = 0; i < 2; i++)
            lim_set_wireframe(&wire->of.lim[i], &(const struct lim_wireframe){.on = true});
        assert_lines(stage, wire);
        assert_lines(stage, pair_new(&glass, METHODS[m], false));
    }
}

static void smooth_edges_come_by_lines(void **state)
{
    static uint32_t sums[2][LIM_ANTIALIAS_MEM_B(W_PX) / 4 + 1];
    struct room_stage *stage = *state;
    struct pair *smooth = pair_new(&stage->scene.scene, LIM_NEAREST_FIRST, false);

    for (int i = 0; i < 2; i++)
        assert_int_equal(lim_set_antialias(&smooth->of.lim[i], sums[i], sizeof sums[i]), LIM_OK);
    assert_lines(stage, smooth);
}

/* Cards that lie over one another like a fan, the first on top, in one run. */
static void deal(struct set *set, int count)
{
    set_init(set);
    for (int16_t k = 0; k < count; k++) {
        const int16_t x0 = (int16_t)(8 * k - 800), x1 = (int16_t)(x0 + 150), z = (int16_t)(-1000 - 10 * k);
        const int16_t corners[4][3] = {{x0, -300, z}, {x1, -300, z}, {x1, 300, z}, {x0, 300, z}};
        set_add(set, (lim_index)(k + 1), 4, corners);
    }
}

/* More cards than are noted at a time, and any number up to that. */
static void a_long_run_is_painted_from_its_end(void **state)
{
    static struct set set;
    const struct lim_camera camera = set_camera(false);

    (void)state;
    for (int count = 1; count <= 200; count += count < 80 ? 1 : 40) {
        deal(&set, count);
        struct pair *nearest = pair_new(&set.scene, LIM_NEAREST_FIRST, false);
        struct pair *painter = pair_new(&set.scene, LIM_PAINTER, false);
        assert_int_equal(draw(nearest, &camera), 0);
        assert_int_equal(draw(painter, &camera), 0);
        assert_same(nearest);
        assert_same(painter);
        assert_memory_equal(painter->canvas[1].pixels, nearest->canvas[1].pixels, sizeof nearest->canvas[1].pixels);
        pair_free(nearest);
        pair_free(painter);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(both_orders_paint_the_same_without_lines, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(a_frame_in_parts_is_painted_in_one, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(what_cannot_be_one_is_refused, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(round_glass_is_painted_where_it_is_seen, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(without_room_for_gaps_some_is_painted_again, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(what_done_returns_comes_through, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(other_orders_come_by_lines, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(outlines_and_glass_come_by_lines, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(smooth_edges_come_by_lines, set_up, room_stage_tear_down),
        cmocka_unit_test(a_long_run_is_painted_from_its_end),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
