/* SPDX-License-Identifier: MIT
 *
 * The glass that a choice of module speaks of: where the table has a row of that chip and size, that row, changed as
 * far as somebody said that the module differs from the usual one; else glass like the chip's usual one. How a picture
 * is turned on it, and what the driver tells the chip without being asked, is no part of this. */
#ifndef SIM_GLASS_CHOICE_H
#define SIM_GLASS_CHOICE_H

#include "displays/display.h"
#include "glass/glass.h"

struct glass glass_choose(const struct panel_choice *panel, const struct display_module *module);

#endif
