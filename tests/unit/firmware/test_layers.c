/* SPDX-License-Identifier: MIT
 *
 * The stack of what is transparent on a line, where its own memory is too small: it lies in what is idle, as far as
 * that goes; else the line is painted from far to near. The picture is the painter's in any case. */
#include "cameras/camera_path.h"
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "limner.h"
#include "lines/layers.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "scene/mcu_sizes.h"

#include <string.h>

enum { W_PX = 90, H_PX = 70, MOST_PANES = 200 };

static const double APART_M = 0.02;

/* Panes one behind the other, and one that is opaque at the end: each covers a line's pixels, so that so many layers
 * lie on it. */
static struct compiled panes_compiled(size_t count)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "balanced", .w_px = 8, .h_px = 8};
    struct mesh mesh = mesh_rig(3000.0);
    struct compiled scene;
    struct error err;

    for (size_t i = 0; i <= count; i++) {
        const double z = -APART_M * (double)i;
        const double corners[4][3] = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
        struct mesh_polygon *polygon = mesh_rig_add(&mesh, corners, 4);
        polygon->colour = (uint32_t)(0x102030 * i) & 0xFFFFFF;
        polygon->transparency = (uint8_t)(i < count ? 250 - i % 5 : 0);
        polygon->two_sided = true;
    }
    if (!compile_mesh(&mesh, &options, &scene, &err)) fail_msg("%s", err.text);
    mesh_rig_free(&mesh);
    return scene;
}

struct drawn {
    uint16_t pixels[W_PX * H_PX];
    struct lim_stats stats;
};

static void draw(const struct compiled *scene, const struct simulator_setup *setup, const struct simulator_ram *ram,
                 struct drawn *out)
{
    struct viewpoint viewpoint = {{0.05, 0.04, 0.5}, {0.05, 0.04, 0}, 1, false, 0};
    const struct camera_path path = {"panes", &viewpoint, 1};
    struct simulator simulator;
    struct lim_camera camera;
    struct lens lens;
    struct error err;

    assert_true(lens_init(&lens, 60, 0.1, W_PX, H_PX, &err));
    assert_true(camera_path_to_camera(&path, 0, &lens, &scene->grid, &camera, &err));
    if (!simulator_init(&simulator, &scene->scene, setup, &err) || (ram && !simulator_set_ram(&simulator, ram, &err)) ||
        !simulator_frame(&simulator, &camera, &err))
        fail_msg("%s", err.text);
    memcpy(out->pixels, simulator.pixels, sizeof out->pixels);
    out->stats = *simulator_stats(&simulator);
    simulator_free(&simulator);
}

/* With a stack of its own for one layer, and pools for all else. Returns how many walks a pool ended. */
static uint32_t bands_of(size_t count, const struct core *core, const struct simulator_ram *ram, uint16_t *layers)
{
    const struct simulator_setup painter = {W_PX, H_PX, LIM_PAINTER, SIMULATOR_MEMORY, core};
    const struct simulator_setup nearest = {W_PX, H_PX, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, core};
    static struct drawn expected, found;
    struct compiled scene = panes_compiled(count);

    scene.scene.limits = (struct lim_limits){.depth = scene.scene.limits.depth,
                                             .vertices = scene.scene.limits.vertices,
                                             .retained_cells = 8 * MOST_PANES,
                                             .gaps = 64,
                                             .active = MOST_PANES + 2,
                                             .layers = 1};
    draw(&scene, &painter, NULL, &expected);
    draw(&scene, &nearest, ram, &found);
    assert_memory_equal(expected.pixels, found.pixels, sizeof expected.pixels);
    *layers = found.stats.layers_max;
    compiled_free(&scene);
    return found.stats.bands;
}

/* As many as the cache of vertices holds, whatever the tree and the lines above add: each as large as it is where
 * masked textures are linked as well, as they are here. */
static void as_many_as_idle_memory_holds_are_blended_at_once(void **state)
{
    const size_t held = MCU_CACHE_ENTRIES * (size_t)MCU_CACHED_B / sizeof(struct lim_layer);
    uint16_t layers;

    (void)state;
    for (size_t count = 1; count <= held; count += 21) {
        assert_int_equal(bands_of(count, &core_fast, NULL, &layers), 0);
        assert_int_equal(layers, count);
    }
}

/* From the picture's top down there is more and more idle memory, the heads of lines that are painted: up there lines
 * are painted alone. */
static void what_is_too_much_is_painted_from_far_to_near(void **state)
{
    uint16_t layers;

    (void)state;
    for (size_t i = 0; cores[i]; i++)
        for (size_t count = 150; count <= MOST_PANES; count += 50) {
            const uint32_t bands = bands_of(count, cores[i], NULL, &layers);
            assert_in_range(bands, 1, H_PX);
            assert_true(layers <= count);
        }
}

/* By the host's own sizes, not counted as an MCU's. */
static void in_any_memory_the_picture_is_the_same(void **state)
{
    uint16_t layers;

    (void)state;
    for (int percent = 20; percent < 100; percent += 35)
        for (size_t count = 30; count <= MOST_PANES; count += 100)
            (void)bands_of(count, &core_fast, &(struct simulator_ram){.percent = percent}, &layers);
}

/* The larger of its own memory and what active polygons have left behind each other, up to the heads of lines that are
 * not painted yet. What was in the cache of vertices is then to be forgotten. */
static void the_stack_lies_where_it_may_be_highest(void **state)
{
    enum { POOL_B = 200, LINES = 10 };
    static struct {
        uint8_t pool[POOL_B];
        struct lim_line lines[LINES];
    } memory;
    static struct lim_layer own[64];
    struct lim_counted counted = {.is_apart = false};
    struct lim_spans spans = {.lines = memory.lines};
    struct lim_actives actives = {.pool = memory.pool, .at = memory.pool + 80};
    struct lim_layers layers = {.own = own, .own_size = 3};

    (void)state;
    *spans.counted = counted;
    lim_layers_open(&layers, &actives, &spans, 0);
    assert_ptr_equal(layers.pool, memory.pool);
    assert_int_equal(layers.size, POOL_B / sizeof(struct lim_layer));
    assert_true(layers.in_idle);

    actives.in_pool = true;
    lim_layers_open(&layers, &actives, &spans, 4);
    assert_ptr_equal(layers.pool, memory.pool + 80);
    assert_int_equal(layers.size, (POOL_B - 80 + 4 * sizeof(struct lim_line)) / sizeof(struct lim_layer));
    assert_true(layers.in_idle);

    layers = (struct lim_layers){.own = own, .own_size = 64};
    lim_layers_open(&layers, &actives, &spans, 4);
    assert_ptr_equal(layers.pool, own);
    assert_int_equal(layers.size, 64);
    assert_false(layers.in_idle);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_many_as_idle_memory_holds_are_blended_at_once),
        cmocka_unit_test(what_is_too_much_is_painted_from_far_to_near),
        cmocka_unit_test(in_any_memory_the_picture_is_the_same),
        cmocka_unit_test(the_stack_lies_where_it_may_be_highest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
