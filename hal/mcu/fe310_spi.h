/* SPDX-License-Identifier: MIT
 *
 * SPI of SiFive's FE310 as a bus: master, eight bits, most significant first, polled, chip select left to a pin.
 * Registers: FE310-G000 Manual, chapter 19, "Serial Peripheral Interface (SPI)". Nothing tells that the last byte
 * has left but the byte that is received for it: so as many are awaited as were sent, and never more are on their way
 * than the receiver has room for. */
#ifndef HAL_MCU_FE310_SPI_H
#define HAL_MCU_FE310_SPI_H

#include "bus.h"

HAL_C_BEGIN

struct fe310_spi_registers {
    volatile uint32_t sckdiv, sckmode, reserved_08[2];
    volatile uint32_t csid, csdef, csmode, reserved_1c[3];
    volatile uint32_t delay0, delay1, reserved_30[4];
    volatile uint32_t fmt, reserved_44, txdata, rxdata;
};

#define FE310_QSPI0 ((struct fe310_spi_registers *)UINT32_C(0x10014000)) /* the flash's */
#define FE310_QSPI1 ((struct fe310_spi_registers *)UINT32_C(0x10024000))

struct fe310_spi {
    struct fe310_spi_registers *registers;
    uint8_t on_their_way; /* bytes sent for which none was received yet */
};

/* Starts in SPI's mode 0 .. 3, at spi_hz or the next slower rate: clock_hz divided by 2, 4, 6 ... 8192. MCU_ERR_CONFIG:
 * that is too fast still. */
HAL_MUST_CHECK int fe310_spi_init(struct fe310_spi *spi, struct fe310_spi_registers *registers, uint32_t clock_hz,
                                  uint32_t spi_hz, uint8_t mode);

/* *spi must outlive the bus. MCU_ERR_TIMEOUT: bytes do not leave. */
struct bus fe310_spi_bus(struct fe310_spi *spi);

HAL_C_END

#endif
