/* SPDX-License-Identifier: MIT
 *
 * A fake of the Pico SDK: SPI. */
#ifndef FAKE_HARDWARE_SPI_H
#define FAKE_HARDWARE_SPI_H

#include "hardware/gpio.h"

typedef struct {
    volatile uint32_t dr;
} spi_hw_t;
typedef struct spi_inst {
    spi_hw_t hw;
    uint32_t hz;
    bool was_read;
} spi_inst_t;
typedef enum { SPI_CPHA_0 = 0, SPI_CPHA_1 = 1 } spi_cpha_t;
typedef enum { SPI_CPOL_0 = 0, SPI_CPOL_1 = 1 } spi_cpol_t;
typedef enum { SPI_LSB_FIRST = 0, SPI_MSB_FIRST = 1 } spi_order_t;

extern spi_inst_t fake_spi0;
#define spi0 (&fake_spi0)

static inline uint spi_init(spi_inst_t *spi, uint baudrate)
{
    spi->hz = baudrate;
    return baudrate;
}

static inline void spi_set_format(spi_inst_t *spi, uint data_bits, spi_cpol_t cpol, spi_cpha_t cpha, spi_order_t order)
{
    if (data_bits != 8 || order != SPI_MSB_FIRST) wires_complain("Pico: another format than bytes, highest bit first");
    wires_bus(spi->hz, (int)cpol << 1 | (int)cpha);
}

static inline spi_hw_t *spi_get_hw(spi_inst_t *spi)
{
    return &spi->hw;
}

static inline uint spi_get_dreq(spi_inst_t *spi, bool is_tx)
{
    return spi == spi0 && is_tx ? 16 : 17;
}

static inline bool spi_is_busy(const spi_inst_t *spi)
{
    (void)spi;
    return wires_busy();
}

static inline bool spi_is_readable(const spi_inst_t *spi)
{
    (void)spi;
    return false;
}

#endif
