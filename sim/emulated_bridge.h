/* SPDX-License-Identifier: MIT
 *
 * An emulated MCP2210 on an emulated cable, wired to an emulated display: GP0 to D/C, GP1 to reset, GP2 to the
 * backlight, GP3 to chip select. */
#ifndef SIM_EMULATED_BRIDGE_H
#define SIM_EMULATED_BRIDGE_H

#include "emulated_cable.h"
#include "emulated_mcp2210.h"
#include "emulated_port.h"
#include "hid/bridge_port.h"

/* Must not move. */
struct emulated_bridge {
    struct emulated_mcp2210 chip;
    struct emulated_cable cable;
    struct emulated_port *display;
    unsigned opened; /* how often */
};

void emulated_bridge_init(struct emulated_bridge *bridge, struct emulated_port *display);

/* Plugged in again, after a power-up. */
void emulated_bridge_replug(struct emulated_bridge *bridge);

/* As a port reaches it; its clock is the display's. */
struct bridge_link emulated_bridge_link(struct emulated_bridge *bridge);

/* The pins as they are wired. */
struct bridge_options emulated_bridge_options(void);

#endif
