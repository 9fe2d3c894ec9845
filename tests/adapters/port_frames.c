/* SPDX-License-Identifier: MIT
 *
 * Draws the frames of cameras.h on the module of module.h through one of the ports, and prints what goes over the
 * wires, for `limner decode`: port_frames arduino|pico|idf [again|fail=N,CODE]. again: the board is begun twice, as
 * after an error; fail: the library's call N returns CODE, after which the board is begun again. Exits with 1 if a
 * library or the display complained. */
#include "limner.h" /* as the library of the tests is built, whatever the scene's header says */

#include "cameras.h"
#include "model.h"
#include "module.h"

#include "fake_wires.h"
#include "port_boards.h"

#include <stdio.h>
#include <string.h>

#ifndef LINES
#define LINES 2
#endif

static struct board board;
static struct screen screen;
static struct lim lim;
static uint32_t lines[MODULE_LINES_MEM_B(LINES) / 4];
static void *pools[LIM_POINTERS(MODEL_SCENE_MEM_B(MODULE_H_PX))];

static bool has_select(void)
{
    return !strncmp(MODULE_NAME, "ls0", 3); /* a memory LCD */
}

static int check_clock(void)
{
    static const uint32_t delays_us[] = {0, 1, 999, 10000, 10001, 11000, 16384, 150000};
    int err = 0;

    for (size_t i = 0; i < sizeof delays_us / sizeof delays_us[0] && !err; i++) {
        const uint64_t before_us = wires_now_us();
        err = clock_delay(&board.clock, delays_us[i]);
        if (wires_now_us() - before_us < delays_us[i]) wires_complain("a wait is too short");
    }
    return err;
}

/* Of modes of which Limner's own panels want none, too. The ESP32's port keeps the mode that it began with. */
static int check_modes(const char *port)
{
    int err = 0;

    for (int mode = 0; mode < 4 && !err && port[0] != 'i'; mode++) {
        err = port_board(port, &board, MODULE_SPEED_HZ, (uint8_t)(1 << mode), has_select());
        if (!err && port[0] == 'a') err = bus_write(&board.bus, NULL, 0); /* which begins a transaction */
        if (!err && wires_mode() != mode) wires_complain("the bus has another mode than the display");
    }
    return err;
}

/* More than most buses take at once: commands that do nothing, of a chip of DCS. */
static int send_much(void)
{
    static const uint8_t nops[10000];
    int err = pin_set(&board.dc, false);

    if (!err) err = bus_write(&board.bus, nops, sizeof nops);
    return err ? err : bus_flush(&board.bus);
}

static int set_up(const char *port, bool sends_much)
{
    struct panel *panel;

    int err = port_board(port, &board, MODULE_SPEED_HZ, MODULE_SPI_MODES, has_select());
    if (!err) err = check_clock();
    if (!err && sends_much) err = send_much();
    if (!err) err = module_setup(&panel, &board);
    if (!err) err = panel_init(panel);
    if (!err) err = screen_init(&screen, panel, MODEL_SCENE_METHOD, lines, sizeof lines);
    if (!err) screen_set_bus(&screen, &board.bus, NULL, NULL);
    return err ? err : lim_init(&lim, &model_scene, &screen.target, pools, sizeof pools);
}

static int draw(uint16_t frame)
{
    struct lim_camera camera = cameras[frame];

    screen_turn_camera(&camera, MODULE_CAMERA_TURN);
    int err = screen_begin_frame(&screen);
    if (!err) err = lim_frame(&lim, &camera);
    if (!err) err = screen_end_frame(&screen);
    if (!err) printf("p led %d\n", frame % 2 == 0);
    return err;
}

/* What went wrong once is begun anew, and goes right. */
static int try_again(const char *port, int err)
{
    fprintf(stderr, "# refused: %d\n", err);
    if (err > 0) wires_complain("an error that is not negative");
    return set_up(port, false);
}

int main(int argc, char **argv)
{
    int err = argc > 1 ? 0 : -1, call = -1, failure = 0;

    puts("p led 0");
    if (argc > 2 && sscanf(argv[2], "fail=%d,%d", &call, &failure) == 2) wires_fail(call, failure);
    if (!err) err = check_modes(argv[1]);
    if (!err && argc > 2 && call < 0) err = set_up(argv[1], true);
    if (!err) err = set_up(argv[1], false);
    if (err && call >= 0) err = try_again(argv[1], err);
    for (uint16_t frame = 0; frame < CAMERAS_COUNT && !err; frame++) {
        err = draw(frame);
        if (!err || call < 0) continue;
        err = try_again(argv[1], err);
        if (!err) err = draw(frame);
    }
    if (err) fprintf(stderr, "port_frames: %d\n", err);
    return err || wires_complaints();
}
