/* SPDX-License-Identifier: MIT
 *
 * A port that a program on a host opens by name at run time: bus, pins and clock behind one handle. What fails returns
 * a negative errno and leaves one line in `error` that names the thing, the reason and what could help:
 *
 *     /dev/spidev0.0: in use by another program; `fuser /dev/spidev0.0` names it
 *
 * A microcontroller's port needs none of this: its board fills struct bus, pin and clock. */
#ifndef HAL_PORT_H
#define HAL_PORT_H

#include "bus.h"

enum { PORT_ERROR_B = 384 };

struct port {
    struct bus bus;
    struct pin dc, reset, backlight, select, led; /* those that were not asked for are not wired */
    struct edge tearing;
    struct clock clock;
    uint8_t spi_mode;                 /* 0 .. 3, in which it sends */
    char error[PORT_ERROR_B];         /* of the call that failed last, without a newline */
    char notice[PORT_ERROR_B];        /* what it does otherwise than it was asked to, as it cannot; "": nothing */
    void *ctx;                        /* the port's own state */
    void (*close)(struct port *port); /* releases lines and devices; NULL: not open */
};

static inline void port_close(struct port *port)
{
    if (port->close) port->close(port);
    port->close = NULL;
}

#endif
