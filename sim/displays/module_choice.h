/* SPDX-License-Identifier: MIT
 *
 * Which module a panel is, as the command line describes it; what is left out is as on the usual module with that chip.
 */
#ifndef SIM_MODULE_CHOICE_H
#define SIM_MODULE_CHOICE_H

#include "base/arguments.h"
#include "displays/display.h"
#include "spi_modes.h"

struct module_choice {
    struct panel_choice panel;
    struct display_module module;
    uint32_t speed_hz; /* clock of the bus, the usual one if nobody said otherwise */
    uint8_t spi_modes; /* that it takes, a set of spi_modes.h; one alone if somebody said so */
    bool mode_given;
};

/* Takes --panel, --hz, --mode, --size, --memory, --offset, --start-line, --rotate, --mirror, --mirror-columns,
 * --mirror-rows,
 * --bgr or --rgb, --invert or --no-invert, --contrast, --wiring, --converter out of *arguments. */
bool module_choice_parse(struct module_choice *out, struct arguments *arguments, struct error *err);

/* Of the picture as its viewer has it, turned. */
void module_choice_picture(const struct display_module *module, unsigned *w_px, unsigned *h_px);

/* The glass, upright, that is usual with the chip. */
void module_usual_size(const struct panel_choice *panel, unsigned *w_px, unsigned *h_px);

#endif
