/* SPDX-License-Identifier: MIT
 *
 * Frames with antialiased edges: how near they come to the true picture, that every order and any memory paints the
 * same, that nothing shines through seams, and what is refused. */
#include "accuracy/edge_error.h"
#include "compiler/compile.h"
#include "core/core.h"
#include "limner.h"
#include "render/simulator.h"
#include "rigs/closed_stage.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/mesh_rig.h"
#include "rigs/profiles.h"
#include "scene/compiled.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 90, H_PX = 70, SCENES = 8, FRAMES = 5, BAR_PX = 96, BAR_FRAMES = 2 };

struct canvas {
    uint16_t pixels[H_PX][W_PX];
    uint8_t done[H_PX][W_PX];
    int lent; /* the line that is lent and not done, or -1 */
};

static void *lend(void *ctx, uint16_t y_px)
{
    struct canvas *canvas = ctx;

    assert_int_equal(canvas->lent, -1);
    canvas->lent = y_px;
    return canvas->pixels[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct canvas *canvas = ctx;

    for (uint16_t x = x_px; x < x_px + n_px; x++)
        assert_int_equal(canvas->done[y_px][x]++, 0);
    canvas->lent = -1;
    return 0;
}

static struct lim_target target_on(struct canvas *canvas, enum lim_method method)
{
    return (struct lim_target){
        .w_px = W_PX, .h_px = H_PX, .format = LIM_RGB565, .method = method, .ctx = canvas, .lend = lend, .done = done};
}

/* With mem_b bytes, 0: with what the scene asks for. */
static void draw_seen(const struct compiled *scene, enum lim_method method, size_t mem_b, bool antialias,
                      const struct lim_camera *camera, lim_visible *visible, struct canvas *canvas,
                      struct lim_stats *stats)
{
    static uint32_t smooth_mem[LIM_ANTIALIAS_MEM_B(W_PX) / 4];
    struct lim_target target = target_on(canvas, method);
    target.visible = visible;
    const size_t size_b = mem_b ? mem_b : lim_mem_b(&scene->scene, &target);
    void *mem = malloc(size_b);
    struct lim lim;

    memset(canvas, 0xA5, sizeof *canvas);
    memset(canvas->done, 0, sizeof canvas->done);
    canvas->lent = -1;
    assert_int_equal(lim_init(&lim, &scene->scene, &target, mem, size_b), LIM_OK);
    if (antialias) assert_int_equal(lim_set_antialias(&lim, smooth_mem, sizeof smooth_mem), LIM_OK);
    assert_int_equal(lim_frame(&lim, camera), LIM_OK);
    for (int y = 0; y < H_PX; y++)
        for (int x = 0; x < W_PX; x++)
            assert_int_equal(canvas->done[y][x], 1);
    *stats = *lim_stats(&lim);
    free(mem);
}

static void draw(const struct compiled *scene, enum lim_method method, size_t mem_b, bool antialias,
                 const struct lim_camera *camera, struct canvas *canvas, struct lim_stats *stats)
{
    draw_seen(scene, method, mem_b, antialias, camera, NULL, canvas, stats);
}

/* glass: every other face of the solids is transparent. */
static void stage_open(struct closed_stage *stage, struct random *random, bool glass, bool antialias)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest", .antialias = antialias};

    closed_stage_make(stage, random);
    for (size_t i = stage->closed.first_face[0]; glass && i < stage->closed.model.face_count; i += 2)
        stage->closed.model.faces[i].transparency = 100;
    closed_stage_compile(stage, &options, W_PX, H_PX);
}

/* Memory and orders -------------------------------------------------------------------------- */

/* Nearest first or by scan lines, which close nothing beforehand: what is seen is the same. */
static void any_memory_paints_the_same(void **state)
{
    static const enum lim_method draws[] = {LIM_NEAREST_FIRST, LIM_SCANLINE};
    struct random random = {915};
    unsigned banded[2] = {0};

    (void)state;
    for (int s = 0; s < effort(SCENES); s++) {
        struct closed_stage stage;
        stage_open(&stage, &random, false, true);
        for (int f = 0; f < FRAMES; f++) {
            static struct canvas whole, part;
            const struct lim_camera camera = closed_stage_camera(&stage, &random);
            struct lim_stats stats;
            draw(&stage.scene, LIM_NEAREST_FIRST, 400000, true, &camera, &whole, &stats);
            for (int m = 0; m < 2; m++) {
                const struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = draws[m]};
                const size_t least_b = lim_mem_min_b(&stage.scene.scene, &target);
                const size_t most_b = lim_mem_b(&stage.scene.scene, &target);
                draw(&stage.scene, draws[m], 4 * most_b, true, &camera, &part, &stats);
                assert_memory_equal(whole.pixels, part.pixels, sizeof whole.pixels);
                draw(&stage.scene, draws[m],
                     f ? (size_t)random_in(&random, (int64_t)least_b, (int64_t)most_b) : least_b, true, &camera, &part,
                     &stats);
                banded[m] += stats.bands > 0;
                assert_memory_equal(whole.pixels, part.pixels, sizeof whole.pixels);
            }
        }
        closed_stage_close(&stage);
    }
    print_message("# antialias: %u frames ran out of memory, %u by scan lines\n", banded[0], banded[1]);
    assert_true(banded[0] >= (unsigned)effort(SCENES) && banded[1] >= (unsigned)effort(SCENES));
}

/* Where transparent polygons are too many for the memory, single lines are painted back to front, and not antialiased:
 * all of a line or nothing. */
static void scarce_memory_takes_edges_from_glass_by_whole_lines(void **state)
{
    struct random random = {916};
    unsigned as_smooth = 0, as_aliased = 0;

    (void)state;
    for (int s = 0; s < effort(SCENES); s++) {
        static struct canvas smooth, aliased, part;
        struct closed_stage stage;
        struct lim_stats stats;
        stage_open(&stage, &random, true, true);
        const struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = LIM_NEAREST_FIRST};
        const struct lim_camera camera = closed_stage_camera(&stage, &random);
        const size_t least_b = lim_mem_min_b(&stage.scene.scene, &target),
                     most_b = lim_mem_b(&stage.scene.scene, &target);
        draw(&stage.scene, LIM_NEAREST_FIRST, 4 * most_b, true, &camera, &smooth, &stats);
        draw(&stage.scene, LIM_NEAREST_FIRST, 0, false, &camera, &aliased, &stats);
        draw(&stage.scene, LIM_NEAREST_FIRST, least_b + (most_b - least_b) / 32, true, &camera, &part, &stats);
        for (int y = 0; y < H_PX; y++) {
            const bool is_smooth = memcmp(part.pixels[y], smooth.pixels[y], sizeof part.pixels[y]) == 0;
            const bool is_aliased = memcmp(part.pixels[y], aliased.pixels[y], sizeof part.pixels[y]) == 0;
            assert_true(is_smooth || is_aliased);
            as_smooth += is_smooth && !is_aliased;
            as_aliased += is_aliased && !is_smooth;
        }
        closed_stage_close(&stage);
    }
    print_message("# antialias: %u lines of glass as they should be, %u without\n", as_smooth, as_aliased);
    assert_true(as_smooth > 0 && as_aliased > 0);
}

/* The sorted orders compare and split what the tree has split: a sample or two beside a split edge may differ. */
static void newell_paints_what_the_tree_paints(void **state)
{
    struct random random = {917};
    unsigned different = 0, splits = 0;

    (void)state;
    for (int s = 0; s < effort(SCENES); s++) {
        struct closed_stage stage;
        stage_open(&stage, &random, false, true);
        for (int f = 0; f < FRAMES; f++) {
            static struct canvas tree, sorted;
            const struct lim_camera camera = closed_stage_camera(&stage, &random);
            struct lim_stats stats;
            draw(&stage.scene, LIM_NEAREST_FIRST, 0, true, &camera, &tree, &stats);
            draw(&stage.scene, LIM_NEWELL, 400000, true, &camera, &sorted, &stats);
            splits += stats.newell.splits;
            for (int i = 0; i < W_PX * H_PX; i++)
                different += tree.pixels[i / W_PX][i % W_PX] != sorted.pixels[i / W_PX][i % W_PX];
        }
        closed_stage_close(&stage);
    }
    print_message("# antialias: newell, %u splits, %u of %d pixels differ\n", splits, different,
                  effort(SCENES) * FRAMES * W_PX * H_PX);
    assert_true(different < (unsigned)effort(SCENES) * FRAMES * W_PX * H_PX / 2000);
}

/* Every face of one colour in front of a background of another: one sample that is left out shows. */
static void nothing_shines_through_seams(void **state)
{
    struct random random = {918};

    (void)state;
    for (int s = 0; s < effort(SCENES); s++) {
        struct closed_stage stage;
        stage_open(&stage, &random, false, true);
        lim_index *words = malloc(stage.scene.scene.polygon_words * sizeof *words);
        memcpy(words, stage.scene.scene.polygons, stage.scene.scene.polygon_words * sizeof *words);
        for (size_t at = 0; at < stage.scene.scene.polygon_words; at += lim_record_words(words[at]))
            words[at + 1] = 0xFFFF;
        const lim_index *const before = stage.scene.scene.polygons;
        stage.scene.scene.polygons = words;
        stage.scene.scene.background = 0;
        for (int f = 0; f < FRAMES; f++) {
            static struct canvas canvas;
            const struct lim_camera camera = closed_stage_camera(&stage, &random);
            struct lim_stats stats;
            draw(&stage.scene, LIM_NEAREST_FIRST, 0, true, &camera, &canvas, &stats);
            for (int i = 0; i < W_PX * H_PX; i++)
                assert_int_equal(canvas.pixels[i / W_PX][i % W_PX], 0xFFFF);
        }
        stage.scene.scene.polygons = before;
        free(words);
        closed_stage_close(&stage);
    }
}

/* Runs of lines ------------------------------------------------------------------------------ */

static lim_visible all_of_it;

static void all_of_it(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    (void)ctx;
    (void)y_px;
    *x0_px = 0;
    *x1_px = W_PX;
}

/* A round panel's lines are drawn one by one, those of others in runs if they can be. Here both have the same pixels.
 */
static void compare_runs(const struct compiled *scene, const struct lim_camera *camera)
{
    static const enum lim_method draws[] = {LIM_NEAREST_FIRST, LIM_SCANLINE};
    static struct canvas runs, lines;

    for (int m = 0; m < 2; m++)
        for (int memory = 0; memory < 2; memory++) {
            const struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = draws[m]};
            const size_t least_b = lim_mem_min_b(&scene->scene, &target), most_b = lim_mem_b(&scene->scene, &target);
            const size_t mem_b = memory ? least_b + (most_b - least_b) / 3 : most_b;
            struct lim_stats of_runs, of_lines;
            draw_seen(scene, draws[m], mem_b, true, camera, NULL, &runs, &of_runs);
            draw_seen(scene, draws[m], mem_b, true, camera, all_of_it, &lines, &of_lines);
            assert_memory_equal(runs.pixels, lines.pixels, sizeof runs.pixels);
            assert_int_equal(of_runs.pixels_painted, of_lines.pixels_painted);
            assert_int_equal(of_runs.pixels_background, of_lines.pixels_background);
            assert_int_equal(of_runs.bands, of_lines.bands);
        }
}

static void runs_paint_what_lines_do_in(const char *name)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "fewest", .antialias = true, .w_px = W_PX, .h_px = H_PX};
    char model[256], cameras[256];
    struct camera_path path = {0};
    struct compiled scene = {0};
    struct lens lens;
    struct error err;

    snprintf(model, sizeof model, "sim/scenes/%s.obj", name);
    snprintf(cameras, sizeof cameras, "sim/scenes/%s.cam", name);
    if (!compile_model(model, &options, &scene, &err) || !camera_path_read(cameras, &path, &err) ||
        !lens_init(&lens, 60, lens_default_near_m(&scene.grid), W_PX, H_PX, &err))
        fail_msg("%s", err.text);
    for (size_t f = 0; f < path.count; f += path.count / (size_t)effort(16) + 1) {
        struct lim_camera camera;
        assert_true(camera_path_to_camera(&path, f, &lens, &scene.grid, &camera, &err));
        compare_runs(&scene, &camera);
    }
    camera_path_free(&path);
    compiled_free(&scene);
}

static void runs_paint_what_lines_do(void **state)
{
    static const char *const models[] = {"rooms", "teapot", "knot"};
    struct random random = {921};

    (void)state;
    for (int m = 0; m < 3; m++)
        runs_paint_what_lines_do_in(models[m]);
    for (int s = 0; s < effort(SCENES); s++) {
        struct closed_stage stage;
        stage_open(&stage, &random, false, true);
        for (int f = 0; f < FRAMES; f++) {
            const struct lim_camera camera = closed_stage_camera(&stage, &random);
            compare_runs(&stage.scene, &camera);
        }
        closed_stage_close(&stage);
    }
}

/* Error -------------------------------------------------------------------------------------- */

static void open_model(const char *name, const struct core *core, struct compiled *scene, struct reference *reference,
                       struct camera_path *path)
{
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "auto",
                                            .antialias = true,
                                            .keep_faces = true,
                                            .core = core,
                                            .w_px = BAR_PX,
                                            .h_px = BAR_PX};
    char model[256], camera[256];
    struct error err;

    snprintf(model, sizeof model, "sim/scenes/%s.obj", name);
    snprintf(camera, sizeof camera, "sim/scenes/%s.cam", name);
    memset(scene, 0, sizeof *scene);
    memset(path, 0, sizeof *path);
    if (!compile_model(model, &options, scene, &err) || !camera_path_read(camera, path, &err) ||
        !reference_read(reference, model, &(struct orientation){0}, NULL, BAR_PX, BAR_PX, &err))
        fail_msg("%s", err.text);
}

static void measure(const char *name, const struct core *core, struct edge_error_sum *sum)
{
    const struct simulator_setup setup = {BAR_PX, BAR_PX, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, core};
    struct compiled scene;
    struct reference reference;
    struct camera_path path;
    struct edge_error edges;
    struct lens lens;
    struct error err;

    open_model(name, core, &scene, &reference, &path);
    assert_true(lens_init(&lens, 60, lens_default_near_m(&scene.grid), BAR_PX, BAR_PX, &err));
    assert_true(edge_error_init(&edges, &scene, &setup, &err));
    for (size_t i = 0; i < BAR_FRAMES; i++) {
        const size_t frame = i * path.count / BAR_FRAMES;
        struct lim_camera camera;
        assert_true(camera_path_to_camera(&path, frame, &lens, &scene.grid, &camera, &err));
        assert_true(edge_error_frame(&edges, &reference, &path.frames[frame], &lens, &camera, sum, &err));
    }
    edge_error_free(&edges);
    reference_free(&reference);
    camera_path_free(&path);
    compiled_free(&scene);
}

/* `draft` rounds the ends of edges to whole pixels: no sampling mends that. */
static void edges_are_a_quarter_as_wrong_at_most(void **state)
{
    static const char *const models[] = {"rooms", "teapot", "knot"};
    const struct core *const profiles[] = {&core_fast, &core_exact};

    (void)state;
    for (int m = 0; m < effort(3); m++)
        for (int p = 0; p < 2; p++) {
            struct edge_error_sum sum = {0};
            measure(models[m], profiles[p], &sum);
            const double aliased = edge_error_mean(&sum, EDGE_ERROR_ALIASED);
            const double smooth = edge_error_mean(&sum, EDGE_ERROR_SMOOTH);
            const double rounded = edge_error_mean(&sum, EDGE_ERROR_ROUNDED);
            print_message("# antialias: %s, %s: %.2f of 255 aliased, %.2f antialiased, of that %.2f the panel's\n",
                          models[m], profiles[p]->name, aliased, smooth, rounded);
            assert_true(sum.pixels > 500 && rounded > 0.5 && rounded < smooth);
            assert_true(smooth <= aliased / 4);
        }
}

/* Choice ------------------------------------------------------------------------------------- */

static void it_is_off_until_asked_for_and_can_be_turned_off(void **state)
{
    static uint32_t smooth_mem[LIM_ANTIALIAS_MEM_B(W_PX) / 4];
    static struct canvas canvas;
    static uint16_t aliased[H_PX][W_PX];
    struct random random = {919};
    struct closed_stage stage;
    struct lim lim;

    (void)state;
    stage_open(&stage, &random, false, false);
    const struct lim_camera camera = closed_stage_camera(&stage, &random);
    const struct lim_target target = target_on(&canvas, LIM_NEAREST_FIRST);
    const size_t mem_b = lim_mem_b(&stage.scene.scene, &target);
    void *mem = malloc(mem_b);
    canvas.lent = -1;
    assert_int_equal(lim_init(&lim, &stage.scene.scene, &target, mem, mem_b), LIM_OK);
    assert_int_equal(lim_set_antialias(&lim, smooth_mem, sizeof smooth_mem - 1), LIM_ERR_MEMORY);
    for (int i = 0; i < 3; i++) {
        memset(canvas.done, 0, sizeof canvas.done);
        assert_int_equal(lim_set_antialias(&lim, i == 1 ? smooth_mem : NULL, sizeof smooth_mem), LIM_OK);
        assert_int_equal(lim_frame(&lim, &camera), LIM_OK);
        if (i == 0) memcpy(aliased, canvas.pixels, sizeof aliased);
        assert_true((memcmp(aliased, canvas.pixels, sizeof aliased) == 0) == (i != 1));
    }
    free(mem);
    closed_stage_close(&stage);
}

static void orders_that_do_not_paint_nearest_first_refuse(void **state)
{
    static uint32_t smooth_mem[LIM_ANTIALIAS_MEM_B(W_PX) / 4];
    static struct canvas canvas;
    struct random random = {920};
    struct closed_stage stage;
    struct lim lim;

    (void)state;
    stage_open(&stage, &random, false, false);
    const struct lim_target target = target_on(&canvas, LIM_PAINTER);
    const size_t mem_b = lim_mem_b(&stage.scene.scene, &target);
    void *mem = malloc(mem_b);
    assert_int_equal(lim_init(&lim, &stage.scene.scene, &target, mem, mem_b), LIM_OK);
    assert_int_equal(lim_set_antialias(&lim, smooth_mem, sizeof smooth_mem), LIM_ERR_TARGET);
    assert_int_equal(lim_set_antialias(&lim, NULL, 0), LIM_OK);
    free(mem);
    closed_stage_close(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_memory_paints_the_same),
        cmocka_unit_test(scarce_memory_takes_edges_from_glass_by_whole_lines),
        cmocka_unit_test(newell_paints_what_the_tree_paints),
        cmocka_unit_test(nothing_shines_through_seams),
        cmocka_unit_test(runs_paint_what_lines_do),
        cmocka_unit_test(edges_are_a_quarter_as_wrong_at_most),
        cmocka_unit_test(it_is_off_until_asked_for_and_can_be_turned_off),
        cmocka_unit_test(orders_that_do_not_paint_nearest_first_refuse),
    };
    return cmocka_run_group_tests_name("antialias", tests, NULL, NULL);
}
