/* SPDX-License-Identifier: MIT
 *
 * The rig of the panel tests: an emulated module, the driver and the screen on it, a port between
 * them whose n-th call can be made to fail, and a test card with checks of what the viewer sees.
 * The card has a colour in each corner, clockwise red, green, blue and grey, and elsewhere a value
 * that differs from its neighbours', so that a shift by one pixel shows. */
#ifndef TESTS_DCS_RIG_H
#define TESTS_DCS_RIG_H

#include "fakes/fault_port.h"
#include "glass/emulated_dcs.h"
#include "panels.h"
#include "rigs/cmocka_ready.h"
#include "screen.h"
#include "test_card.h"

#include <string.h>

enum {
    MOST_PX = 320 * 480,
    RED = TEST_CARD_RED,
    GREEN = TEST_CARD_GREEN,
    BLUE = TEST_CARD_BLUE,
    GREY = TEST_CARD_GREY
};

struct rig {
    struct emulated_dcs chip;
    struct dcs_config config;
    struct dcs display;
    struct screen screen;
    struct fault_port fault; /* between driver and emulated chip */
    struct bus bus;          /* the chip's own port, behind the decorator */
    struct pin dc, reset, backlight;
    struct clock clock;
    const struct dcs_chip *driver;
    uint32_t mem[SCREEN_WIDE_MEM_B(480, 480) / 4];
    uint32_t raw[MOST_PX];
    uint8_t rgb[MOST_PX * 3];
};

static struct rig rig; /* too large for a stack; every test sets it up afresh */

/* A fault is forgotten, and call number fail_at will be the next one. */
static inline void fault_arm(long fail_at)
{
    fault_port_arm(&rig.fault, fail_at);
}

/* Glass like that of the chip's usual module, but for what stands here. */
struct dcs_make {
    const char *chip; /* NULL: st7789 */
    uint16_t w_px, h_px, ox_px, oy_px;
    bool ips, bgr;
};

static inline void power_chip(struct dcs_make make)
{
    struct glass glass = glass_like(make.chip ? make.chip : "st7789", make.w_px, make.h_px, make.ox_px, make.oy_px);
    glass.negative = make.ips;
    glass.blue_first = make.bgr;
    emulated_dcs_init(&rig.chip, &glass);
}

/* An emulated module and a configuration that suits it, all pins wired. */
static inline void rig_setup(struct dcs_make module)
{
    power_chip(module);
    rig.driver = NULL;
    for (size_t i = 0; panels_dcs[i]; i++)
        if (strcmp(panels_dcs[i]->name, rig.chip.kind->name) == 0) rig.driver = panels_dcs[i];
    assert_non_null(rig.driver);
    rig.bus = emulated_port_bus(&rig.chip.port);
    rig.dc = emulated_port_dc(&rig.chip.port);
    rig.reset = emulated_port_reset(&rig.chip.port);
    rig.backlight = emulated_port_backlight(&rig.chip.port);
    rig.clock = emulated_port_clock(&rig.chip.port);
    rig.fault = (struct fault_port){.bus = rig.bus,
                                    .dc = {.inner = rig.dc},
                                    .reset = {.inner = rig.reset},
                                    .backlight = {.inner = rig.backlight},
                                    .clock = rig.clock,
                                    .pending_b = &rig.chip.port.pending_b};
    rig.config = (struct dcs_config){
        .bus = fault_port_bus(&rig.fault),
        .dc = fault_port_pin(&rig.fault, &rig.fault.dc),
        .reset = fault_port_pin(&rig.fault, &rig.fault.reset),
        .backlight = fault_port_pin(&rig.fault, &rig.fault.backlight),
        .clock = fault_port_clock(&rig.fault),
        .w_px = module.w_px,
        .h_px = module.h_px,
        .ox_px = module.ox_px,
        .oy_px = module.oy_px,
        .bgr = module.bgr,
        .invert = module.ips,
    };
    fault_arm(-1);
}

static const struct dcs_make module_240x240 = {.w_px = 240, .h_px = 240, .ips = true};
static const struct dcs_make module_135x240 = {.w_px = 135, .h_px = 240, .ox_px = 52, .oy_px = 40, .ips = true};
static const struct dcs_make module_240x280 = {.w_px = 240, .h_px = 280, .oy_px = 20, .ips = true};
static const struct dcs_make module_small = {.w_px = 17, .h_px = 24, .ox_px = 100, .oy_px = 90, .ips = true};

static inline uint16_t card_px(unsigned x, unsigned y, unsigned w, unsigned h)
{
    uint16_t corner;
    return test_card_corner(x, y, w, h, &corner) ? corner : (uint16_t)(x * 211u + y * 31u);
}

/* Paints as the renderer does: junk first, then the line; in pieces of at most piece_px. */
static inline int draw_lines(struct screen *screen, unsigned first, unsigned end, unsigned piece_px)
{
    const struct lim_target *target = &screen->target;
    for (unsigned y = first; y < end; y++) {
        uint8_t *line = target->lend(target->ctx, (uint16_t)y);
        assert_non_null(line);
        memset(line, 0xEE, 2u * target->w_px);
        for (unsigned x = 0; x < target->w_px; x++) {
            uint16_t px = card_px(x, y, target->w_px, target->h_px);
            line[2 * x] = (uint8_t)(px >> 8);
            line[2 * x + 1] = (uint8_t)px;
        }
        for (unsigned x = 0; x < target->w_px; x += piece_px) {
            unsigned n = target->w_px - x < piece_px ? target->w_px - x : piece_px;
            int err = target->done(target->ctx, (uint16_t)y, (uint16_t)x, (uint16_t)n);
            if (err) return err;
        }
    }
    return 0;
}

static inline int draw_frame(struct screen *screen)
{
    int err = screen_begin_frame(screen);
    if (err) return err;
    err = draw_lines(screen, 0, screen->target.h_px, screen->target.w_px);
    if (err) return err;
    return screen_end_frame(screen);
}

static inline void rig_open(unsigned n_lines)
{
    assert_int_equal(dcs_setup(&rig.display, rig.driver, &rig.config), 0);
    struct panel *panel = &rig.display.panel;
    size_t mem_b =
        panel->format == PANEL_RGB666 ? SCREEN_WIDE_MEM_B(panel->w_px, n_lines) : SCREEN_MEM_B(panel->w_px, n_lines);
    assert_int_equal(screen_init(&rig.screen, panel, LIM_NEAREST_FIRST, rig.mem, mem_b), 0);
}

static inline void rig_start(unsigned n_lines)
{
    rig_open(n_lines);
    assert_int_equal(panel_init(&rig.display.panel), 0);
}

static inline void assert_quiet(void)
{
    if (rig.chip.complaints > 0) fail_msg("%u complaints, last: %s", rig.chip.complaints, rig.chip.complaint);
}

static inline void assert_complaint(enum emulated_complaint kind)
{
    if (rig.chip.complaints != 1 || rig.chip.complaints_of[kind] != 1) {
        fail_msg("%u complaints, last: %s", rig.chip.complaints, rig.chip.complaint);
    }
    assert_true(rig.chip.complaint[0] != '\0');
}

/* Every pixel of the picture as the viewer has it, mirrored back if need be. */
static inline void assert_card_shown(unsigned quarter_turns, bool mirrored)
{
    unsigned w = rig.display.panel.w_px, h = rig.display.panel.h_px;
    emulated_dcs_show(&rig.chip, quarter_turns, NULL, rig.raw);
    for (unsigned y = 0; y < h; y++) {
        for (unsigned x = 0; x < w; x++) {
            uint32_t shown = rig.raw[y * w + (mirrored ? w - 1 - x : x)];
            uint16_t drawn = card_px(x, y, w, h);
            if (shown != drawn) fail_msg("pixel %u,%u is %04x, not %04x", x, y, (unsigned)shown, drawn);
        }
    }
}

/* Colours at the glass's corners, clockwise from the top left of the upright glass. */
static inline void corners(uint32_t seen[4])
{
    unsigned w = rig.config.w_px, h = rig.config.h_px;
    const size_t at[] = {0, w - 1, (size_t)w * h - 1, (size_t)w * (h - 1)};
    emulated_dcs_show(&rig.chip, 0, rig.rgb, NULL);
    for (unsigned i = 0; i < 4; i++) {
        const uint8_t *rgb = &rig.rgb[at[i] * 3];
        seen[i] = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
    }
}

static const uint32_t seen_rgb[4] = {0xFF0000, 0x00FF00, 0x0000FF, 0x848284};

static inline void assert_corners(uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    uint32_t seen[4];
    corners(seen);
    const uint32_t expected[] = {a, b, c, d};
    for (unsigned i = 0; i < 4; i++) {
        if (seen[i] != expected[i])
            fail_msg("corner %u is %06x, not %06x", i, (unsigned)seen[i], (unsigned)expected[i]);
    }
}

#endif
