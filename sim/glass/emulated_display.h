/* SPDX-License-Identifier: MIT
 *
 * An emulated module of any family, of the usual kind. Its bus reads late, as DMA does, so that a line painted over
 * before it was sent shows. */
#ifndef SIM_EMULATED_DISPLAY_H
#define SIM_EMULATED_DISPLAY_H

#include "displays/display.h"
#include "glass/emulated_dcs.h"
#include "glass/emulated_pages.h"
#include "glass/emulated_sharp.h"
#include "glass/emulated_solomon.h"

struct emulation;

/* Large, and must not move: place it on the heap. */
struct emulated_display {
    const struct emulation *emulation; /* of the chip's family */
    const char *name;
    struct emulated_port *port; /* the chip's */
    uint16_t w_px, h_px;
    union {
        struct emulated_dcs dcs;
        struct emulated_pages pages;
        struct emulated_solomon solomon;
        struct emulated_sharp sharp;
    } chip;
};

/* Power on. The chip is one of the table's. */
void emulated_display_init(struct emulated_display *display, const struct glass *glass);

/* The same, with the glass that a choice of module speaks of: glass_choose(). */
void emulated_display_choose(struct emulated_display *display, const struct panel_choice *panel,
                             const struct display_module *module);

/* How often the chip had anything to complain about since; text of the last. */
unsigned emulated_display_complaints(const struct emulated_display *display, const char **last);

/* What comes was not written by this project: what glass would bear of it is a notice, and no complaint. To be called
 * after init. */
void emulated_display_take_foreign(struct emulated_display *display);

/* How many notices there were since; text of the last. */
unsigned emulated_display_notices(const struct emulated_display *display, const char **last);

/* An error if the chip had anything to complain about since. */
bool emulated_display_is_quiet(const struct emulated_display *display, struct error *err);

/* What the eye sees on the upright glass: 3 bytes a pixel, red first. */
void emulated_display_show(const struct emulated_display *display, uint8_t *rgb);

/* The same as RGB565 numbers, turned and mirrored as the viewer of that module sees it; `rgb` is room for it. */
void emulated_display_read(const struct emulated_display *display, const struct display_module *module, uint8_t *rgb,
                           uint16_t *pixels);

#endif
