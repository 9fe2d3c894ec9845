/* SPDX-License-Identifier: MIT */
#include "cli/bridge_flight.h"

#include "cli/bridge_bench.h"
#include "cli/options.h"
#include "linux/code_words.h"
#include "render/simulator.h"
#include "scene/moving.h"

#include <stdlib.h>

struct flown {
    struct options options;
    struct bridge_bench *bench;
    struct screen screen;
    void *lines;
    struct compiled scene;
    struct moving moving;
    struct camera_path path;
    struct lens lens;
    struct simulator simulator;
};

static bool open_screen(struct flown *flown, struct error *err)
{
    struct panel *panel = flown->bench->display.panel;
    const size_t lines_b = SCREEN_WIDE_MEM_B(panel->w_px, 2) + 2 * SCREEN_PAGE_B(panel->w_px);
    flown->lines = malloc(lines_b);
    if (!flown->lines) return error_set(err, "bridge: out of memory");
    const int code = screen_init(&flown->screen, panel, LIM_NEAREST_FIRST, flown->lines, lines_b);
    return code == 0 || error_set(err, "bridge: %s (%d)", code_words(code), code);
}

static bool open_scene(struct flown *flown, struct error *err)
{
    struct options *options = &flown->options;
    struct moving *moving = &flown->moving;
    return options_load(options, &flown->scene, moving, &flown->lens, &flown->path, err) &&
           simulator_init_to(&flown->simulator, &flown->scene.scene, &options->setup, &flown->screen.target, err) &&
           (!moving->count ||
            simulator_set_movers(&flown->simulator, moving->instances, moving->count, &moving->limits, err)) &&
           simulator_set_delta(&flown->simulator, options->delta_runs, err);
}

static bool draw(struct flown *flown, size_t frame, int *code, struct error *err)
{
    struct lim_camera camera;
    if (!camera_path_to_camera(&flown->path, frame, &flown->lens, &flown->scene.grid, &camera, err)) return false;
    moving_pose(&flown->moving, (double)frame / flown->options.frames_per_s);
    *code = screen_begin_frame(&flown->screen);
    if (!*code) *code = simulator_draw(&flown->simulator, &camera);
    if (!*code) *code = screen_end_frame(&flown->screen);
    return true;
}

static bool fly(struct flown *flown, const struct panel_choice *choice, struct bridge_cost *out, struct error *err)
{
    struct bridge_cost before = {0};
    int code = panel_init(flown->bench->display.panel);
    for (size_t frame = 0; frame < flown->path.count && !code; frame++) {
        if (!draw(flown, frame, &code, err)) return false;
        if (frame == 0) before = bridge_bench_cost(flown->bench);
    }
    if (!bridge_bench_check(flown->bench, choice, code, err)) return false;
    if (flown->path.count < 2) return error_set(err, "bridge: a flight has two frames at least");
    const struct bridge_cost after = bridge_bench_cost(flown->bench);
    *out = (struct bridge_cost){.spi_b = (after.spi_b - before.spi_b) / (flown->path.count - 1),
                                .reports = (after.reports - before.reports) / (flown->path.count - 1)};
    return true;
}

static void flown_free(struct flown *flown)
{
    simulator_free(&flown->simulator);
    moving_free(&flown->moving);
    compiled_free(&flown->scene);
    camera_path_free(&flown->path);
    bridge_bench_close(flown->bench);
    free(flown->lines);
    free(flown);
}

bool bridge_flight_cost(const struct panel_choice *choice, const struct display_module *module, const char *scene_path,
                        const char *camera_path, struct bridge_cost *out, struct error *err)
{
    char size[16];
    snprintf(size, sizeof size, "%ux%u", (unsigned)module->w_px, (unsigned)module->h_px);
    const char *words[] = {/* whose order the parser changes */
                           "bridge", scene_path, "--camera", camera_path, "--size", size, "--delta", NULL};
    struct flown *flown = calloc(1, sizeof *flown);
    if (!flown) return error_set(err, "bridge: out of memory");
    bool ok = options_parse(7, (char **)words, OPTIONS_VIEW, &flown->options, err);
    if (ok) flown->bench = bridge_bench_open(choice, module, err);
    ok = ok && flown->bench && open_screen(flown, err) && open_scene(flown, err) && fly(flown, choice, out, err);
    flown_free(flown);
    return ok;
}
