/* SPDX-License-Identifier: MIT
 *
 * The rig of the tests that hold for every panel: any chip of the lists, emulated, its driver and the screen on it, and
 * between them a port whose n-th call can go wrong. The card has a colour in each corner, clockwise red, green, blue
 * and grey, and elsewhere values that differ from their neighbours', so that a shift by one pixel shows; `seed` tells
 * cards apart. */
#ifndef TESTS_PANEL_RIG_H
#define TESTS_PANEL_RIG_H

#include "fakes/fault_port.h"
#include "glass/emulated_display.h"
#include "screen.h"

struct panel_rig {
    struct panel_choice choice;
    struct display_module module; /* of the glass, and how the picture is turned on it */
    struct emulated_display glass;
    struct fault_port fault;
    struct display display;
    struct screen screen;
    unsigned seed;
    uint16_t drawn_px; /* lines of the picture that are drawn, from the top; 0: all */
    uint32_t mem[SCREEN_WIDE_MEM_B(480, 2) / 4 + 2 * SCREEN_PAGE_B(480) / 4];
    uint8_t seen[3 * 320 * 480];
};

/* The emulated chip is powered. `port` (NULL: nothing) may change what is wired. false: the chip cannot mirror. */
bool panel_rig_setup(struct panel_rig *rig, const struct panel_choice *choice, const struct display_module *module,
                     void (*wire)(struct panel_rig *rig, struct port *port));

/* The same on glass of one's own choice. */
bool panel_rig_setup_on(struct panel_rig *rig, const struct panel_choice *choice, const struct display_module *module,
                        const struct glass *glass);

/* A small module, or one with all of the chip's memory: no larger than the chip, and of the sizes that it comes in. */
struct display_module panel_rig_module(const struct panel_choice *choice, uint16_t w_px, uint16_t h_px);

/* Draws the card through the screen, in pieces of at most piece_px: 0, or the first error. */
int panel_rig_draw(struct panel_rig *rig, unsigned piece_px);

/* Fails unless the viewer sees the card, as it was turned and mirrored, in the panel's format; or its negative. */
void panel_rig_assert_seen(struct panel_rig *rig, bool negative);

/* Whether he does. */
bool panel_rig_sees(struct panel_rig *rig);

/* Fails if every pixel of the glass has not this value of red, green and blue. */
void panel_rig_assert_blank(struct panel_rig *rig, uint8_t value);

/* Complaints of the emulated chip so far; panel_rig_assert_quiet() fails if there were more since. */
unsigned panel_rig_complaints(const struct panel_rig *rig);
void panel_rig_assert_quiet(const struct panel_rig *rig, unsigned since);

#endif
