/* SPDX-License-Identifier: MIT
 *
 * Stages without a renderer: each order of drawing, the sorted list, the walk and the movers are handed their own
 * structs, on a pass that is put together by hand, and draw and say what lim_frame() does. */
#include "compiler/compile_mesh.h"
#include "eye.h"
#include "limner.h"
#include "movers/meet.h"
#include "movers/mover.h"
#include "orders/convex.h"
#include "orders/nearest.h"
#include "orders/painter.h"
#include "pieces/sorted.h"
#include "rigs/closed_stage.h"
#include "rigs/cmocka_ready.h"
#include "rigs/convex_rig.h"
#include "rigs/plain_lines.h"
#include "rigs/set_rig.h"
#include "view/cull.h"
#include "view/pass.h"
#include "view/view.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 96, H_PX = 72, SCENES = 6, FRAMES = 8, SOLIDS = 16 };

/* The same frame by lim_frame(), and by a stage that has nothing but its own. */
struct two {
    const struct lim_scene *scene;
    struct lim lim;
    struct lim_pass pass;
    struct lim_sorter sorter;
    struct lim_movers movers;
    struct lim_mesh_leaf leaf;
    void *mem[2];
    size_t mem_b;
    struct plain_lines lines[2];
    uint16_t pixels[2][H_PX][W_PX];
};

/* The pass has a scene and a target; the stage's own memory is shared out by it. */
static void two_open(struct two *two, const struct lim_scene *scene, enum lim_method method)
{
    memset(two, 0, sizeof *two);
    two->scene = scene;
    for (int i = 0; i < 2; i++)
        two->lines[i] = (struct plain_lines){two->pixels[i][0], W_PX};
    const struct lim_target target = plain_lines_target(&two->lines[0], W_PX, H_PX, method);
    two->mem_b = lim_mem_b(scene, &target);
    for (int i = 0; i < 2; i++)
        assert_non_null(two->mem[i] = malloc(two->mem_b));
    assert_int_equal(lim_init(&two->lim, scene, &target, two->mem[0], two->mem_b), LIM_OK);
    two->pass.scene = scene;
    two->pass.target = plain_lines_target(&two->lines[1], W_PX, H_PX, method);
    two->sorter.pass = &two->pass;
}

static void two_close(struct two *two)
{
    free(two->mem[0]);
    free(two->mem[1]);
}

static void take_camera_in(struct two *two, const struct lim_camera *camera)
{
    assert_true(lim_view_begin(&two->pass.view, two->scene, camera));
    lim_eye_set(lim_eye_of(&two->pass), two->scene, camera->eye_q8);
    memset(two->pixels, 0xA5, sizeof two->pixels);
    assert_int_equal(lim_frame(&two->lim, camera), LIM_OK);
}

static void assert_same(const struct two *two)
{
    assert_memory_equal(two->pixels[1], two->pixels[0], sizeof two->pixels[0]);
}

static void draw_nearest(struct two *two, const struct closed_stage *stage, struct random *random)
{
    struct lim_nearest nearest = {.pass = &two->pass,
                                  .sorter = {&two->sorter},
                                  .movers = {&two->movers},
                                  .leaf = {&two->leaf},
                                  .paint = {.pass = &two->pass, .actives.movers = {&two->movers}}};

    lim_nearest_init(&nearest, two->mem[1], two->mem_b);
    for (int i = 0; i < FRAMES; i++) {
        const struct lim_camera camera = closed_stage_camera(stage, random);
        take_camera_in(two, &camera);
        nearest.bands = 0;
        assert_int_equal(lim_nearest_frame(&nearest, LIM_AHEAD_BEGUN), 0);
        assert_same(two);
        assert_int_equal(nearest.bands, lim_bands(&two->lim));
    }
}

static void draw_painter(struct two *two, const struct closed_stage *stage, struct random *random)
{
    struct lim_painter painter = {.pass = &two->pass, .sorter = {&two->sorter}, .leaf = {&two->leaf}};

    lim_painter_init(&painter, two->mem[1]);
    for (int i = 0; i < FRAMES; i++) {
        const struct lim_camera camera = closed_stage_camera(stage, random);
        take_camera_in(two, &camera);
        assert_int_equal(lim_painter_frame(&painter), 0);
        assert_same(two);
    }
}

static void orders_draw_with_their_own_structs(void **state)
{
    static const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest"};
    static const enum lim_method drawn[] = {LIM_NEAREST_FIRST, LIM_SCANLINE, LIM_DEPTH, LIM_NEWELL, LIM_PAINTER};
    static struct two two;
    struct random random = {61};

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        struct closed_stage stage;
        closed_stage_make(&stage, &random);
        closed_stage_compile(&stage, &options, W_PX, H_PX);
        for (size_t m = 0; m < sizeof drawn / sizeof *drawn; m++) {
            two_open(&two, &stage.scene.scene, drawn[m]);
            if (drawn[m] == LIM_PAINTER)
                draw_painter(&two, &stage, &random);
            else
                draw_nearest(&two, &stage, &random);
            two_close(&two);
        }
        closed_stage_close(&stage);
    }
}

static bool solid_camera(struct random *random, const struct compiled *scene, struct lim_camera *camera)
{
    struct viewpoint viewpoint = convex_rig_viewpoint(random);
    const struct camera_path path = {"random", &viewpoint, 1};
    struct lens lens;
    struct error err;

    assert_true(lens_init(&lens, 60, 0.1, W_PX, H_PX, &err));
    return camera_path_to_camera(&path, 0, &lens, &scene->grid, camera, &err);
}

static void a_solid_is_drawn_with_its_own_struct(void **state)
{
    static struct two two;
    struct random random = {62};
    struct error err;
    unsigned frames = 0;

    (void)state;
    for (unsigned s = 0; s < SOLIDS; s++) {
        struct mesh mesh = mesh_rig(1000);
        struct compiled scene;
        convex_rig_add(&mesh, &random, s % CONVEX_RIG_KINDS);
        assert_true(
            compile_mesh(&mesh, &(struct compile_options){.tolerance_units = 0.5, .splitter = "fewest"}, &scene, &err));
        two_open(&two, &scene.scene, LIM_CONVEX);
        struct lim_convex convex = {.pass = &two.pass};
        lim_convex_init(&convex, two.mem[1], two.mem_b);
        for (int i = 0; i < FRAMES; i++) {
            struct lim_camera camera;
            if (!solid_camera(&random, &scene, &camera)) continue;
            take_camera_in(&two, &camera);
            assert_int_equal(lim_convex_frame(&convex), 0);
            assert_same(&two);
            frames++;
        }
        two_close(&two);
        compiled_free(&scene);
        mesh_rig_free(&mesh);
    }
    assert_true(frames > SOLIDS * FRAMES / 2);
}

/* Squares at depths that fall and rise: the list is from the nearest to the farthest. */
static void a_list_is_sorted_with_its_own_struct(void **state)
{
    static const int16_t depths[] = {600, 100, 400, 200, 500, 300};
    enum { COUNT = sizeof depths / sizeof *depths };
    static struct set set;
    static struct two two;
    struct lim_sorted list[COUNT];
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    const struct lim_camera camera = set_camera(false);

    (void)state;
    set_init(&set);
    for (int i = 0; i < COUNT; i++) {
        const int16_t z = (int16_t)-depths[i];
        const int16_t corners[4][3] = {{-50, -50, z}, {50, -50, z}, {50, 50, z}, {-50, 50, z}};
        set_add(&set, (lim_index)(i + 1), 4, corners);
    }
    two_open(&two, &set.scene, LIM_DEPTH);
    lim_view_init(&two.pass.view, W_PX, H_PX, cache);
    take_camera_in(&two, &camera);
    two.sorter.list = list;
    two.sorter.size = COUNT;
    lim_sorted_order(&two.sorter);
    assert_int_equal(two.sorter.used, COUNT);
    int16_t before = 0;
    for (uint16_t at = two.sorter.first; at != LIM_NONE; at = list[at].next) {
        const int16_t depth = depths[set.polygons[list[at].record + 1] - 1];
        assert_true(depth > before);
        before = depth;
    }
    assert_int_equal(before, 600);
    two_close(&two);
}

/* An object before the camera and one behind it: one is in view, asked about the only run, and drawn behind that. */
static void movers_are_met_with_their_own_structs(void **state)
{
    static const int16_t corners[4][3] = {{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}};
    static struct set nothing, object;
    static struct two two;
    struct lim_mover posed[2];
    struct lim_route_pending stack[1];
    struct lim_route route;
    lim_index what;
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct lim_instance instances[2] = {{.object = &object.scene}, {.object = &object.scene}};
    const struct lim_camera camera = set_camera(false);

    (void)state;
    set_init(&nothing);
    set_add(&nothing, 1, 4, corners);
    set_init(&object);
    set_add(&object, 2, 4, corners);
    for (int i = 0; i < 2; i++)
        lim_instance_turn(&instances[i], 0, 0, 0);
    instances[0].at_q8[2] = 400 * 256;
    instances[1].at_q8[2] = -400 * 256;
    two_open(&two, &nothing.scene, LIM_NEAREST_FIRST);
    lim_view_init(&two.pass.view, W_PX, H_PX, cache);
    take_camera_in(&two, &camera);
    two.movers = (struct lim_movers){.instances = instances,
                                     .given = 2,
                                     .count = 2,
                                     .most = 2,
                                     .most_corners = LIM_MAX_VERTICES,
                                     .object_depth = 1,
                                     .movers = posed,
                                     .cache = cache,
                                     .stack = stack};
    lim_movers_pose(&two.movers, &two.pass, &camera);
    assert_int_equal(two.pass.stats->movers.left_out, 0);
    const struct lim_rect screen = {0, 0, W_PX, H_PX};
    lim_cull_set(lim_cull_of(&two.pass), &two.pass.view, lim_eye_of(&two.pass)->at_q8, &screen);
    lim_meet_begin(&route, &two.pass, &two.movers, lim_cull_of(&two.pass));
    assert_int_equal(two.pass.stats->movers.hidden, 1);
    assert_int_equal(route.list, 1);
    assert_int_equal(posed[1].next, LIM_NONE);
    assert_false(lim_meet_asks(&route));
    assert_int_equal(lim_meet_next(&route, &what), LIM_MEET_RUN);
    assert_int_equal(what, 0);
    assert_true(lim_meet_asks(&route));
    assert_int_equal(lim_meet_next(&route, &what), LIM_MEET_MOVER);
    assert_int_equal(what, 1);
    assert_int_equal(lim_meet_next(&route, &what), LIM_MEET_END);
    two_close(&two);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orders_draw_with_their_own_structs),
        cmocka_unit_test(a_solid_is_drawn_with_its_own_struct),
        cmocka_unit_test(a_list_is_sorted_with_its_own_struct),
        cmocka_unit_test(movers_are_met_with_their_own_structs),
    };
    return cmocka_run_group_tests_name("stage_structs", tests, NULL, NULL);
}
