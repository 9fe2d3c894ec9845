/* SPDX-License-Identifier: MIT
 *
 * `limner view`: a window in which keys fly the camera, or the terminal where there is none. What moves does so by the
 * clock, in the terminal as often as a key is pressed. */
#include "base/deadline.h"
#include "base/ending.h"
#include "cli/commands.h"
#include "cli/fly.h"
#include "cli/options.h"
#include "compiler/faithful.h"
#include "compiler/moving_compile.h"
#include "pictures/dump.h"
#include "scene/moving.h"

#include <stdio.h>
#include <stdlib.h>

struct viewing {
    struct options options;
    struct compiled scene;
    struct moving moving;
    struct camera_path path;
    struct simulator simulator;
};

/* As render does, but for methods that move nothing: with these, all of the model is the scene. */
static bool view_load(struct viewing *view, struct lens *lens, struct error *err)
{
    struct options *options = &view->options;
    if (!method_can_move(options->setup.method)) options->movers.mode = MOVING_OFF;
    if (!options_load(options, &view->scene, &view->moving, lens, &view->path, err)) return false;
    faithful_note(&view->scene);
    options_note_stopped(options, &view->moving);
    return true;
}

static bool view_open(struct viewing *view, struct flight *flight, struct error *err)
{
    const struct options *options = &view->options;
    struct lens lens;
    struct lim_camera camera;
    struct moving *moving = &view->moving;
    if (!view_load(view, &lens, err) ||
        !camera_path_to_camera(&view->path, 0, &lens, &view->scene.grid, &camera, err) ||
        !simulator_init_on(&view->simulator, &view->scene.scene, &options->setup, &options->panel, err))
        return false;
    simulator_set_wireframe(&view->simulator, &options->wireframe);
    if (!simulator_set_antialias(&view->simulator, options->compile.antialias, err)) return false;
    if (!simulator_set_delta(&view->simulator, options->delta_runs, err)) return false;
    if (moving->count &&
        !simulator_set_movers(&view->simulator, moving->instances, moving->count, &moving->limits, err))
        return false;
    return flight_init(flight, &view->simulator, &view->scene.scene, &camera, &view->scene.grid,
                       moving->count ? moving : NULL, err);
}

static bool view_fly(struct viewing *view, struct flight *flight, struct error *err)
{
    if (!view_open(view, flight, err)) return false;
    deadline_begin(0.0);
    ending_lend(); /* a window is closed by signals, and the last frame is still written */
    enum flight_end end = window_fly(flight, err);
    ending_watch();
    if (end == FLIGHT_IMPOSSIBLE) end = terminal_fly(flight, err);
    if (end == FLIGHT_FAILED) return false;
    struct film last = simulator_film(&view->simulator);
    return dump_last_frame(&last, err);
}

static bool view_run(struct viewing *view, struct error *err)
{
    struct flight flight = {.stack = NULL};
    const bool ok = view_fly(view, &flight, err);
    flight_free(&flight);
    return ok;
}

int cmd_view(int argc, char **argv)
{
    struct viewing view = {0};
    struct error err;
    bool ok = options_parse(argc, argv, OPTIONS_VIEW, &view.options, &err) && view_run(&view, &err);
    simulator_free(&view.simulator);
    camera_path_free(&view.path);
    compiled_free(&view.scene);
    compile_options_free(&view.options.compile);
    moving_free(&view.moving);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
