/* SPDX-License-Identifier: MIT
 *
 * The SPI of AVR microcontrollers as a bus: master, polled, with waits that end. The pins, SS among them, which
 * must be an output or high, are the board's.
 * Manual: Atmel-7766, ATmega16U4/ATmega32U4, section 17, "Serial Peripheral Interface". Not tried on hardware. */
#ifndef HAL_MCU_AVR_SPI_H
#define HAL_MCU_AVR_SPI_H

#include "bus.h"
#include "mcu/mcu.h"

HAL_C_BEGIN

struct avr_spi_registers {
    uint8_t spcr; /* control */
    uint8_t spsr; /* status, and SPI2X */
    uint8_t spdr; /* writing begins a byte */
};

#define AVR_SPI_REGISTERS ((volatile struct avr_spi_registers *)0x4C) /* ATmega32U4 and most others */

enum {
    AVR_SPCR_SPE = 1 << 6,
    AVR_SPCR_MSTR = 1 << 4,
    AVR_SPCR_CPHA = 1 << 2, /* and CPOL above it, as SPI numbers its modes */
    AVR_SPSR_SPIF = 1 << 7, /* a byte has left */
    AVR_SPSR_SPI2X = 1 << 0
};

struct avr_spi {
    volatile struct avr_spi_registers *registers;
};

/* In SPI's mode 0 .. 3, at the fastest rate that is not above spi_hz: the processor's divided by 2, 4, ... 128.
 * MCU_ERR_CONFIG: all are. */
HAL_MUST_CHECK int avr_spi_init(struct avr_spi *spi, volatile struct avr_spi_registers *registers, uint32_t cpu_hz,
                                uint32_t spi_hz, uint8_t mode);

/* Its bytes have left when a write returns. MCU_ERR_TIMEOUT: one does not leave. *spi must outlive the bus. */
struct bus avr_spi_bus(struct avr_spi *spi);

HAL_C_END

#endif
