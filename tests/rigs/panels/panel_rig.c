/* SPDX-License-Identifier: MIT
 *
 * What is expected is computed from the definition of each format, in floating point: it shares nothing with hal/. */
#include "rigs/panels/panel_rig.h"

#include "rigs/cmocka_ready.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint16_t step_down(unsigned px, uint16_t step_px)
{
    return (uint16_t)(px / step_px * step_px);
}

struct display_module panel_rig_module(const struct panel_choice *choice, uint16_t w_px, uint16_t h_px)
{
    const uint16_t most_w_px = w_px < choice->mem_w_px ? w_px : choice->mem_w_px;
    const uint16_t most_h_px = h_px < choice->mem_h_px ? h_px : choice->mem_h_px;
    struct display_module module = {.w_px = step_down(most_w_px, choice->w_step_px),
                                    .h_px = step_down(most_h_px, choice->h_step_px)};

    if (module.w_px == 0) module.w_px = choice->w_step_px;
    if (module.h_px == 0) module.h_px = choice->h_step_px;
    module.ox_px = step_down((choice->mem_w_px - module.w_px) / 3u, choice->w_step_px);
    module.oy_px = step_down((choice->mem_h_px - module.h_px) / 3u, choice->h_step_px);
    return module;
}

/* The driver, on the emulated chip as it was powered. */
static bool start(struct panel_rig *rig, const struct panel_choice *choice, const struct display_module *module,
                  void (*wire)(struct panel_rig *rig, struct port *port))
{
    struct error err;

    rig->choice = *choice;
    rig->module = *module;
    rig->drawn_px = 0;
    struct port port = emulated_port_whole(rig->glass.port);
    if (wire) wire(rig, &port);
    port = fault_port_over(&rig->fault, &port, &rig->glass.port->pending_b);
    if (!display_setup(&rig->display, choice, module, &port, &err)) return false;
    assert_int_equal(screen_init(&rig->screen, rig->display.panel, LIM_NEAREST_FIRST, rig->mem, sizeof rig->mem), 0);
    return true;
}

bool panel_rig_setup(struct panel_rig *rig, const struct panel_choice *choice, const struct display_module *module,
                     void (*wire)(struct panel_rig *rig, struct port *port))
{
    emulated_display_choose(&rig->glass, choice, module);
    return start(rig, choice, module, wire);
}

bool panel_rig_setup_on(struct panel_rig *rig, const struct panel_choice *choice, const struct display_module *module,
                        const struct glass *glass)
{
    emulated_display_init(&rig->glass, glass);
    return start(rig, choice, module, NULL);
}

/* The picture --------------------------------------------------------------------------------- */

static uint16_t card_px(const struct panel_rig *rig, unsigned x, unsigned y)
{
    const bool lies = rig->module.rotation & 1;
    const unsigned w = lies ? rig->module.h_px : rig->module.w_px, h = lies ? rig->module.w_px : rig->module.h_px;
    const unsigned side = (w < h ? w : h) / 4;
    const bool left = x < side, right = x >= w - side, top = y < side, bottom = y >= h - side;

    if (top && left) return 0xF800;
    if (top && right) return 0x07E0;
    if (bottom && right) return 0x001F;
    if (bottom && left) return 0x8410;
    return (uint16_t)(x * 211u + y * 31u + rig->seed * 7919u);
}

/* Which pixel of a picture that was turned clockwise by so many quarters lies there on glass of w_px x h_px. */
static void turn(unsigned quarters, unsigned w_px, unsigned h_px, unsigned *x, unsigned *y)
{
    const unsigned right = w_px - 1 - *x, below = h_px - 1 - *y;
    const unsigned turned_x[] = {*x, *y, right, below}, turned_y[] = {*y, right, below, *x};

    *x = turned_x[quarters];
    *y = turned_y[quarters];
}

/* What the renderer paints there: the picture, turned as far as it is the camera that turns it. */
static uint16_t painted_px(const struct panel_rig *rig, unsigned x, unsigned y)
{
    turn(rig->display.camera_turn, rig->module.w_px, rig->module.h_px, &x, &y);
    return card_px(rig, x, y);
}

static int draw_line(struct panel_rig *rig, uint16_t y, unsigned piece_px)
{
    const struct lim_target *target = &rig->screen.target;

    for (unsigned x = 0; x < target->w_px; x += piece_px) {
        const unsigned n = target->w_px - x < piece_px ? target->w_px - x : piece_px;
        uint8_t *line = target->lend(target->ctx, y);
        memset(line, 0xEE, 2u * target->w_px);
        for (unsigned i = x; i < x + n; i++) {
            const uint16_t px = painted_px(rig, i, y);
            line[2 * i] = (uint8_t)(px >> 8);
            line[2 * i + 1] = (uint8_t)px;
        }
        const int err = target->done(target->ctx, y, (uint16_t)x, (uint16_t)n);
        if (err) return err;
    }
    return 0;
}

static uint16_t drawn_px(const struct panel_rig *rig)
{
    return rig->drawn_px && rig->drawn_px < rig->screen.target.h_px ? rig->drawn_px : rig->screen.target.h_px;
}

int panel_rig_draw(struct panel_rig *rig, unsigned piece_px)
{
    int err = screen_begin_frame(&rig->screen);

    for (uint16_t y = 0; y < drawn_px(rig) && !err; y++)
        err = draw_line(rig, y, piece_px);
    return err ? err : screen_end_frame(&rig->screen);
}

/* What is seen -------------------------------------------------------------------------------- */

/* Bayer's order of 2^k x 2^k, from that of half the size: each quarter is filled in the order of the whole. */
static unsigned order_of(unsigned x, unsigned y, unsigned k)
{
    static const unsigned two[2][2] = {{0, 2}, {3, 1}};

    if (k == 0) return 0;
    return 4 * order_of(x % (1u << (k - 1)), y % (1u << (k - 1)), k - 1) + two[y >> (k - 1) & 1][x >> (k - 1) & 1];
}

/* Of levels 0..most the one that a value of 0..1 gets at its place, as 0..255. */
static int dithered(double value, int most, unsigned x, unsigned y, unsigned k)
{
    const int places = 1 << 2 * k;
    const double level =
        floor(value * most + (2 * order_of(x % (1u << k), y % (1u << k), k) + 1) / (2.0 * places) + 1e-9);

    return (int)fmin(level, most) * 255 / most;
}

static int widened(unsigned bits, unsigned n_bits)
{
    return (int)(bits << (8 - n_bits) | bits >> (2 * n_bits - 8));
}

static void expect(enum panel_format format, uint16_t px, unsigned x, unsigned y, int rgb[3])
{
    const unsigned of[] = {px >> 11, px >> 5 & 63, px & 31};
    const double most[] = {31, 63, 31};
    const double level = 0.299 * of[0] / 31 + 0.587 * of[1] / 63 + 0.114 * of[2] / 31;

    for (unsigned i = 0; i < 3; i++) {
        if (format == PANEL_RGB565)
            rgb[i] = widened(of[i], i == 1 ? 6 : 5);
        else if (format == PANEL_RGB444)
            rgb[i] = dithered(of[i] / most[i], 15, x, y, 2);
        else if (format == PANEL_RGB666 || format == PANEL_RGB666_LOW)
            rgb[i] = widened((unsigned)floor(of[i] * 63 / most[i] + 0.5), 6);
        else
            rgb[i] = format == PANEL_GREY4 ? dithered(level, 15, x, y, 2) : dithered(level, 1, x, y, 3);
    }
}

/* Brightness is rounded to 2^-16, so that on a threshold it may fall to the neighbouring level. */
static bool is_near(enum panel_format format, int difference)
{
    if (format == PANEL_GREY4) return difference <= 17;
    return format == PANEL_MONO_PAGES || format == PANEL_MONO_LINES;
}

static bool is_on_glass(const struct panel_rig *rig, unsigned x, unsigned y)
{
    const double w = rig->module.w_px, h = rig->module.h_px, dx = (2 * x + 1) / w - 1, dy = (2 * y + 1) / h - 1;

    return strcmp(rig->choice.name, "gc9a01") != 0 || dx * dx + dy * dy <= 1;
}

/* Which pixel of the screen's lies there on the glass. */
static void painted_at(const struct panel_rig *rig, unsigned *x, unsigned *y)
{
    if (rig->display.camera_turn == PANEL_UPRIGHT) turn(rig->module.rotation, rig->module.w_px, rig->module.h_px, x, y);
    if (rig->module.mirror) *x = rig->screen.target.w_px - 1u - *x;
}

/* How far what is seen of a pixel of the glass is from what was drawn. */
static int difference_at(const struct panel_rig *rig, unsigned i, unsigned x, unsigned y, bool negative)
{
    int rgb[3], difference = 0;

    expect(rig->display.panel->format, painted_px(rig, x, y), x, y, rgb);
    for (unsigned k = 0; k < 3; k++) {
        const int wanted = negative ? 255 - rgb[k] : rgb[k], differs = abs(wanted - rig->seen[3 * i + k]);
        difference = differs > difference ? differs : difference;
    }
    return difference;
}

/* The first pixel of the glass that is not as it should be, or how many there are. */
static unsigned first_wrong(struct panel_rig *rig, bool negative, int *difference)
{
    const unsigned w = rig->module.w_px, h = rig->module.h_px;
    unsigned near = 0;

    emulated_display_show(&rig->glass, rig->seen);
    for (unsigned i = 0; i < w * h; i++) {
        unsigned x = i % w, y = i / w;
        painted_at(rig, &x, &y);
        if (y >= drawn_px(rig) || !is_on_glass(rig, i % w, i / w)) continue;
        *difference = difference_at(rig, i, x, y, negative);
        near += *difference != 0;
        if (*difference && (!is_near(rig->display.panel->format, *difference) || near > 4 + w * h / 200)) return i;
    }
    return w * h;
}

bool panel_rig_sees(struct panel_rig *rig)
{
    int difference;

    return first_wrong(rig, false, &difference) == (unsigned)rig->module.w_px * rig->module.h_px;
}

void panel_rig_assert_seen(struct panel_rig *rig, bool negative)
{
    const unsigned w = rig->module.w_px, h = rig->module.h_px;
    int difference = 0;
    const unsigned wrong = first_wrong(rig, negative, &difference);

    if (wrong != w * h)
        fail_msg("%s, turned %u: pixel %u,%u of the glass is off by %d", rig->choice.name, rig->module.rotation,
                 wrong % w, wrong / w, difference);
}

void panel_rig_assert_blank(struct panel_rig *rig, uint8_t value)
{
    emulated_display_show(&rig->glass, rig->seen);
    for (size_t i = 0; i < 3u * rig->module.w_px * rig->module.h_px; i++)
        if (rig->seen[i] != value) fail_msg("%s: byte %zu of the glass is %u", rig->choice.name, i, rig->seen[i]);
}

unsigned panel_rig_complaints(const struct panel_rig *rig)
{
    const char *last;

    return emulated_display_complaints(&rig->glass, &last);
}

void panel_rig_assert_quiet(const struct panel_rig *rig, unsigned since)
{
    const char *last;
    const unsigned complaints = emulated_display_complaints(&rig->glass, &last) - since;

    if (complaints) fail_msg("%s: %u complaints, the last: %s", rig->choice.name, complaints, last);
}
