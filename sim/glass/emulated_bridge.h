/* SPDX-License-Identifier: MIT
 *
 * An emulated bridge on an emulated cable, wired to an emulated display. An MCP2210 has D/C at GP0, reset at GP1, the
 * backlight at GP2, chip select, or the select of a memory LCD, at GP3. */
#ifndef SIM_EMULATED_BRIDGE_H
#define SIM_EMULATED_BRIDGE_H

#include "glass/emulated_cable.h"
#include "glass/emulated_mcp2210.h"
#include "glass/emulated_port.h"
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
struct bridge_options emulated_bridge_options(const struct emulated_bridge *bridge);

/* What it complained about: NULL for nothing. */
const char *emulated_bridge_complaint(const struct emulated_bridge *bridge);

#endif
