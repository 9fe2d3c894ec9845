/* SPDX-License-Identifier: MIT
 *
 * Convex solids whose runs a target takes, without memory for lines: the same bytes reach a monochrome panel as with
 * lines, filled and as wireframes, with and without something over them. */
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "overlay.h"
#include "panels.h"
#include "rigs/cmocka_ready.h"
#include "rigs/convex_rig.h"
#include "scene/compiled.h"
#include "screen.h"
#include "text.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 128, H_PX = 64, SOLIDS = 4, CAMERAS = 8, UNITS_PER_M = 8000, SENT_MAX_B = 4 * W_PX * H_PX / 8 };

struct rig {
    struct mesh mesh;
    struct compiled scene;
    struct lens lens;
};

struct sent {
    uint8_t bytes[SENT_MAX_B];
    size_t n_b;
};

static int write_sent(void *ctx, const uint8_t *data, size_t n_b)
{
    struct sent *sent = ctx;

    assert_true(sent->n_b + n_b <= sizeof sent->bytes);
    memcpy(sent->bytes + sent->n_b, data, n_b);
    sent->n_b += n_b;
    return 0;
}

static int set_nothing(void *ctx, bool high)
{
    (void)ctx, (void)high;
    return 0;
}

static int wait_nothing(void *ctx, uint32_t delay_us)
{
    (void)ctx, (void)delay_us;
    return 0;
}

static void setup(struct rig *rig, struct random *random, unsigned kind, bool wireframe, const struct core *core)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "auto", .wireframe = wireframe, .core = core};
    struct error err;

    *rig = (struct rig){.mesh = mesh_rig(UNITS_PER_M)};
    convex_rig_add(&rig->mesh, random, kind);
    for (size_t i = 0; i < rig->mesh.polygon_count; i++)
        rig->mesh.polygons[i].colour = random_in(random, 0, 2) ? (uint32_t)(random_u64(random) & 0xFFFFFF) : 0;
    if (!compile_mesh(&rig->mesh, &options, &rig->scene, &err) || !lens_init(&rig->lens, 60, 0.1, W_PX, H_PX, &err))
        fail_msg("%s", err.text);
}

static struct lim_camera camera_at(const struct rig *rig, struct viewpoint viewpoint)
{
    const struct camera_path path = {"fill", &viewpoint, 1};
    struct lim_camera camera;
    struct error err;

    if (!camera_path_to_camera(&path, 0, &rig->lens, &rig->scene.grid, &camera, &err)) fail_msg("%s", err.text);
    return camera;
}

/* A frame on an SSD1306; mem_b says whether there are lines. */
static void draw(const struct rig *rig, const struct core *core, const struct lim_camera *camera, bool wireframe,
                 const struct lim_overlay *overlay, size_t mem_b, struct sent *sent)
{
    const struct pages_config config = {.bus = {.ctx = sent, .write = write_sent},
                                        .dc = {.set = set_nothing},
                                        .clock = {.delay = wait_nothing},
                                        .w_px = W_PX,
                                        .h_px = H_PX};
    uint32_t lines[SCREEN_PAGES_MEM_B(W_PX, 2) / 4];
    struct pages pages;
    struct screen screen;

    assert_true(mem_b <= sizeof lines);
    assert_int_equal(pages_setup(&pages, &ssd1306, &config), 0);
    assert_int_equal(screen_init(&screen, &pages.panel, LIM_CONVEX, lines, mem_b), 0);
    const size_t lim_mem_b = core->mem_b(&rig->scene.scene, &screen.target);
    void *lim = calloc(1, core->lim_b), *mem = malloc(lim_mem_b);
    assert_int_equal(core->init(lim, &rig->scene.scene, &screen.target, mem, lim_mem_b), 0);
    core->set_wireframe(lim, &(const struct lim_wireframe){.on = wireframe});
    core->set_overlay(lim, overlay);
    for (int frame = 0; frame < 2; frame++) { /* what the first one left must not show */
        sent->n_b = 0;
        assert_int_equal(screen_begin_frame(&screen), 0);
        assert_int_equal(core->frame(lim, camera), 0);
        assert_int_equal(screen_end_frame(&screen), 0);
    }
    free(mem);
    free(lim);
}

static lim_overlay_draw draw_over;

/* Light and dark, and grey, which is dithered. */
static void draw_over(void *ctx, const struct lim_overlay_line *line)
{
    (void)ctx;
    lim_overlay_box(line, &(const struct lim_overlay_box){20, 8, 60, 30}, 0x8410);
    lim_text(line, 24, 13, "over it", &(const struct lim_text_style){.colour = 0xFFFF, .solid = true});
    lim_text(line, 100, 50, "out of it", &(const struct lim_text_style){.colour = 0xFFFF, .scale = 2});
}

static void compare(const struct core *core, bool wireframe, const struct lim_overlay *overlay)
{
    struct random random = {wireframe ? 7 : 5};
    size_t lit = 0;

    for (unsigned i = 0; i < SOLIDS; i++) {
        struct rig rig;
        setup(&rig, &random, 2 * i, wireframe, core);
        if (i % 2) rig.scene.scene.background = 0x8410; /* grey: not black before it is filled */
        for (unsigned view = 0; view < CAMERAS; view++) {
            const struct lim_camera camera = camera_at(&rig, convex_rig_viewpoint(&random));
            struct sent with_lines = {.n_b = 0}, by_runs = {.n_b = 0};
            draw(&rig, core, &camera, wireframe, overlay, SCREEN_PAGES_MEM_B(W_PX, 1), &with_lines);
            draw(&rig, core, &camera, wireframe, overlay, SCREEN_PAGES_MEM_B(W_PX, 0), &by_runs);
            assert_int_equal(by_runs.n_b, with_lines.n_b);
            assert_memory_equal(by_runs.bytes, with_lines.bytes, with_lines.n_b);
            for (size_t at = 0; at < by_runs.n_b; at++)
                lit += by_runs.bytes[at] != 0;
        }
        compiled_free(&rig.scene);
        mesh_rig_free(&rig.mesh);
    }
    assert_true(lit > 1000);
}

static void runs_give_the_bytes_that_lines_give(void **state)
{
    (void)state;
    compare(&core_fast, false, NULL);
}

static void wireframes_do(void **state)
{
    (void)state;
    compare(&core_fast, true, NULL);
}

static void what_lies_over_them_does(void **state)
{
    const struct lim_overlay overlay = {.draw = draw_over, .y0_px = 5, .y1_px = 60};

    (void)state;
    compare(&core_fast, false, &overlay);
    compare(&core_fast, true, &overlay);
}

static void less_than_a_page_is_refused(void **state)
{
    (void)state;
    const struct pages_config config = {.bus = {.write = write_sent},
                                        .dc = {.set = set_nothing},
                                        .clock = {.delay = wait_nothing},
                                        .w_px = W_PX,
                                        .h_px = H_PX};
    uint32_t mem[SCREEN_PAGE_B(W_PX) / 4];
    struct pages pages;
    struct screen screen;

    assert_int_equal(pages_setup(&pages, &ssd1306, &config), 0);
    assert_int_equal(screen_init(&screen, &pages.panel, LIM_CONVEX, mem, sizeof mem), 0);
    assert_int_equal(screen_init(&screen, &pages.panel, LIM_CONVEX, mem, sizeof mem - 4), LIM_ERR_MEMORY);
    assert_int_equal(screen_init(&screen, &pages.panel, LIM_NEAREST_FIRST, mem, sizeof mem), LIM_ERR_MEMORY);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_give_the_bytes_that_lines_give),
        cmocka_unit_test(wireframes_do),
        cmocka_unit_test(what_lies_over_them_does),
        cmocka_unit_test(less_than_a_page_is_refused),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
