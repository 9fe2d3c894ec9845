/* SPDX-License-Identifier: MIT
 *
 * A port that does nothing, with success: for asking a driver what it makes of its configuration. */
#ifndef SIM_IDLE_PORT_H
#define SIM_IDLE_PORT_H

#include "port.h"

/* Its bus, its clock, and every pin wired. */
struct port idle_port(void);

#endif
