/* SPDX-License-Identifier: MIT
 *
 * The rig of the tests of bridges: a display, its driver and the screen on it, once at a port of its own, whose glass
 * is the golden one, and once behind an emulated bridge. */
#ifndef TESTS_BRIDGE_RIG_H
#define TESTS_BRIDGE_RIG_H

#include "displays/display.h"
#include "glass/emulated_bridge.h"
#include "glass/emulated_display.h"
#include "screen.h"

enum { BRIDGE_RIG_MOST_PX = 128 * 160, BRIDGE_RIG_MOST_W_PX = 240 };

struct bridge_rig {
    struct panel_choice choice;
    struct display_module module;
    struct emulated_display glass;
    struct emulated_bridge bridge; /* to the glass */
    struct display display;        /* the driver */
    struct screen screen;
    uint32_t mem[SCREEN_PAGES_MEM_B(BRIDGE_RIG_MOST_W_PX, 2) / 4];
    uint8_t golden[3][BRIDGE_RIG_MOST_PX * 3]; /* what pictures 0 to 2 look like */
};

/* Chip by name, upright glass; draws the golden pictures. */
void bridge_rig_setup(struct bridge_rig *rig, const char *panel, uint16_t w_px, uint16_t h_px);

/* Sets the driver up on a port, without a byte sent. */
void bridge_rig_connect(struct bridge_rig *rig, const struct port *port);

/* One of three pictures of noise. 0 or the port's code. */
int bridge_rig_draw(struct bridge_rig *rig, unsigned picture);

/* panel_init() and a picture. */
int bridge_rig_start(struct bridge_rig *rig, unsigned picture);

/* Fails unless the glass shows the picture and the display has nothing to complain about. */
void bridge_rig_assert_shown(const struct bridge_rig *rig, unsigned picture);

/* What the display complained about so far: of a frame that broke off it may have reason to. */
void bridge_rig_forgive(struct bridge_rig *rig);

/* Fails if the bridge has anything to complain about. */
void bridge_rig_assert_quiet(const struct bridge_rig *rig);

#endif
