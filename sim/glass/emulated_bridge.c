/* SPDX-License-Identifier: MIT */
#include "glass/emulated_bridge.h"

#include "hid/ch347.h"
#include "hid/mcp2210.h"

#include <errno.h>

/* Pins of an MCP2210 and of a CH347T. */
enum { AT_DC, AT_RESET, AT_BACKLIGHT, AT_SELECT };
enum { CH347_AT_SELECT = 2, CH347_AT_DC = 3, CH347_AT_RESET = 4, CH347_AT_BACKLIGHT = 6 };

/* A display whose select is no chip select: its driver's pin, like others. */
static bool selects_itself(const struct emulated_bridge *bridge)
{
    return bridge->display->select != NULL;
}

void emulated_bridge_init(struct emulated_bridge *bridge, struct emulated_port *display)
{
    emulated_mcp2210_init(&bridge->chip);
    emulated_cable_init(&bridge->cable, &bridge->chip, emulated_mcp2210_answer, EMULATED_MCP2210_REPORT_B);
    bridge->kind = &mcp2210;
    bridge->display = display;
    bridge->opened = 0;
    bridge->chip.spi = emulated_port_bus(display);
    bridge->chip.pins[AT_DC] = emulated_port_dc(display);
    bridge->chip.pins[AT_RESET] = emulated_port_reset(display);
    bridge->chip.pins[AT_BACKLIGHT] = emulated_port_backlight(display);
    bridge->chip.pins[AT_SELECT] = emulated_port_select(display);
    bridge->chip.select = selects_itself(bridge) ? EMULATED_MCP2210_UNWIRED : AT_SELECT;
}

void emulated_bridge_init_ch347(struct emulated_bridge *bridge, struct emulated_port *display)
{
    emulated_bridge_init(bridge, display);
    emulated_ch347_init(&bridge->ch347);
    emulated_cable_init(&bridge->cable, &bridge->ch347, emulated_ch347_answer, EMULATED_CH347_REPORT_B);
    bridge->kind = &ch347;
    bridge->ch347.spi = emulated_port_bus(display);
    bridge->ch347.pins[CH347_AT_DC] = emulated_port_dc(display);
    bridge->ch347.pins[CH347_AT_RESET] = emulated_port_reset(display);
    bridge->ch347.pins[CH347_AT_BACKLIGHT] = emulated_port_backlight(display);
    bridge->ch347.select = CH347_AT_SELECT;
}

void emulated_bridge_replug(struct emulated_bridge *bridge)
{
    emulated_mcp2210_power_up(&bridge->chip);
    emulated_ch347_power_up(&bridge->ch347);
    emulated_cable_replug(&bridge->cable);
}

static int open_link(void *ctx, struct reports *reports, const struct bridge_kind **kind)
{
    struct emulated_bridge *bridge = ctx;

    if (bridge->cable.unplugged) return -ENODEV;
    bridge->opened++;
    *reports = emulated_cable_reports(&bridge->cable);
    *kind = bridge->kind;
    return 0;
}

static void close_link(void *ctx)
{
    (void)ctx;
}

static const char *name(void *ctx)
{
    const struct emulated_bridge *bridge = ctx;

    return bridge->kind == &ch347 ? "emulated CH347T" : "emulated MCP2210";
}

static const char *why(void *ctx)
{
    const struct emulated_bridge *bridge = ctx;

    return bridge->cable.unplugged ? "unplugged; plug it in again" : "the cable failed";
}

struct bridge_link emulated_bridge_link(struct emulated_bridge *bridge)
{
    return (struct bridge_link){.ctx = bridge,
                                .open = open_link,
                                .close = close_link,
                                .name = name,
                                .why = why,
                                .clock = emulated_port_clock(bridge->display)};
}

struct bridge_options emulated_bridge_options(const struct emulated_bridge *bridge)
{
    if (bridge->kind == &ch347)
        return (struct bridge_options){.dc = "GP3", .reset = "GP4", .backlight = "GP6", .chip_select = "GP2"};
    struct bridge_options options = {.dc = "GP0", .reset = "GP1", .backlight = "GP2"};
    *(selects_itself(bridge) ? &options.select : &options.chip_select) = "GP3";
    return options;
}

const char *emulated_bridge_complaint(const struct emulated_bridge *bridge)
{
    if (bridge->kind == &ch347) return bridge->ch347.complaints ? bridge->ch347.complaint : NULL;
    return bridge->chip.complaints ? bridge->chip.complaint : NULL;
}
