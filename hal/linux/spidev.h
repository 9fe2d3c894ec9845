/* SPDX-License-Identifier: MIT
 *
 * An SPI device of the kernel's spidev: messages of bytes, each with chip select of its own. */
#ifndef HAL_LINUX_SPIDEV_H
#define HAL_LINUX_SPIDEV_H

#include "port.h"

HAL_C_BEGIN

struct spidev {
    int fd; /* -1: not open */
    const char *path;
    uint32_t speed_hz;
    uint32_t most_b; /* of a message */
    uint8_t mode;    /* 0 .. 3 */
    struct port *port;
};

/* `mode` is 0 .. 3 and flags of <linux/spi/spi.h>; `spare`, those of its bits that are left out where the controller
 * refuses them, which port->notice says. The path must outlive *spidev. 0 or a negative errno, with a line in
 * port->error. */
HAL_MUST_CHECK int spidev_open(struct spidev *spidev, const char *path, uint8_t mode, uint8_t spare, uint32_t speed_hz,
                               struct port *port);
void spidev_close(struct spidev *spidev);

/* For a struct bus, whose context is the struct spidev. Finished on return. */
HAL_MUST_CHECK int spidev_write(void *ctx, const uint8_t *data, size_t n_b);

HAL_C_END

#endif
