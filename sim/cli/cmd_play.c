/* SPDX-License-Identifier: MIT
 *
 * `limner play`: options -> port, panel, screen -> a scene's camera path, or the test card, on a real display. What can
 * be refused without the hardware is refused before it is touched. */
#include "base/deadline.h"
#include "base/notice.h"
#include "base/parse.h"
#include "card.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "compiler/faithful.h"
#include "compiler/moving_compile.h"
#include "displays/module_choice.h"
#include "displays/player.h"
#include "displays/port_choice.h"
#include "linux/code_words.h"
#include "linux/interrupt.h"
#include "scene/moving.h"

#include <stdio.h>
#include <stdlib.h>

enum {
    ORBIT_FRAMES = 240, /* a turn in 8 s at 30 frames a second */
    FRAMES_MAX = 1000000000,
    USUAL_MODE = 0,        /* of SPI, where the module takes several */
    CARD_PAUSE_US = 800000 /* a display that is plugged in again soon shows it; memory LCDs want a frame a second */
};

struct play {
    struct port_choice port_choice;
    struct module_choice module_choice;
    struct options options;
    struct idle_options idle; /* given ones, that may change nothing */
    bool card;                /* the test card, and no scene */
    uint64_t frames;          /* 0: until a signal */

    struct compiled scene;
    struct moving moving;
    struct camera_path path;
    struct lim_camera *cameras; /* one a frame of the path, as the panel needs them */
    struct simulator simulator;

    struct port port;
    struct display display;
    struct screen screen;
    void *lines; /* the screen's memory */
    struct player player;
};

/* The command line ------------------------------------------------------------------------------ */

static bool take_frames(struct play *play, struct arguments *arguments, struct error *err)
{
    const char *text = NULL;
    uint32_t frames = 0;
    if (!arguments_value(arguments, "--frames", &text, err)) return false;
    if (text && !parse_whole("--frames", text, 1, FRAMES_MAX, &frames, err)) return false;
    play->frames = frames;
    return true;
}

static bool take_scene(struct play *play, struct arguments *arguments, struct error *err)
{
    struct options *options = &play->options;
    if (play->card)
        return arguments->count == 1 ||
               error_set(err, "--test-card: draws no scene, what is '%s'?", arguments->items[1]);
    if (!options_parse(arguments->count, arguments->items, OPTIONS_VIEW, options, err)) return false;
    options_settle_panel(options, &play->module_choice.panel);
    options->orbit_frames = ORBIT_FRAMES;
    if (!method_can_move(options->setup.method)) options->movers.mode = MOVING_OFF;
    module_choice_picture(&play->module_choice.module, &options->setup.w_px, &options->setup.h_px);
    options->compile.w_px = options->setup.w_px;
    options->compile.h_px = options->setup.h_px;
    return true;
}

/* With pins that do nothing: whether the panel's driver can do with those that are wired. */
static bool try_driver(struct play *play, struct error *err)
{
    const struct module_choice *choice = &play->module_choice;
    const struct port stand_in = port_choice_stand_in(&play->port_choice);
    return display_setup(&play->display, &choice->panel, &choice->module, &stand_in, err);
}

static bool play_parse(struct play *play, int argc, char **argv, struct error *err)
{
    struct arguments arguments = {argv, argc};
    idle_options_find(&play->idle, argc, argv);
    play->card = arguments_flag(&arguments, "--test-card");
    return module_choice_parse(&play->module_choice, &arguments, err) &&
           port_choice_parse(&play->port_choice, &arguments, err) && take_frames(play, &arguments, err) &&
           take_scene(play, &arguments, err) && try_driver(play, err);
}

/* The display ----------------------------------------------------------------------------------- */

static bool open_display(struct play *play, struct error *err)
{
    const struct module_choice *choice = &play->module_choice;
    const struct port_clock clock = {choice->speed_hz, spi_mode_of(choice->spi_modes, USUAL_MODE), !choice->mode_given};
    if (!port_choice_open(&play->port_choice, &clock, &play->port, err)) return false;
    if (play->port.spi_mode != USUAL_MODE && clock.any_mode)
        notice("SPI mode %u, which most modules with %s want; --mode says otherwise", (unsigned)play->port.spi_mode,
               choice->panel.name);
    idle_options_note_panel(&play->idle, &choice->panel);
    player_init(&play->player, &play->port);
    struct port counted = play->port;
    counted.bus = play->player.bus;
    if (!display_setup(&play->display, &choice->panel, &choice->module, &counted, err)) return false;
    const struct panel *panel = play->display.panel;
    const enum lim_method method = play->card ? LIM_NEAREST_FIRST : play->options.setup.method;
    const size_t lines_b =
        SCREEN_WIDE_MEM_B(panel->w_px, method == LIM_PAINTER ? panel->h_px : 2) + 2 * SCREEN_PAGE_B(panel->w_px);
    play->lines = malloc(lines_b);
    if (!play->lines) return error_set(err, "play: out of memory");
    const int code = screen_init(&play->screen, play->display.panel, method, play->lines, lines_b);
    return code == 0 || error_set(err, "play: %s (%d)", code_words(code), code);
}

/* A scene --------------------------------------------------------------------------------------- */

static bool plan_cameras(struct play *play, const struct lens *lens, struct error *err)
{
    play->cameras = calloc(play->path.count, sizeof play->cameras[0]);
    if (!play->cameras) return error_set(err, "play: out of memory");
    for (size_t i = 0; i < play->path.count; i++) {
        if (!camera_path_to_camera(&play->path, i, lens, &play->scene.grid, &play->cameras[i], err)) return false;
        screen_turn_camera(&play->cameras[i], play->display.camera_turn);
    }
    return true;
}

static bool load_scene(struct play *play, struct error *err)
{
    struct lens lens;
    if (!options_load(&play->options, &play->scene, &play->moving, &lens, &play->path, err)) return false;
    faithful_note(&play->scene);
    options_note_stopped(&play->options, &play->moving);
    deadline_begin(0.0); /* what is played has no end of its own */
    return plan_cameras(play, &lens, err);
}

static bool open_scene(struct play *play, struct error *err)
{
    struct options *options = &play->options;
    struct moving *moving = &play->moving;
    if (!simulator_init_to(&play->simulator, &play->scene.scene, &options->setup, &play->screen.target, err))
        return false;
    simulator_set_wireframe(&play->simulator, &options->wireframe);
    return simulator_set_antialias(&play->simulator, options->compile.antialias, err) &&
           simulator_set_delta(&play->simulator, options->delta_runs, err) &&
           (!moving->count ||
            simulator_set_movers(&play->simulator, moving->instances, moving->count, &moving->limits, err));
}

static int draw_scene(void *ctx, uint64_t frame)
{
    struct play *play = ctx;
    moving_pose(&play->moving, play->player.took_s);
    int err = screen_begin_frame(&play->screen);
    if (!err) err = simulator_draw(&play->simulator, &play->cameras[frame % play->path.count]);
    if (!err) err = screen_end_frame(&play->screen);
    if (err) simulator_refresh(&play->simulator);
    return err;
}

/* The test card --------------------------------------------------------------------------------- */

static int draw_card(void *ctx, uint64_t frame)
{
    struct play *play = ctx;
    (void)frame;
    return card_draw(&play->screen, play->display.camera_turn);
}

/* All of it ------------------------------------------------------------------------------------- */

static bool play_run(struct play *play, struct error *err)
{
    if (!play->card && !load_scene(play, err)) return false;
    if (!open_display(play, err) || (!play->card && !open_scene(play, err))) return false;
    play->player.panel = play->display.panel;
    play->player.draw = play->card ? draw_card : draw_scene;
    play->player.ctx = play;
    play->player.frames = play->frames;
    play->player.pause_us = play->card && play->frames == 0 ? CARD_PAUSE_US : 0;
    const bool ok = player_run(&play->player, err);
    player_print(&play->player);
    return ok;
}

static void play_free(struct play *play)
{
    port_close(&play->port);
    simulator_free(&play->simulator);
    free(play->cameras);
    free(play->lines);
    camera_path_free(&play->path);
    compiled_free(&play->scene);
    compile_options_free(&play->options.compile);
    moving_free(&play->moving);
}

int cmd_play(int argc, char **argv)
{
    struct play play = {0};
    struct error err;
    const bool ok = play_parse(&play, argc, argv, &err) && play_run(&play, &err);
    play_free(&play);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    fflush(stdout);
    if (ok) interrupt_die();
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
