/* SPDX-License-Identifier: MIT
 *
 * The firmware of every board: a compiled scene, seen from the cameras of its path, one after the other and for ever,
 * on the panel that was chosen; as a self-test (BOARD_CARD) the test card comes before each flight. Buttons, where
 * there are some, leave the path. The LED changes with every frame. When something fails it blinks, as often as enum
 * trouble says, and all begins anew; when the processor takes an exception it stays lit. A program (BOARD_ENDS) leaves
 * the panel dark when it ends, as it does when something fails. */
#include "app_scene.h"
#include "bare_image.h"
#include "board.h"
#include "card.h"
#include "mcu/mcu.h"
#include "module.h"
#include "screen.h"
#include "walker.h"

/* Lines of the picture in RAM: all for the painter and for a framebuffer, else one, or more where some are painted
 * while others are sent. */
#ifndef BOARD_LINES
#define BOARD_LINES 1
#endif
#define USED_LINES SCREEN_USED_LINES(MODULE_FORMAT, MODULE_W_PX, MODULE_ROUND, BOARD_LINES)
#define LINES (SCENE_LINES(MODULE_H_PX) > 1 ? SCENE_LINES(MODULE_H_PX) : USED_LINES)

/* The self-test: whether there is one, and for how long its card stays. */
#ifndef BOARD_CARD
#define BOARD_CARD 0
#endif
#ifndef BOARD_CARD_MS
#define BOARD_CARD_MS 3000
#endif

enum { BLINK_US = 200000, PAUSE_US = 1000000, KEEP_MS = 500 };

/* How often the LED blinks. */
enum trouble { TROUBLE_RENDERER = 1, TROUBLE_PANEL, TROUBLE_PORT };

static struct board board;
static struct screen screen;
static uint32_t lines[MODULE_LINES_MEM_B(LINES) / 4];
#if SCREEN_KEEPS_FRAME
static uint32_t picture[SCREEN_FRAME_MEM_B(MODULE_W_PX, MODULE_H_PX) / 4];
#endif

static int set_led(bool lit)
{
    return pin_is_wired(&board.led) ? pin_set(&board.led, lit) : 0;
}

/* Between the marks a frame is painted and sent. */
static int draw(uint16_t frame)
{
    frame_begin(frame);
    int err = screen_begin_frame(&screen);
    if (!err) err = scene_draw();
    if (!err) err = screen_end_frame(&screen);
    frame_end(frame);
    return err;
}

/* A memory LCD wants to be kept every second. */
static int hold_card(void)
{
    int err = 0;

    for (uint32_t left_ms = BOARD_CARD_MS; left_ms && !err;) {
        const uint32_t part_ms = left_ms < KEEP_MS ? left_ms : KEEP_MS;
        err = clock_delay(&board.clock, part_ms * 1000u);
        if (!err) err = panel_keep(screen.panel);
        left_ms -= part_ms;
    }
    return err;
}

/* A frame as others are, to whoever looks at the LED or the marks. */
static int show_card(bool lit)
{
    frame_begin(0);
    int err = card_draw(&screen, MODULE_CAMERA_TURN);
    frame_end(0);
    if (!err) err = set_led(lit);
    scene_refresh();
    return err ? err : hold_card();
}

/* Where the next camera is, and what follows it. */
struct flight {
    struct lim_camera cameras[1 + SCENE_AHEAD]; /* of frames that are not drawn yet, in turns */
    struct walker walker;
    bool second;
};

static void announce(struct flight *flight, uint16_t frame)
{
    struct lim_camera *const camera = &flight->cameras[SCENE_AHEAD && flight->second];

    flight->second = !flight->second;
    scene_camera(frame, camera);
    if (board.buttons) walker_frame(&flight->walker, board.buttons(), camera);
    screen_turn_camera(camera, MODULE_CAMERA_TURN);
    scene_announce(frame, camera);
}

/* Returns only when something fails, or a program is to end. */
static int fly(void)
{
    struct flight flight = {.walker = {.walking = false}};
    bool lit = false;

    walker_set_solid(&flight.walker, scene_solid());
    if (SCENE_AHEAD) announce(&flight, 0);
    for (uint16_t frame = 0; !(BOARD_ENDS && board_is_over()); frame = (uint16_t)((frame + 1u) % CAMERAS_COUNT)) {
        int err = BOARD_CARD && frame == 0 ? show_card(lit = !lit) : 0;
        if (err) return err;
        announce(&flight, (uint16_t)((frame + SCENE_AHEAD) % CAMERAS_COUNT));
        err = draw(frame);
        if (!err) err = set_led(lit = !lit);
        if (err) return err;
    }
    return 0;
}

/* Lends the whole picture where there is memory for it. */
static int set_frame(void)
{
#if SCREEN_KEEPS_FRAME
    return screen_set_frame(&screen, picture, sizeof picture);
#else
    return 0;
#endif
}

static int set_screen(struct panel *panel)
{
#if LIM_HAS_FRAMEBUFFER
    const int err = screen_init_framebuffer(&screen, panel, SCENE_METHOD, lines, sizeof lines);
#else
    const int err = screen_init(&screen, panel, SCENE_METHOD, lines, sizeof lines);
#endif

#if SCREEN_STREAMS
    if (!err) screen_set_bus(&screen, &board.bus, scene_work, NULL);
#endif
    return err;
}

static int run(void)
{
    struct panel *panel;

    board = (struct board){0};
    int err = board_init(&board, MODULE_SPEED_HZ, MODULE_SPI_MODES);
    if (!err) err = module_setup(&panel, &board);
    if (!err) err = panel_init(panel);
    const bool is_lit = !err;
    if (!err) err = set_screen(panel);
    if (!err) err = set_frame();
    if (!err) err = scene_init(&screen.target);
    if (!err) err = fly();
    const int dark = BOARD_ENDS && is_lit ? panel_darken(panel) : 0;
    return err || dark == PANEL_ERR_UNSUPPORTED ? err : dark; /* a memory LCD may have no pin for it */
}

/* Dark before it blinks: the last frame may have left it lit. A clock that failed as well is waited for no longer. */
static void tell(enum trouble trouble)
{
    int err = set_led(false);

    if (!err) err = board.clock.delay ? clock_delay(&board.clock, PAUSE_US) : -1;
    for (int i = 0; i < 2 * (int)trouble && !err; i++) {
        err = set_led(i % 2 == 0);
        if (!err) err = clock_delay(&board.clock, BLINK_US);
    }
}

static enum trouble trouble_of(int err)
{
    if (err > PANEL_ERR_CONFIG) return TROUBLE_RENDERER;
    return err > MCU_ERR_TIMEOUT ? TROUBLE_PANEL : TROUBLE_PORT;
}

int main(void)
{
    if (BOARD_ENDS) return board_end(run());
    for (;;)
        tell(trouble_of(run()));
}

/* main() does not return. */
_Noreturn void image_exit(int status)
{
    (void)status;
    for (;;)
        ;
}

_Noreturn void image_fault(void)
{
    int err = set_led(true);
    for (;;)
        (void)err;
}
