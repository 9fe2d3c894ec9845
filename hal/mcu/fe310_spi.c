/* SPDX-License-Identifier: MIT */
#include "mcu/fe310_spi.h"

#include "mcu/wait.h"

#define RXDATA_EMPTY (UINT32_C(1) << 31)

enum {
    SCKDIV_MAX = 0xFFF,
    SCKMODE_MODES = 3, /* polarity and phase, as SPI numbers its modes */
    CSMODE_OFF = 3,
    FMT_8_BITS = 8 << 16, /* one line, most significant first, what comes in is kept */
    FIFO_B = 8,
};

/* A byte takes 8 * 8192 of the processor's cycles at most, and a look four at least. */
#define LOOKS_MAX UINT32_C(65535)

int fe310_spi_init(struct fe310_spi *spi, struct fe310_spi_registers *registers, uint32_t clock_hz, uint32_t spi_hz,
                   uint8_t mode)
{
    const uint32_t sckdiv = spi_hz ? (clock_hz - 1) / 2 / spi_hz : UINT32_MAX;

    *spi = (struct fe310_spi){.registers = registers};
    if (sckdiv > SCKDIV_MAX) return MCU_ERR_CONFIG;
    registers->sckdiv = sckdiv;
    registers->sckmode = mode & SCKMODE_MODES;
    registers->csmode = CSMODE_OFF;
    registers->fmt = FMT_8_BITS;
    for (uint8_t i = 0; i < FIFO_B; i++) /* what was received before */
        (void)registers->rxdata;
    return 0;
}

/* To look is to take. */
static int receive(struct fe310_spi *spi)
{
    int err = mcu_wait(&spi->registers->rxdata, RXDATA_EMPTY, 0, LOOKS_MAX);
    if (err) return err;
    spi->on_their_way--;
    return 0;
}

static int write(void *ctx, const uint8_t *data, size_t n_b)
{
    struct fe310_spi *spi = ctx;

    for (size_t i = 0; i < n_b; i++) {
        int err = spi->on_their_way == FIFO_B ? receive(spi) : 0;
        if (err) return err;
        spi->registers->txdata = data[i];
        spi->on_their_way++;
    }
    return 0;
}

static int flush(void *ctx)
{
    struct fe310_spi *spi = ctx;

    while (spi->on_their_way) {
        int err = receive(spi);
        if (err) return err;
    }
    return 0;
}

struct bus fe310_spi_bus(struct fe310_spi *spi)
{
    return (struct bus){.ctx = spi, .write = write, .flush = flush};
}
