/* SPDX-License-Identifier: MIT
 *
 * `limner view`: a window in which keys fly the camera, or the terminal where there is none. */
#include "commands.h"
#include "dump.h"
#include "fly.h"
#include "options.h"

#include <stdlib.h>

struct viewing {
    struct options options;
    struct compiled scene;
    struct camera_path path;
    struct simulator simulator;
};

static bool view_open(struct viewing *view, struct flight *flight, struct error *err)
{
    const struct options *options = &view->options;
    struct lens lens;
    struct lim_camera camera;
    if (!options_load(options, &view->scene, NULL, &lens, &view->path, err) ||
        !camera_path_to_camera(&view->path, 0, &lens, &view->scene.grid, &camera, err) ||
        !simulator_init_on(&view->simulator, &view->scene.scene, &options->setup, &options->panel, err))
        return false;
    simulator_set_wireframe(&view->simulator, &options->wireframe);
    if (!simulator_set_antialias(&view->simulator, options->compile.antialias, err)) return false;
    flight_init(flight, &view->simulator, &camera, &view->scene.grid);
    return true;
}

static bool view_run(struct viewing *view, struct error *err)
{
    struct flight flight;
    if (!view_open(view, &flight, err)) return false;
    enum flight_end end = window_fly(&flight, err);
    if (end == FLIGHT_IMPOSSIBLE) end = terminal_fly(&flight, err);
    if (end == FLIGHT_FAILED) return false;
    struct film last = simulator_film(&view->simulator);
    return dump_last_frame(&last, err);
}

int cmd_view(int argc, char **argv)
{
    struct viewing view = {0};
    struct error err;
    bool ok = options_parse(argc, argv, OPTIONS_VIEW, &view.options, &err) && view_run(&view, &err);
    simulator_free(&view.simulator);
    camera_path_free(&view.path);
    compiled_free(&view.scene);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
