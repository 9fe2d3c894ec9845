/* SPDX-License-Identifier: MIT
 *
 * SPI2 of an ESP32-C3 as a bus: master, most significant bit first, from its own 64 bytes, chip select left to a pin.
 * Its clock is the crystal's. Registers: ESP32-C3 Technical Reference Manual, "SPI Controller"; offsets and bits as in
 * espressif/esp-idf components/soc/esp32c3/register/soc/spi_reg.h, the order of writes as in
 * components/esp_hal_gpspi/esp32c3/include/hal/spi_ll.h. What is written counts from an update on; so no register
 * changes while bytes leave. */
#ifndef HAL_MCU_ESP32C3_SPI_H
#define HAL_MCU_ESP32C3_SPI_H

#include "bus.h"

HAL_C_BEGIN

enum { ESP32C3_SPI_B = 64 };

struct esp32c3_spi_registers {
    volatile uint32_t cmd, addr, ctrl, clock, user, user1, user2, ms_dlen, misc, reserved_24[3], dma_conf,
        reserved_34[25];
    volatile uint32_t w[ESP32C3_SPI_B / 4], reserved_d8[2], slave, slave1, clk_gate;
};

#define ESP32C3_SPI2_REGISTERS ((struct esp32c3_spi_registers *)UINT32_C(0x60024000))

struct esp32c3_spi {
    struct esp32c3_spi_registers *registers;
};

/* As after a reset, and with its clock on, before. Starts in SPI's mode 0 .. 3, at spi_hz or the next slower rate:
 * clock_hz divided by 1, 2, 3 ... 64, or by products of one of these and 2 ... 16. MCU_ERR_CONFIG: that is too fast
 * still. MCU_ERR_TIMEOUT: it does not take what was written. */
HAL_MUST_CHECK int esp32c3_spi_init(struct esp32c3_spi *spi, struct esp32c3_spi_registers *registers, uint32_t clock_hz,
                                    uint32_t spi_hz, uint8_t mode);

/* *spi must outlive the bus; what write() takes may be changed when it returns. MCU_ERR_TIMEOUT: bytes do not leave. */
struct bus esp32c3_spi_bus(struct esp32c3_spi *spi);

HAL_C_END

#endif
