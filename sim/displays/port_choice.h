/* SPDX-License-Identifier: MIT
 *
 * Which port a display hangs on, as the command line names it. A kind of port is a section of port_choice.c: its
 * options, and how it is opened. */
#ifndef SIM_PORT_CHOICE_H
#define SIM_PORT_CHOICE_H

#include "base/arguments.h"
#include "hid/bridge_port.h"
#include "linux/linux_port.h"

enum port_kind { PORT_LINUX, PORT_HID };

struct port_choice {
    enum port_kind kind;
    struct linux_port_config
        linux_port;          /* for PORT_LINUX, and of PORT_HID what they share; but for the struct port_clock */
    const char *serial;      /* for PORT_HID; NULL: the only bridge */
    const char *chip_select; /* for PORT_HID; NULL: the display's is tied low */
};

/* Takes its options out of *arguments, and refuses those that contradict each other or leave the port open. */
bool port_choice_parse(struct port_choice *out, struct arguments *arguments, struct error *err);

/* A port with the pins that were asked for, all of which do nothing: to see whether a panel can do with them. */
struct port port_choice_stand_in(const struct port_choice *choice);

/* What the module says of the bus. */
struct port_clock {
    uint32_t speed_hz;
    uint8_t mode;
    bool any_mode; /* nobody asked for just that mode: as in struct linux_port_config */
};

/* The strings and *port must stay where they are until port_close(). What the port does otherwise than it was asked to
 * is said by notice(). */
bool port_choice_open(const struct port_choice *choice, const struct port_clock *clock, struct port *port,
                      struct error *err);

#endif
