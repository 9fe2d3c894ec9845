/* SPDX-License-Identifier: MIT
 *
 * A display on a Linux machine's own pins: SPI by spidev, GPIO lines by libgpiod.
 *
 *     struct port port;
 *     int err = linux_port_open(&port, &(struct linux_port_config){.spi = "/dev/spidev0.0", .dc = "GPIO25",
 *                                                                  .reset = "GPIO24", .speed_hz = 40000000});
 *     if (err) puts(port.error);
 *     ...
 *     port_close(&port); */
#ifndef HAL_LINUX_PORT_H
#define HAL_LINUX_PORT_H

#include "port.h"

HAL_C_BEGIN

/* Lines are named as in gpio_names.h; NULL: not wired. */
struct linux_port_config {
    const char *spi;       /* required: a device node of spidev */
    const char *dc;        /* low at first */
    const char *reset;     /* high at first: not in reset */
    const char *backlight; /* low at first: dark until the panel is lit */
    const char *select;    /* low at first; a chip select beside the bus's own */
    const char *led;       /* low at first; a lamp beside the display */
    const char *tearing;   /* an input; its last rises are remembered until a wait begins */
    uint32_t speed_hz;     /* required, above 0: what the panel takes at most; the controller may be slower */
    uint8_t mode;          /* 0 .. 3: clock polarity and phase */
    bool any_mode;         /* a controller that cannot do that mode may take mode 0, which port->notice says then */
    bool no_cs, cs_high;   /* the bus's chip select stays off, unless the controller cannot: port->notice; is active
                              high */
};

/* Opens all of it, or nothing. 0 or a negative errno, with a line in port->error. *port must not move until
 * port_close(); the configuration's strings must live as long. */
HAL_MUST_CHECK int linux_port_open(struct port *port, const struct linux_port_config *config);

HAL_C_END

#endif
