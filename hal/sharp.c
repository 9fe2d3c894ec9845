/* SPDX-License-Identifier: MIT
 *
 * Memory LCDs behind struct panel.
 * In: windows of whole lines, and their pixels. Out: while select is high a command, then for each line its number, its
 * pixels and eight bits to store it in; sixteen after the last. The glass takes the lowest bit of a number first,
 * buses send the highest: numbers and commands are written here as the bus has them. */
#include "sharp.h"

#include "wire.h"

enum { WRITE = 0x80, POSITIVE = 0x40, CLEAR = 0x20 }; /* bits of a command, in the bus's order */

enum { SELECT_UNKNOWN, SELECT_LOW, SELECT_HIGH };

/* Waits by the slower part's datasheet: select before the first bit, after the last, and until the next; the sign's
 * latch at the start, before and after the glass is shown. */
#define SETUP_US UINT32_C(6)
#define HOLD_US UINT32_C(2)
#define LOW_US UINT32_C(6)
#define LATCH_US UINT32_C(30)

static struct sharp *sharp_of(const struct panel *panel)
{
    return panel->chip;
}

static uint8_t reversed(uint16_t number)
{
    unsigned bits = 0;

    for (uint8_t i = 0; i < 8; i++)
        bits |= ((unsigned)number >> i & 1u) << (7 - i);
    return (uint8_t)bits;
}

static int sharp_select(struct sharp *sharp)
{
    sharp->select = SELECT_UNKNOWN;
    int err = pin_set(&sharp->config.select, true);
    if (!err) err = clock_delay(&sharp->config.clock, SETUP_US);
    if (!err) sharp->select = SELECT_HIGH;
    return err;
}

/* Ends whatever the glass was told, when that has left the bus. */
static int sharp_release(struct sharp *sharp)
{
    sharp->select = SELECT_UNKNOWN;
    int err = bus_flush(&sharp->config.bus);
    if (!err) err = clock_delay(&sharp->config.clock, HOLD_US);
    if (!err) err = pin_set(&sharp->config.select, false);
    if (!err) err = clock_delay(&sharp->config.clock, LOW_US);
    if (!err) sharp->select = SELECT_LOW;
    return err;
}

/* A command, with the sign in it. */
static uint8_t sharp_command(struct sharp *sharp, uint8_t command)
{
    return (uint8_t)(command | (sharp->positive ? POSITIVE : 0));
}

static int sharp_send(struct sharp *sharp, uint8_t command)
{
    sharp->head[0] = sharp_command(sharp, command);
    sharp->head[1] = 0;
    int err = sharp_select(sharp);
    if (!err) err = bus_write(&sharp->config.bus, sharp->head, 2);
    if (!err) err = sharp_release(sharp);
    if (!err) sharp->told = true;
    return err;
}

/* A command that does nothing, if none has told the sign yet. */
static int sharp_tell(struct sharp *sharp)
{
    return sharp->told ? 0 : sharp_send(sharp, 0);
}

/* What comes after the last line: without it that line is not stored. Nor is one that an error cut short, as these bits
 * are too few for both. */
static int sharp_finish(struct sharp *sharp)
{
    static const uint8_t trailer[2] = {0};

    sharp->end_y_px = sharp->y_px;
    if (sharp->select == SELECT_LOW) return 0;
    int err = sharp->select == SELECT_HIGH ? bus_write(&sharp->config.bus, trailer, sizeof trailer) : 0;
    return err ? err : sharp_release(sharp);
}

static int sharp_alternate(struct sharp *sharp)
{
    const struct pin *alternate = &sharp->config.alternate;

    sharp->positive = !sharp->positive;
    sharp->told = pin_is_wired(alternate);
    if (!sharp->told) return 0;
    int err = pin_set(alternate, true);
    if (!err) err = clock_delay(&sharp->config.clock, HOLD_US);
    return err ? err : pin_set(alternate, false);
}

/* White first: what memory holds when the supply comes is chance. */
static int sharp_init(struct panel *panel)
{
    struct sharp *sharp = sharp_of(panel);

    sharp->end_y_px = sharp->y_px;
    sharp->select = SELECT_UNKNOWN;
    int err = wire_set(&sharp->config.shown, false);
    if (!err) err = sharp_release(sharp);
    if (!err) err = sharp_send(sharp, CLEAR);
    if (!err) err = clock_delay(&sharp->config.clock, LATCH_US);
    if (!err) err = wire_set(&sharp->config.shown, true);
    if (!err) err = clock_delay(&sharp->config.clock, LATCH_US);
    if (!err) err = sharp_alternate(sharp);
    return err ? err : sharp_tell(sharp);
}

static int sharp_begin_frame(struct panel *panel)
{
    return sharp_alternate(sharp_of(panel));
}

static int sharp_keep(struct panel *panel)
{
    struct sharp *sharp = sharp_of(panel);
    int err = sharp_finish(sharp);

    if (!err) err = sharp_alternate(sharp);
    return err ? err : sharp_tell(sharp);
}

/* The end of what was sent before: a trailer, and select goes low, and high again. */
enum { WINDOW_B = 2, WINDOW_MESSAGES = 3 };

static int sharp_window(struct panel *panel, uint16_t x_px, uint16_t y_px, uint16_t w_px, uint16_t h_px)
{
    struct sharp *sharp = sharp_of(panel);
    int err = sharp_finish(sharp);

    if (err) return err;
    if (!panel_holds(panel, x_px, y_px, w_px, h_px)) return PANEL_ERR_WINDOW;
    sharp->y_px = y_px;
    sharp->end_y_px = (uint16_t)(y_px + h_px);
    return 0;
}

/* Numbers start at 1. Before the first line's is the command, before others' the end of the line above. */
static int sharp_send_line(struct sharp *sharp, const uint8_t *pixels)
{
    const bool is_first = sharp->select != SELECT_HIGH;

    int err = is_first ? sharp_select(sharp) : 0;
    if (err) return err;
    sharp->head[0] = is_first ? sharp_command(sharp, WRITE) : 0;
    sharp->head[1] = reversed((uint16_t)(sharp->y_px + 1u));
    err = bus_write(&sharp->config.bus, sharp->head, 2);
    if (err) return err;
    sharp->told = true;
    return bus_write(&sharp->config.bus, pixels, sharp->panel.w_px / 8u);
}

static int sharp_pixels(struct panel *panel, const void *data, size_t n_px)
{
    struct sharp *sharp = sharp_of(panel);
    const uint8_t *pixels = data;

    for (size_t left_px = n_px; left_px; left_px -= panel->w_px, pixels += panel->w_px / 8u) {
        const bool fits = sharp->y_px < sharp->end_y_px && left_px >= panel->w_px;
        int err = fits ? sharp_send_line(sharp, pixels) : PANEL_ERR_WINDOW;
        if (err) {
            sharp->end_y_px = sharp->y_px;
            return err;
        }
        sharp->y_px++;
    }
    return 0;
}

/* A frame that had no line to send still changes the sign. */
static int sharp_flush(struct panel *panel)
{
    struct sharp *sharp = sharp_of(panel);
    int err = sharp_finish(sharp);

    return err ? err : sharp_tell(sharp);
}

static int sharp_blank(struct panel *panel, bool blank)
{
    struct sharp *sharp = sharp_of(panel);

    return pin_is_wired(&sharp->config.shown) ? wire_set(&sharp->config.shown, !blank) : PANEL_ERR_UNSUPPORTED;
}

int sharp_setup(struct sharp *sharp, const struct sharp_chip *chip, const struct sharp_config *config)
{
    static const struct panel_ops ops = {
        .init = sharp_init,
        .window = sharp_window,
        .pixels = sharp_pixels,
        .flush = sharp_flush,
        .begin_frame = sharp_begin_frame,
        .keep = sharp_keep,
        .blank = sharp_blank,
    };
    if (!config->bus.write || !config->select.set || !config->clock.delay) return PANEL_ERR_CONFIG;
    *sharp = (struct sharp){.config = *config};
    sharp->panel = (struct panel){.ops = &ops,
                                  .chip = sharp,
                                  .w_px = chip->w_px,
                                  .h_px = chip->h_px,
                                  .step_x_px = chip->w_px,
                                  .step_y_px = 1,
                                  .format = PANEL_MONO_LINES,
                                  .window_b = (uint16_t)(WINDOW_B + WINDOW_MESSAGES * config->bus.message_b)};
    return 0;
}
