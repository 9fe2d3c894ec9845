/* SPDX-License-Identifier: MIT
 *
 * Targets that keep the whole picture: they are given each pixel once, in pieces of one colour, and show what lines
 * would have shown; where gaps are short some are given again. Whatever is not made of such pieces comes by lines as
 * ever. */
#include "rigs/cmocka_ready.h"
#include "rigs/renderer_pair.h"
#include "rigs/room_stage.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 64, H_PX = 48, VIEWS = 40, FAILURE = -77 };

struct kept {
    struct lim_target target;
    _Alignas(8) uint16_t lines[H_PX][W_PX];
    uint16_t filled[H_PX][W_PX];
    uint8_t times[H_PX][W_PX]; /* that a pixel was filled */
    unsigned pieces, shown, done;
    int shows; /* what show() returns */
};

static void *lend(void *ctx, uint16_t y_px)
{
    return ((struct kept *)ctx)->lines[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct kept *picture = ctx;

    memcpy(&picture->filled[y_px][x_px], &picture->lines[y_px][x_px], 2 * (size_t)n_px);
    picture->done++;
    return 0;
}

static void fill(void *of_look, uint16_t x0_px, uint16_t x1_px)
{
    const struct lim_piece_look *look = of_look;
    struct kept *picture = look->ctx;

    assert_true(look->y_px < H_PX && x0_px < x1_px && x1_px <= W_PX);
    assert_int_equal(picture->shown, 0);
    for (uint16_t x = x0_px; x < x1_px; x++) {
        picture->filled[look->y_px][x] = look->colour;
        picture->times[look->y_px][x]++;
    }
    picture->pieces++;
}

static int show(void *ctx)
{
    struct kept *picture = ctx;

    picture->shown++;
    return picture->shows;
}

static void round_glass(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    (void)ctx;
    renderer_pair_round(W_PX, H_PX, y_px, x0_px, x1_px);
}

/* Two renderers of a scene: one that is given lines, and one that keeps its picture. */
struct pair {
    struct renderer_pair of;
    struct kept picture[2];
};

static struct pair *pair_new(const struct lim_scene *scene, enum lim_method method, bool least)
{
    struct pair *pair = calloc(1, sizeof *pair);

    for (int i = 0; i < 2; i++) {
        struct kept *picture = &pair->picture[i];
        picture->target = (struct lim_target){
            .w_px = W_PX, .h_px = H_PX, .method = method, .ctx = picture, .lend = lend, .done = done};
        if (i) picture->target.fill = fill, picture->target.show = show;
        renderer_pair_start(&pair->of, i, scene, &picture->target, i && least);
    }
    return pair;
}

static void pair_free(struct pair *pair)
{
    renderer_pair_end(&pair->of);
    free(pair);
}

static int draw(struct pair *pair, const struct lim_camera *camera)
{
    struct kept *given = &pair->picture[1];

    memset(given->times, 0, sizeof given->times);
    given->pieces = given->shown = given->done = 0;
    assert_int_equal(lim_frame(&pair->of.lim[0], camera), LIM_OK);
    return lim_frame(&pair->of.lim[1], camera);
}

static void assert_same(const struct pair *pair)
{
    assert_memory_equal(pair->picture[1].filled, pair->picture[0].filled, sizeof pair->picture[0].filled);
}

static int set_up(void **state)
{
    return room_stage_set_up(state, 815);
}

static struct lim_camera view(struct room_stage *stage)
{
    return room_stage_view(stage, W_PX, H_PX);
}

static void a_filled_frame_is_what_lines_make(void **state)
{
    struct pair *pair = pair_new(&((struct room_stage *)*state)->scene.scene, LIM_NEAREST_FIRST, false);

    for (int i = 0; i < VIEWS; i++) {
        const struct lim_camera camera = view(*state);
        assert_int_equal(draw(pair, &camera), 0);
        assert_same(pair);
        assert_int_equal(pair->picture[1].shown, 1);
        assert_int_equal(pair->picture[1].done, 0);
        for (int px = 0; px < W_PX * H_PX; px++)
            assert_int_equal(pair->picture[1].times[px / W_PX][px % W_PX], 1);
    }
    pair_free(pair);
}

static void round_glass_is_filled_where_it_is_seen(void **state)
{
    struct pair *pair = pair_new(&((struct room_stage *)*state)->scene.scene, LIM_NEAREST_FIRST, false);

    for (int i = 0; i < 2; i++)
        pair->of.lim[i].pass.target.visible = round_glass;
    for (int i = 0; i < VIEWS / 4; i++) {
        const struct lim_camera camera = view(*state);
        assert_int_equal(draw(pair, &camera), 0);
        for (uint16_t y = 0; y < H_PX; y++) {
            uint16_t x0, x1;
            round_glass(NULL, y, &x0, &x1);
            for (uint16_t x = 0; x < W_PX; x++)
                assert_int_equal(pair->picture[1].times[y][x], x >= x0 && x < x1);
            assert_memory_equal(&pair->picture[1].filled[y][x0], &pair->picture[0].filled[y][x0], 2u * (x1 - x0));
        }
    }
    pair_free(pair);
}

/* A gap is too few for most frames: what is painted so far is painted again, in bands of which the least are lines. */
static void without_room_for_gaps_some_is_filled_again(void **state)
{
    struct pair *pair = pair_new(&((struct room_stage *)*state)->scene.scene, LIM_NEAREST_FIRST, true);
    int banded = 0;

    for (int i = 0; i < VIEWS; i++) {
        const struct lim_camera camera = view(*state);
        assert_int_equal(draw(pair, &camera), 0);
        assert_same(pair);
        assert_int_equal(pair->picture[1].shown, 1);
        assert_int_equal(pair->picture[1].done, 0);
        assert_in_range(lim_bands(&pair->of.lim[1]), 0, H_PX);
        banded += lim_bands(&pair->of.lim[1]) > 0;
        for (int px = 0; px < W_PX * H_PX; px++)
            assert_in_range(pair->picture[1].times[px / W_PX][px % W_PX], 1, 8);
    }
    assert_true(banded > 0);
    pair_free(pair);
}

static void what_show_returns_comes_through(void **state)
{
    struct pair *pair = pair_new(&((struct room_stage *)*state)->scene.scene, LIM_NEAREST_FIRST, false);
    const struct lim_camera camera = view(*state);

    pair->picture[1].shows = FAILURE;
    assert_int_equal(draw(pair, &camera), FAILURE);
    pair->picture[1].shows = 0;
    assert_int_equal(draw(pair, &camera), 0);
    assert_same(pair);
    pair_free(pair);
}

/* Draws some views, none of which may be filled. */
static void assert_lines(struct room_stage *f, struct pair *pair)
{
    for (int i = 0; i < 4; i++) {
        const struct lim_camera camera = view(f);
        assert_int_equal(draw(pair, &camera), 0);
        assert_same(pair);
        assert_int_equal(pair->picture[1].pieces, 0);
        assert_int_equal(pair->picture[1].shown, 0);
        assert_true(pair->picture[1].done > 0);
    }
    pair_free(pair);
}

static void other_orders_come_by_lines(void **state)
{
    static const enum lim_method OTHERS[] = {LIM_PAINTER, LIM_SCANLINE, LIM_DEPTH, LIM_NEWELL};
    struct room_stage *f = *state;

    for (size_t i = 0; i < sizeof OTHERS / sizeof OTHERS[0]; i++)
        assert_lines(f, pair_new(&f->scene.scene, OTHERS[i], false));
}

static void outlines_and_smooth_edges_come_by_lines(void **state)
{
    struct room_stage *f = *state;
    static uint32_t sums[2][LIM_ANTIALIAS_MEM_B(W_PX) / 4 + 1];
    struct pair *wire = pair_new(&f->scene.scene, LIM_NEAREST_FIRST, false);
    struct pair *smooth = pair_new(&f->scene.scene, LIM_NEAREST_FIRST, false);

    for (int i = 0; i < 2; i++) {
        lim_set_wireframe(&wire->of.lim[i], &(const struct lim_wireframe){.on = true});
        assert_int_equal(lim_set_antialias(&smooth->of.lim[i], sums[i], sizeof sums[i]), LIM_OK);
    }
    assert_lines(f, wire);
    assert_lines(f, smooth);
}

/* A scene that says that some of it is transparent, though nothing is. */
static void transparent_scenes_come_by_lines(void **state)
{
    struct room_stage *f = *state;
    struct lim_scene scene = f->scene.scene;

    scene.limits.layers = 1;
    assert_lines(f, pair_new(&scene, LIM_NEAREST_FIRST, false));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_filled_frame_is_what_lines_make, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(round_glass_is_filled_where_it_is_seen, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(without_room_for_gaps_some_is_filled_again, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(what_show_returns_comes_through, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(other_orders_come_by_lines, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(outlines_and_smooth_edges_come_by_lines, set_up, room_stage_tear_down),
        cmocka_unit_test_setup_teardown(transparent_scenes_come_by_lines, set_up, room_stage_tear_down),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
