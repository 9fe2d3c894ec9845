/* SPDX-License-Identifier: MIT
 *
 * A byte goes to the data register when the one before has gone on to the shift register (TXE). The last one has left
 * when the data register is empty and the shift register too (BSY), looked at in this order: RM0008 25.3.8. */
#include "mcu/stm32_spi.h"

#include "mcu/wait.h"

enum {
    CR1_MODES = 3 << 0, /* CPOL and CPHA, as SPI numbers its modes */
    CR1_MSTR = 1 << 2,
    CR1_BR_SHIFT = 3,
    CR1_SPE = 1 << 6,
    CR1_SSI = 1 << 8,
    CR1_SSM = 1 << 9,
    CR1_BIDIOE = 1 << 14,
    CR1_BIDIMODE = 1 << 15, /* one data line, an output: nothing is received that somebody would have to read */
    BR_MAX = 7,
    SR_TXE = 1 << 1,
    SR_BSY = 1 << 7,
};

/* A byte takes 8 * 256 of the peripheral's clocks at most, and the processor has at most eight of its own to each: in
 * so many looks two bytes have long left. */
#define LOOKS_MAX UINT32_C(65535)

int stm32_spi_init(struct stm32_spi *spi, struct stm32_spi_registers *registers, uint32_t clock_hz, uint32_t spi_hz,
                   uint8_t mode)
{
    uint32_t br = 0;

    *spi = (struct stm32_spi){.registers = registers};
    while (br < BR_MAX && (clock_hz >> (br + 1)) > spi_hz)
        br++;
    if ((clock_hz >> (br + 1)) > spi_hz) return MCU_ERR_CONFIG;
    registers->cr1 = 0;
    registers->cr2 = 0;
    registers->cr1 = CR1_BIDIMODE | CR1_BIDIOE | CR1_SSM | CR1_SSI | CR1_MSTR | br << CR1_BR_SHIFT | (mode & CR1_MODES);
    registers->cr1 |= CR1_SPE;
    return 0;
}

int stm32_spi_write(const struct stm32_spi *spi, const uint8_t *data, size_t n_b)
{
    for (size_t i = 0; i < n_b; i++) {
        int err = mcu_wait(&spi->registers->sr, SR_TXE, SR_TXE, LOOKS_MAX);
        if (err) return err;
        spi->registers->dr = data[i];
    }
    return 0;
}

int stm32_spi_flush(const struct stm32_spi *spi)
{
    int err = mcu_wait(&spi->registers->sr, SR_TXE, SR_TXE, LOOKS_MAX);
    return err ? err : mcu_wait(&spi->registers->sr, SR_BSY, 0, LOOKS_MAX);
}

static int bus_of_spi_write(void *ctx, const uint8_t *data, size_t n_b)
{
    return stm32_spi_write(ctx, data, n_b);
}

static int bus_of_spi_flush(void *ctx)
{
    return stm32_spi_flush(ctx);
}

struct bus stm32_spi_bus(struct stm32_spi *spi)
{
    return (struct bus){.ctx = spi, .write = bus_of_spi_write, .flush = bus_of_spi_flush};
}
