/* SPDX-License-Identifier: MIT */
#include "glass/emulated_bridge.h"

#include "hid/mcp2210.h"

#include <errno.h>

/* Its pins. */
enum { AT_DC, AT_RESET, AT_BACKLIGHT, AT_SELECT };

/* A display whose select is no chip select: its driver's pin, like others. */
static bool selects_itself(const struct emulated_bridge *bridge)
{
    return bridge->display->select != NULL;
}

void emulated_bridge_init(struct emulated_bridge *bridge, struct emulated_port *display)
{
    emulated_mcp2210_init(&bridge->chip);
    emulated_cable_init(&bridge->cable, &bridge->chip, emulated_mcp2210_answer, EMULATED_MCP2210_REPORT_B);
    bridge->display = display;
    bridge->opened = 0;
    bridge->chip.spi = emulated_port_bus(display);
    bridge->chip.pins[AT_DC] = emulated_port_dc(display);
    bridge->chip.pins[AT_RESET] = emulated_port_reset(display);
    bridge->chip.pins[AT_BACKLIGHT] = emulated_port_backlight(display);
    bridge->chip.pins[AT_SELECT] = emulated_port_select(display);
    bridge->chip.select = selects_itself(bridge) ? EMULATED_MCP2210_UNWIRED : AT_SELECT;
}

void emulated_bridge_replug(struct emulated_bridge *bridge)
{
    emulated_mcp2210_power_up(&bridge->chip);
    emulated_cable_replug(&bridge->cable);
}

static int open_link(void *ctx, struct reports *reports, const struct bridge_kind **kind)
{
    struct emulated_bridge *bridge = ctx;

    if (bridge->cable.unplugged) return -ENODEV;
    bridge->opened++;
    *reports = emulated_cable_reports(&bridge->cable);
    *kind = &mcp2210;
    return 0;
}

static void close_link(void *ctx)
{
    (void)ctx;
}

static const char *name(void *ctx)
{
    (void)ctx;
    return "emulated MCP2210";
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
    struct bridge_options options = {.dc = "GP0", .reset = "GP1", .backlight = "GP2"};
    *(selects_itself(bridge) ? &options.select : &options.chip_select) = "GP3";
    return options;
}

const char *emulated_bridge_complaint(const struct emulated_bridge *bridge)
{
    return bridge->chip.complaints ? bridge->chip.complaint : NULL;
}
