/* SPDX-License-Identifier: MIT
 *
 * A port that does nothing, with success: for asking a driver what it makes of its configuration. */
#ifndef SIM_IDLE_PORT_H
#define SIM_IDLE_PORT_H

#include "displays/module_choice.h"
#include "port.h"

/* Its bus, its clock, and every pin wired. */
struct port idle_port(void);

/* A driver on it, with every pin that the panel may want. Must not move. */
bool idle_display_setup(struct display *display, const struct module_choice *choice, struct error *err);

#endif
