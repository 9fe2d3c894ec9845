/* SPDX-License-Identifier: MIT
 *
 * Every panel's wires as a logic analyser sees them, bit by bit, when nobody captured the board's light: as many frames
 * end as were drawn, each with the picture that a display next to it shows, in every turn; and a capture that begins in
 * the middle of a frame has those that follow. */
#include "glass/capture.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "screen.h"

#include <stdlib.h>
#include <string.h>

enum { FRAMES = 4, PIXELS_MAX = 400 * 480, BIT_NS = 100 };

/* A driver that draws the same over both: the wires, and a display that gets its bytes as they are. */
struct side {
    struct display display;
    struct screen screen;
    uint32_t mem[SCREEN_WIDE_MEM_B(480, 2) / 4 + 2 * SCREEN_PAGE_B(480) / 4];
};

static struct module_choice module;
static struct listener seen, direct;
static struct capture capture;
static struct capture_choice choice;
static struct channels channels;
static struct side wired, plain;
static struct wire_levels levels;
static uint64_t now_ns;
static bool is_captured; /* the analyser is on */
static uint8_t rgb[3 * PIXELS_MAX];
static uint16_t pixels[PIXELS_MAX], expected[FRAMES][PIXELS_MAX];
static uint64_t frame_b;      /* bytes of a frame */
static unsigned first, shown; /* the first frame that may end, and how many have */

static void set(enum capture_wire wire, bool high)
{
    struct error err;
    const uint8_t bit = (uint8_t)(1u << wire);
    levels.high = (uint8_t)(high ? levels.high | bit : levels.high & ~bit);
    if (is_captured && !capture_levels(&capture, now_ns, levels, &err)) fail_msg("%s", err.text);
}

static int clock_out(void *ctx, const uint8_t *bytes, size_t n_b)
{
    (void)ctx;
    for (size_t i = 0; i < 8 * n_b; i++) {
        set(CAPTURE_MOSI, bytes[i / 8] >> (7 - i % 8) & 1);
        now_ns += BIT_NS;
        set(CAPTURE_SCK, true);
        now_ns += BIT_NS;
        set(CAPTURE_SCK, false);
    }
    return 0;
}

static int set_pin(void *ctx, bool high)
{
    now_ns += 20000;
    set(*(const enum capture_wire *)ctx, high);
    now_ns += 20000;
    return 0;
}

static int wait(void *ctx, uint32_t delay_us)
{
    (void)ctx;
    now_ns += (uint64_t)delay_us * 1000;
    return 0;
}

static struct pin pin_of(const enum capture_wire *wire)
{
    return (struct pin){.ctx = (void *)(uintptr_t)wire, .set = set_pin};
}

/* With the pins that the panel's driver wants. */
static struct port wires_port(void)
{
    static const enum capture_wire dc = CAPTURE_DC, reset = CAPTURE_RESET, select = CAPTURE_SELECT;
    struct port port = {.bus = {.write = clock_out}, .clock = {.delay = wait}};
    if (module.panel.family->selects)
        port.select = pin_of(&select);
    else
        port.dc = pin_of(&dc);
    if (direct.port.reset.set) port.reset = pin_of(&reset);
    return port;
}

static void start_side(struct side *side, const struct port *port)
{
    struct error err;
    if (!display_setup(&side->display, &module.panel, &module.module, port, &err)) fail_msg("%s", err.text);
    assert_int_equal(panel_init(side->display.panel), 0);
    assert_int_equal(screen_init(&side->screen, side->display.panel, LIM_NEAREST_FIRST, side->mem, sizeof side->mem),
                     0);
}

/* Pictures that differ, also from themselves shifted, and in black and white. */
static void draw(struct side *side, unsigned frame)
{
    const struct lim_target *target = &side->screen.target;
    int err = screen_begin_frame(&side->screen);
    for (uint16_t y_px = 0; y_px < target->h_px && !err; y_px++) {
        uint8_t *line = target->lend(target->ctx, y_px);
        for (unsigned i = 0; i < 2u * target->w_px; i++)
            line[i] = (uint8_t)((y_px * 7u + i / 2 * 3u + frame * 5u) % 11 < 4 ? 0xFF : frame + y_px);
        err = target->done(target->ctx, y_px, 0, target->w_px);
    }
    if (!err) err = screen_end_frame(&side->screen);
    assert_int_equal(err, 0);
}

static bool on_frame(void *ctx, struct error *err)
{
    (void)ctx, (void)err;
    listener_read(&seen, rgb, pixels);
    assert_true(first + shown < FRAMES);
    assert_memory_equal(pixels, expected[first + shown], sizeof pixels[0] * module.module.w_px * module.module.h_px);
    shown++;
    return true;
}

static void begin_capture(bool is_running)
{
    struct error err;
    listener_init(&seen, &module);
    choice = (struct capture_choice){.is_running = is_running};
    capture = (struct capture){
        .choice = &choice, .module = &module, .listener = &seen, .path = "capture", .on_frame = on_frame};
    if (!capture_begin(&capture, &channels, 0, true, &err)) fail_msg("%s", err.text);
    is_captured = true;
    if (!capture_levels(&capture, now_ns, levels, &err)) fail_msg("%s", err.text);
}

static void prepare(void)
{
    listener_init(&direct, &module);
    start_side(&plain, &direct.port);
    const uint64_t before_b = direct.display.port->bus_b;
    for (unsigned frame = 0; frame < FRAMES; frame++) {
        draw(&plain, frame);
        listener_read(&direct, rgb, expected[frame]);
    }
    frame_b = (direct.display.port->bus_b - before_b) / FRAMES;
    levels = (struct wire_levels){1u << CAPTURE_RESET, 0};
    is_captured = false;
    now_ns = shown = first = 0;
}

/* No command follows the last frame, as when a capture stops. */
static void assert_all_shown(const char *what)
{
    struct error err = {""};
    if (!capture_end(&capture, &err)) fail_msg("%s", err.text);
    if (first + shown != FRAMES) fail_msg("%s %s: %u frames from %u on", module.panel.name, what, shown, first);
}

static void capture_from_the_start(void)
{
    const struct port port = wires_port();
    prepare();
    begin_capture(false);
    start_side(&wired, &port);
    for (unsigned frame = 0; frame < FRAMES; frame++)
        draw(&wired, frame);
    assert_all_shown("from the start");
}

static uint64_t left_b; /* until the analyser is switched on */

/* In the middle of a byte of pixels. */
static int write_and_begin(void *ctx, const uint8_t *bytes, size_t n_b)
{
    left_b = left_b > n_b ? left_b - n_b : 0;
    if (!is_captured && left_b == 0 && n_b > 4) {
        levels.high |= 1u << CAPTURE_SCK;
        begin_capture(true);
        set(CAPTURE_SCK, false);
    }
    return clock_out(ctx, bytes, n_b);
}

/* Half of the first frame has gone by then. */
static void capture_from_the_middle(void)
{
    struct port port = wires_port();
    port.bus.write = write_and_begin;
    prepare();
    left_b = UINT64_MAX;
    start_side(&wired, &port);
    left_b = frame_b / 2;
    first = 1;
    for (unsigned frame = 0; frame < FRAMES; frame++)
        draw(&wired, frame);
    assert_all_shown("from the middle");
}

static void choose(const struct panel_choice *panel, unsigned turn)
{
    char name[40], size[20], *words[] = {"card", "--panel", name, "--size", size, NULL};
    struct arguments arguments = {words, 5};
    struct error err;
    const bool is_free =
        panel->mem_w_px >= 64 && panel->mem_h_px >= 48 && panel->w_step_px <= 8 && strcmp(panel->name, "gc9a01") != 0;
    snprintf(name, sizeof name, "%s", panel->name);
    snprintf(size, sizeof size, "%s", strcmp(panel->name, "ssd1306") == 0 ? "128x32" : "64x48");
    if (!is_free) arguments.count = 3;
    if (!is_free) words[3] = NULL;
    if (!module_choice_parse(&module, &arguments, &err)) fail_msg("%s", err.text);
    module.module.rotation = (enum panel_rotation)turn;
}

static void for_every_panel(void (*run)(void))
{
    struct panel_choice panel;
    /* With little effort one of the turns, each panel another one. */
    const unsigned every = 4 / (unsigned)effort(4);
    unsigned runs = 0;
    for (size_t i = 0; panel_choice_at(i, &panel); i++)
        for (unsigned turn = (unsigned)i % every; turn < 4; turn += every) {
            choose(&panel, turn);
            struct display display;
            struct error err;
            listener_init(&direct, &module);
            if (!display_setup(&display, &module.panel, &module.module, &direct.port, &err)) continue;
            run();
            runs++;
        }
    assert_int_equal(runs, 4 / every * 16);
}

static void as_many_frames_end_as_were_drawn(void **state)
{
    (void)state;
    for_every_panel(capture_from_the_start);
}

static void a_capture_from_the_middle_has_those_that_follow(void **state)
{
    (void)state;
    for_every_panel(capture_from_the_middle);
}

static int name_channels(void **state)
{
    (void)state;
    for (int wire = 0; wire < CAPTURE_BACKLIGHT; wire++)
        channels_add(&channels, (struct channel){.path = strdup(capture_wire_names[wire]),
                                                 .id = strdup(capture_wire_names[wire]),
                                                 .bits = 1});
    return 0;
}

static int forget_channels(void **state)
{
    (void)state;
    channels_free(&channels);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_many_frames_end_as_were_drawn),
        cmocka_unit_test(a_capture_from_the_middle_has_those_that_follow),
    };
    return cmocka_run_group_tests(tests, name_channels, forget_channels);
}
