/* SPDX-License-Identifier: MIT
 *
 * Frames of meshes without a tree: the same picture with any memory, after any frame, through any target; what is no
 * such mesh, and what meshes do not have, is refused. */
#include "colour.h"
#include "overlay.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "rigs/set_rig.h"
#include "unit/firmware/soup_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 60, H_PX = 45, STRIDE_PX = 62, LINE_B = 2 * STRIDE_PX, PICTURE_B = H_PX * LINE_B };

static struct soup soup;

static const enum lim_method orders[] = {LIM_MESH, LIM_MESH_DEPTH};

/* A scene and a camera for it; depth begins at any of its triangles, or nowhere. */
static struct lim_camera make(struct random *random, unsigned kind)
{
    soup_random(&soup, random, kind, 3000);
    *soup.scene.deep_from = (lim_index)random_in(random, -20, (int)soup.scene.polygon_count + 20);
    if ((int)*soup.scene.deep_from < 0) *soup.scene.deep_from = 0;
    *soup.scene.near_deep_from = (lim_index)random_in(random, 0, (int)*soup.scene.deep_from);
    return soup_camera(random, random_u64(random) & 1 ? 9000 : 2000);
}

static void begin(struct soup_view *view, const struct core *core, enum lim_method method, size_t mem_b)
{
    assert_int_equal(soup_view_init(view, core, &soup, method, W_PX, H_PX, mem_b, 0x5A), LIM_OK);
    assert_int_equal(view->stride_px, STRIDE_PX);
}

/* What a renderer shows that has drawn nothing before, from as much memory as is comfortable. */
static void draw_alone(const struct core *core, enum lim_method method, const struct lim_camera *camera, uint16_t *out)
{
    struct soup_view view;

    begin(&view, core, method, 0);
    assert_int_equal(soup_view_draw(&view, camera), LIM_OK);
    memcpy(out, view.pixels, PICTURE_B);
    soup_view_free(&view);
}

typedef void trial(const struct core *core, struct random *random, enum lim_method method, unsigned kind);

static void try_all(trial *one, int times, uint64_t seed)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_or_sub_bits(found);

    for (size_t k = 0; k < count; k++) {
        struct random random = {seed + k};
        for (int i = 0; i < effort(times); i++)
            for (int m = 0; m < 2; m++)
                one(found[k], &random, orders[m], (unsigned)i % SOUP_KINDS);
    }
}

/* Memory ---------------------------------------------------------------------------------------------------------- */

static uint16_t expected[PICTURE_B / 2];
static uint64_t parts;

static void try_memory(const struct core *core, struct random *random, enum lim_method method, unsigned kind)
{
    const struct lim_camera camera = make(random, kind);
    const struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = method};
    const size_t least_b = core->mem_min_b(&soup.scene, &target), most_b = core->mem_b(&soup.scene, &target);
    struct soup_view view;

    draw_alone(core, method, &camera, expected);
    for (size_t mem_b = least_b; mem_b <= most_b; mem_b += 1 + (most_b - least_b) / 23) {
        begin(&view, core, method, mem_b);
        assert_int_equal(core->bands(view.lim), 0);
        for (int frame = 0; frame < 2; frame++) {
            assert_int_equal(soup_view_draw(&view, &camera), LIM_OK);
            assert_memory_equal(view.pixels, expected, PICTURE_B);
            assert_int_equal(core->bands(view.lim), core->stats(view.lim)->bands);
            parts += core->bands(view.lim);
        }
        soup_view_free(&view);
    }
    assert_int_equal(soup_view_init(&view, core, &soup, method, W_PX, H_PX, least_b - 1, 0), LIM_ERR_MEMORY);
    soup_view_free(&view);
}

static void any_memory_gives_the_same_picture(void **state)
{
    (void)state;
    try_all(try_memory, 60, 101);
    assert_true(parts > 0);
}

enum { SHEET_SIDE = 16 };

/* A bumpy sheet of small triangles, turned so that its rows are not the screen's. */
static struct lim_camera make_sheet(struct random *random)
{
    const double step = 240.0;

    soup_init(&soup);
    for (int i = 0; i <= SHEET_SIDE; i++)
        for (int j = 0; j <= SHEET_SIDE; j++) {
            const double x = (j - SHEET_SIDE / 2) * step, y = (i - SHEET_SIDE / 2) * step;
            (void)soup_vertex(&soup, 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, 300 * random_unit(random));
        }
    for (int i = 0; i < SHEET_SIDE; i++)
        for (int j = 0; j < SHEET_SIDE; j++) {
            const lim_index low = (lim_index)(i * (SHEET_SIDE + 1) + j), high = (lim_index)(low + SHEET_SIDE + 1);
            soup_triangle(&soup, low, (lim_index)(low + 1), high);
            soup_triangle(&soup, (lim_index)(low + 1), (lim_index)(high + 1), high);
        }
    soup_done(&soup, (lim_index)(soup.scene.polygon_count - 20));
    return (struct lim_camera){
        .eye_q8 = {0, 0, 6000 * 256}, .tan_x_q28 = 120000000, .tan_y_q28 = 90000000, .near_q8 = 256};
}

/* How often triangles begin in a pool of so many. */
static struct lim_stats begins_with(const struct core *core, enum lim_method method, const struct lim_camera *camera,
                                    uint16_t active)
{
    const struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = method};
    const uint16_t limit = soup.scene.limits.active;
    struct soup_view view;

    soup.scene.limits.active = active;
    begin(&view, core, method, core->mem_b(&soup.scene, &target));
    assert_int_equal(soup_view_draw(&view, camera), LIM_OK);
    const struct lim_stats stats = *core->stats(view.lim);
    soup_view_free(&view);
    soup.scene.limits.active = limit;
    return stats;
}

static void try_less(const struct core *core, struct random *random, enum lim_method method, unsigned kind)
{
    const struct lim_camera camera = make_sheet(random);
    const struct lim_stats all = begins_with(core, method, &camera, soup.scene.limits.active);
    const struct lim_stats most = begins_with(core, method, &camera, (uint16_t)(all.active_max * 7 / 10));
    const struct lim_stats half = begins_with(core, method, &camera, (uint16_t)(all.active_max / 2));

    (void)kind;
    assert_true(all.active_max > 24);
    assert_true(!all.bands && most.bands && half.bands);
    assert_true(most.polygons_seen * 10 < all.polygons_seen * 14);
    assert_true(half.polygons_seen * 10 < all.polygons_seen * 16);
}

/* A line that is too full begins what has no room anew, and no more. When it began all of its triangles anew they were
 * 1.6 and 1.8 times as many. */
static void few_begin_again_in_less_memory(void **state)
{
    (void)state;
    try_all(try_less, 4, 102);
}

static void try_no_depth(const struct core *core, struct random *random, enum lim_method method, unsigned kind)
{
    static uint16_t by_distance[PICTURE_B / 2];
    const struct lim_camera camera = make(random, kind);

    *soup.scene.deep_from = *soup.scene.near_deep_from = soup.scene.polygon_count;
    draw_alone(core, method, &camera, expected);
    draw_alone(core, LIM_MESH, &camera, by_distance);
    assert_memory_equal(by_distance, expected, PICTURE_B);
}

static void without_depth_distance_decides(void **state)
{
    (void)state;
    try_all(try_no_depth, 60, 103);
}

/* One after another ----------------------------------------------------------------------------------------------- */

static void try_turns(const struct core *core, struct random *random, enum lim_method method, unsigned kind)
{
    const struct lim_camera first = make(random, kind);
    const struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = method};
    struct soup_view view;

    begin(&view, core, method, kind & 1 ? core->mem_min_b(&soup.scene, &target) : 0);
    for (int frame = 0; frame < 4; frame++) {
        const struct lim_camera camera = frame ? soup_camera(random, 1000 + 4000 * random_unit(random)) : first;
        draw_alone(core, method, &camera, expected);
        view.fails_at = (int)random_in(random, 0, H_PX - 1);
        assert_int_equal(soup_view_draw(&view, &camera), -4711);
        assert_int_equal(view.done_lines, view.fails_at);
        view.fails_at = -1;
        view.lends_to = (int)random_in(random, 0, H_PX - 1);
        assert_int_equal(soup_view_draw(&view, &camera), LIM_ERR_TARGET);
        assert_int_equal(view.done_lines, view.lends_to);
        view.lends_to = -1;
        assert_int_equal(soup_view_draw(&view, &camera), LIM_OK);
        assert_memory_equal(view.pixels, expected, PICTURE_B);
    }
    soup_view_free(&view);
}

static void a_frame_leaves_nothing_for_the_next(void **state)
{
    (void)state;
    try_all(try_turns, 60, 107);
}

static void try_in_parts(const struct core *core, struct random *random, enum lim_method method, unsigned kind)
{
    const struct lim_camera camera = make(random, kind);
    struct soup_view view;

    draw_alone(core, method, &camera, expected);
    begin(&view, core, method, 0);
    assert_int_equal(core->paint(view.lim), LIM_ERR_BEGIN);
    assert_int_equal(core->begin(view.lim, &camera, NULL, 0), LIM_OK);
    assert_false(core->work(view.lim));
    memcpy(view.pixels, expected, PICTURE_B); /* what lies beside the lines */
    for (int i = 0; i < H_PX; i++)
        memset(view.pixels + i * STRIDE_PX, 0x77, 2 * W_PX);
    assert_int_equal(core->paint(view.lim), LIM_OK);
    assert_memory_equal(view.pixels, expected, PICTURE_B);
    assert_int_equal(core->paint(view.lim), LIM_ERR_BEGIN);
    soup_view_free(&view);
}

static void a_frame_in_parts_is_the_same(void **state)
{
    (void)state;
    try_all(try_in_parts, 12, 109);
}

/* Targets --------------------------------------------------------------------------------------------------------- */

struct paper {
    _Alignas(4) uint16_t lines[H_PX][STRIDE_PX];
    uint16_t shown[H_PX][STRIDE_PX];
    uint32_t sent_px;
    bool is_round;
};

static void *paper_lend(void *ctx, uint16_t y_px)
{
    return ((struct paper *)ctx)->lines[y_px];
}

static int paper_done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct paper *paper = ctx;

    assert_true(x_px + n_px <= W_PX);
    memcpy(&paper->shown[y_px][x_px], &paper->lines[y_px][x_px], 2u * n_px);
    paper->sent_px += n_px;
    return 0;
}

static int paper_window(void *ctx, const struct lim_rect *window)
{
    (void)ctx, (void)window;
    return 0;
}

/* An ellipse, of which the first and the last lines have nothing. */
static void paper_visible(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    const int cut = 2 * abs((int)y_px - H_PX / 2);

    (void)ctx;
    *x0_px = (uint16_t)(cut < W_PX / 2 ? cut : W_PX / 2);
    *x1_px = (uint16_t)(W_PX - *x0_px);
}

static void paper_fill(void *ctx, uint16_t x0_px, uint16_t x1_px)
{
    (void)ctx, (void)x0_px, (void)x1_px;
    fail_msg("a mesh comes by lines");
}

static void draw_box(void *ctx, const struct lim_overlay_line *line)
{
    (void)ctx;
    lim_overlay_box(line, &(const struct lim_overlay_box){5, 7, 30, 11}, 0xFFFF);
}

static bool is_seen(const struct paper *paper, int x, int y)
{
    uint16_t x0, x1;

    if (!paper->is_round) return true;
    paper_visible(NULL, (uint16_t)y, &x0, &x1);
    return x >= x0 && x < x1;
}

/* Windows may reach over what is not seen. */
static void check(const struct paper *paper, bool has_box, bool sends_windows)
{
    for (int y = 0; y < H_PX; y++)
        for (int x = 0; x < W_PX; x++) {
            const bool in_box = has_box && x >= 5 && x < 35 && y >= 7 && y < 18;
            const uint16_t wanted = in_box ? lim_memory_colour(0xFFFF) : expected[y * STRIDE_PX + x];
            if (is_seen(paper, x, y))
                assert_int_equal(paper->shown[y][x], wanted);
            else if (!sends_windows)
                assert_int_equal(paper->shown[y][x], 0x1234);
        }
}

static struct paper paper;

static void try_target(const struct core *core, struct random *random, enum lim_method method, unsigned kind,
                       unsigned options)
{
    static const struct lim_overlay overlay = {.draw = draw_box, .y0_px = 3, .y1_px = 40};
    struct lim_target target = {.w_px = W_PX,
                                .h_px = H_PX,
                                .method = method,
                                .ctx = &paper,
                                .lend = paper_lend,
                                .done = paper_done,
                                .visible = options & 1 ? paper_visible : NULL,
                                .window = paper_window,
                                .costs = {.window_b = 11, .pixel_bits = 16, .page_px = 1, .x_align_px = 1}};
    struct lim_camera camera = make(random, kind);
    const size_t delta_b = LIM_DELTA_MEM_B(W_PX, H_PX, 500);
    void *lim = malloc(core->lim_b), *mem = malloc(core->mem_b(&soup.scene, &target)), *delta = malloc(delta_b);

    assert_true(lim && mem && delta);
    if (options & 8) target.framebuffer = (struct lim_framebuffer){paper.lines, STRIDE_PX};
    if (options & 16) target.fill = paper_fill;
    assert_int_equal(core->init(lim, &soup.scene, &target, mem, core->mem_b(&soup.scene, &target)), LIM_OK);
    if (options & 2) core->set_overlay(lim, &overlay);
    if (options & 4) assert_int_equal(core->set_delta(lim, delta, delta_b), LIM_OK);
    core->set_wireframe(lim, &(const struct lim_wireframe){.on = options & 1}); /* meshes have none */
    paper.is_round = options & 1;
    for (int y = 0; y < H_PX; y++)
        for (int x = 0; x < STRIDE_PX; x++)
            paper.shown[y][x] = 0x1234;
    for (int frame = 0; frame < 4; frame++) {
        if (frame != 2) camera.roll += 1 << 22; /* one is the same as the one before */
        draw_alone(core, method, &camera, expected);
        paper.sent_px = 0;
        assert_int_equal(core->frame(lim, &camera), LIM_OK);
        check(&paper, options & 2, options & 4);
        if (options & 4 && frame == 2) assert_int_equal(paper.sent_px, 0);
        if (!(options & 5)) assert_int_equal(paper.sent_px, W_PX * H_PX);
    }
    free(lim);
    free(mem);
    free(delta);
}

static void try_targets(const struct core *core, struct random *random, enum lim_method method, unsigned kind)
{
    for (unsigned options = 0; options < 32; options++)
        try_target(core, random, method, kind, options);
}

static void any_target_shows_the_same(void **state)
{
    (void)state;
    try_all(try_targets, 6, 113);
}

/* What is refused ------------------------------------------------------------------------------------------------- */

static int init_as(const struct core *core, const struct lim_scene *scene, enum lim_method method, void *lim)
{
    static uint64_t mem[60000];
    const struct lim_target target = {
        .w_px = W_PX, .h_px = H_PX, .method = method, .ctx = &paper, .lend = paper_lend, .done = paper_done};

    return core->init(lim, scene, &target, mem, sizeof mem);
}

static void scenes_and_methods_that_do_not_fit_are_refused(void **state)
{
    static struct set set;
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_find(found);
    struct random random = {127};

    (void)state;
    (void)make(&random, 1);
    set_init(&set);
    for (size_t k = 0; k < count; k++) {
        void *lim = malloc(found[k]->lim_b);
        assert_non_null(lim);
        for (enum lim_method method = LIM_NEAREST_FIRST; method <= LIM_MESH_DEPTH; method++)
            assert_int_equal(init_as(found[k], &soup.scene, method, lim), method < LIM_MESH ? LIM_ERR_SCENE : LIM_OK);
        for (int m = 0; m < 2; m++) {
            struct lim_scene boxless = soup.scene;
            boxless.box_count = 0;
            assert_int_equal(init_as(found[k], &set.scene, orders[m], lim), LIM_ERR_SCENE);
            assert_int_equal(init_as(found[k], &boxless, orders[m], lim), LIM_ERR_SCENE);
        }
        free(lim);
    }
}

static void what_meshes_do_not_have_is_refused(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_find(found);
    const struct lim_movers_limits limits = {.instances = 1, .depth = 1};
    const struct lim_instance instance = {.object = &soup.scene,
                                          .axes_q30 = {1 << 30, 0, 0, 0, 1 << 30, 0, 0, 0, 1 << 30}};
    struct random random = {131};

    (void)state;
    const struct lim_camera camera = make(&random, 1);
    for (size_t k = 0; k < count * 2; k++) {
        const struct core *core = found[k / 2];
        struct soup_view view;
        draw_alone(core, orders[k % 2], &camera, expected);
        begin(&view, core, orders[k % 2], 0);
        void *mem = malloc(LIM_ANTIALIAS_MEM_B(W_PX)), *movers = malloc(core->movers_mem_b(&soup.scene, &limits));
        assert_int_equal(core->set_antialias(view.lim, mem, LIM_ANTIALIAS_MEM_B(W_PX)), LIM_ERR_TARGET);
        assert_int_equal(core->set_antialias(view.lim, NULL, 0), LIM_OK);
        assert_int_equal(core->movers_init(view.lim, movers, core->movers_mem_b(&soup.scene, &limits), &limits),
                         LIM_OK);
        assert_int_equal(soup_view_draw(&view, &camera), LIM_OK);
        view.done_lines = 0;
        assert_int_equal(core->movers_frame(view.lim, &camera, &instance, 1), LIM_OK);
        assert_int_equal(core->stats(view.lim)->movers.left_out, 1);
        assert_memory_equal(view.pixels, expected, PICTURE_B);
        free(mem);
        free(movers);
        soup_view_free(&view);
    }
}

static void nothing_is_background(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_find(found);
    struct random random = {137};

    (void)state;
    for (int has_vertices = 0; has_vertices < 2; has_vertices++)
        for (size_t k = 0; k < count * 2; k++) {
            struct soup_view view;
            soup_init(&soup);
            if (has_vertices) soup_vertex(&soup, 100, 100, 100);
            soup_done(&soup, 0);
            soup.scene.background = 0x4321;
            const struct lim_camera camera = soup_camera(&random, 1000);
            begin(&view, found[k / 2], orders[k % 2], 0);
            assert_int_equal(soup_view_draw(&view, &camera), LIM_OK);
            for (uint16_t y = 0; y < H_PX; y++)
                for (uint16_t x = 0; x < W_PX; x++)
                    assert_int_equal(soup_view_at(&view, x, y), 0x4320);
            soup_view_free(&view);
        }
}

/* Screens' borders ------------------------------------------------------------------------------------------------ */

enum { BORDER_SIDE = 3000, BORDER_MOST_PX = 64 };

/* A square that fills its box, seen from in front: 2 BORDER_SIDE units wide. */
static void make_square(void)
{
    soup_init(&soup);
    for (int k = 0; k < 4; k++)
        (void)soup_vertex(&soup, k & 1 ? BORDER_SIDE : -BORDER_SIDE, k & 2 ? BORDER_SIDE : -BORDER_SIDE, 0);
    soup_triangle(&soup, 0, 1, 3);
    soup_triangle(&soup, 0, 3, 2);
    soup_done(&soup, 1);
}

/* Where along a screen's side the square begins and ends, pixels; one end lies a few pixels beside the border. */
struct border {
    double from_px, to_px;
    int32_t eye_q8;
};

static struct border border_of(struct random *random, double units_in_px, uint16_t side_px, bool is_close)
{
    const double half_px = BORDER_SIDE / units_in_px, off_px = 6 * random_unit(random) - 3;
    const double close_px = random_u64(random) & 1 ? side_px - half_px : half_px;
    const double middle_px = off_px + (is_close ? close_px : side_px / 2.0);
    const int32_t eye_q8 = (int32_t)lrint((side_px / 2.0 - middle_px) * units_in_px * 256);
    const double middle_really_px = side_px / 2.0 - eye_q8 / (256 * units_in_px);

    return (struct border){middle_really_px - half_px, middle_really_px + half_px, eye_q8};
}

/* Whether a pixel's centre is covered, 1 or 0; -1: rounding decides. */
static int covers(const struct border *border, uint16_t at_px, double rounding_px)
{
    const double centre_px = at_px + 0.5;

    if (fabs(centre_px - border->from_px) < rounding_px || fabs(centre_px - border->to_px) < rounding_px) return -1;
    return centre_px > border->from_px && centre_px < border->to_px;
}

static void try_border(const struct core *core, struct random *random, enum lim_method method, unsigned kind)
{
    const uint16_t w_px = (uint16_t)random_in(random, 1, BORDER_MOST_PX),
                   h_px = (uint16_t)random_in(random, 1, BORDER_MOST_PX);
    const double size = (kind & 1 ? 0.6 : 0.99) + 0.06 * random_unit(random); /* of the smaller side */
    const double units_in_px = 2 * BORDER_SIDE / (size * (w_px < h_px ? w_px : h_px)),
                 tan_x = 0.2 + random_unit(random);
    const double away = units_in_px * w_px / 2 / tan_x, rounding_px = core->sub_bits ? 0.05 : 1.2;
    if (away > 30000 || tan_x * h_px / w_px * (1 << 28) > LIM_TAN_MAX_Q28) return;
    /* y goes up, and down on the screen */
    const struct border across = border_of(random, units_in_px, w_px, kind & 2),
                        down = border_of(random, units_in_px, h_px, kind & 4);
    const struct lim_camera camera = {.eye_q8 = {across.eye_q8, -down.eye_q8, (int32_t)lrint(away * 256)},
                                      .tan_x_q28 = (uint32_t)lrint(tan_x * (1 << 28)),
                                      .tan_y_q28 = (uint32_t)lrint(tan_x * h_px / w_px * (1 << 28)),
                                      .near_q8 = 256};
    struct soup_view view;

    make_square();
    assert_int_equal(soup_view_init(&view, core, &soup, method, w_px, h_px, 0, 0x5A), LIM_OK);
    assert_int_equal(soup_view_draw(&view, &camera), LIM_OK);
    for (uint16_t y = 0; y < h_px; y++)
        for (uint16_t x = 0; x < w_px; x++) {
            const int on_row = covers(&down, y, rounding_px), on_column = covers(&across, x, rounding_px);
            if (on_row < 0 || on_column < 0) continue;
            assert_int_equal(soup_view_at(&view, x, y) >= 0, on_row && on_column);
        }
    soup_view_free(&view);
}

static void what_ends_beside_the_border_is_there_to_the_border(void **state)
{
    (void)state;
    try_all(try_border, 4000, 211);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_memory_gives_the_same_picture),
        cmocka_unit_test(few_begin_again_in_less_memory),
        cmocka_unit_test(without_depth_distance_decides),
        cmocka_unit_test(a_frame_leaves_nothing_for_the_next),
        cmocka_unit_test(a_frame_in_parts_is_the_same),
        cmocka_unit_test(any_target_shows_the_same),
        cmocka_unit_test(scenes_and_methods_that_do_not_fit_are_refused),
        cmocka_unit_test(what_meshes_do_not_have_is_refused),
        cmocka_unit_test(nothing_is_background),
        cmocka_unit_test(what_ends_beside_the_border_is_there_to_the_border),
    };

    return cmocka_run_group_tests_name("mesh_frames", tests, NULL, NULL);
}
