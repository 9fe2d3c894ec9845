/* SPDX-License-Identifier: MIT
 *
 * What the kernel knows of its SPI devices, by /sys: which controller they hang on, and who has one that spidev does
 * not have, a device tree overlay for a display mostly. */
#ifndef HAL_LINUX_SPI_DEVICES_H
#define HAL_LINUX_SPI_DEVICES_H

#include "c_linkage.h"

#include <stdbool.h>
#include <stddef.h>

HAL_C_BEGIN

enum { SPI_NAME_B = 32, SPI_TROUBLE_B = 256 };

/* A place on a bus, as in /dev/spidev0.1. */
struct spi_place {
    unsigned bus, select;
};

/* The place of a node of spidev, or of a link to one; false: its name is none's. */
bool spi_place_of(struct spi_place *out, const char *path);

/* The controller's driver, as spi-bcm2835 or dw_spi_mmio; false, and "": the kernel does not say. */
bool spi_controller_name(char out[SPI_NAME_B], const struct spi_place *place);

/* Why there is no node of spidev for a place, and what can be done: half a sentence. False: the kernel has no device
 * there. */
bool spi_place_trouble(char out[SPI_TROUBLE_B], const struct spi_place *place);

/* The same where there is none at all. */
void spi_trouble(char out[SPI_TROUBLE_B]);

/* The devices of all buses for which spidev has no node, counted from 0. false: there are no more. */
bool spi_place_without_node(struct spi_place *out, size_t index);

HAL_C_END

#endif
