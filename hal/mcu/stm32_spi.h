/* SPDX-License-Identifier: MIT
 *
 * SPI of STM32F1 and STM32F4 as a bus: master, eight bits, most significant first, transmit only, polled.
 * Registers: RM0008 (F1) 25.5, RM0090 (F4) 28.5; RM0041 (F100) has the same. */
#ifndef HAL_MCU_STM32_SPI_H
#define HAL_MCU_STM32_SPI_H

#include "bus.h"

HAL_C_BEGIN

struct stm32_spi_registers {
    volatile uint32_t cr1, cr2; /* SPI_CR1, SPI_CR2: control */
    volatile uint32_t sr;       /* SPI_SR: status */
    volatile uint32_t dr;       /* SPI_DR: data */
    volatile uint32_t crcpr, rxcrcr, txcrcr, i2scfgr, i2spr;
};

#define STM32_SPI1 ((struct stm32_spi_registers *)UINT32_C(0x40013000))

struct stm32_spi {
    struct stm32_spi_registers *registers;
};

/* Starts the peripheral, whose own clock, clock_hz, is on already, in SPI's mode 0 .. 3, at spi_hz or the next slower
 * rate: clock_hz divided by 2, 4, 8 ... 256. MCU_ERR_CONFIG: that is too fast still. */
HAL_MUST_CHECK int stm32_spi_init(struct stm32_spi *spi, struct stm32_spi_registers *registers, uint32_t clock_hz,
                                  uint32_t spi_hz, uint8_t mode);

/* *spi must outlive the bus. MCU_ERR_TIMEOUT: the peripheral does not take or send its bytes. */
struct bus stm32_spi_bus(struct stm32_spi *spi);

/* What the bus does, for those who send some of their bytes otherwise. */
HAL_MUST_CHECK int stm32_spi_write(const struct stm32_spi *spi, const uint8_t *data, size_t n_b);
HAL_MUST_CHECK int stm32_spi_flush(const struct stm32_spi *spi);

HAL_C_END

#endif
