/* SPDX-License-Identifier: MIT
 *
 * Modes of SPI that a display takes. All displays here read data as the clock rises, which modes 0 and 3 have in
 * common; what differs is the clock's level between messages. */
#ifndef HAL_SPI_MODES_H
#define HAL_SPI_MODES_H

#include <stdint.h>

/* Sets of modes: 1 << mode each. */
enum { SPI_IDLES_LOW = 1 << 0, SPI_IDLES_HIGH = 1 << 3, SPI_IDLES_ANYHOW = SPI_IDLES_LOW | SPI_IDLES_HIGH };

/* Of a set with a mode in it: the one that a port likes best, if the display takes it, else its lowest. */
static inline uint8_t spi_mode_of(uint8_t modes, uint8_t liked)
{
    uint8_t mode = 0;

    if (modes >> liked & 1) return liked;
    while (!(modes >> mode & 1))
        mode++;
    return mode;
}

#endif
