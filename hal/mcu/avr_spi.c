/* SPDX-License-Identifier: MIT */
#include "mcu/avr_spi.h"

enum { RATES = 7 }; /* halves of the processor's rate */

/* A byte takes 8 * 128 cycles at the slowest rate, and in an emulator that knows no rates 1600; a look takes five. */
enum { LOOKS_MAX = 2000 };

int avr_spi_init(struct avr_spi *spi, volatile struct avr_spi_registers *registers, uint32_t cpu_hz, uint32_t spi_hz,
                 uint8_t mode)
{
    uint8_t rate = 0;

    for (cpu_hz /= 2; cpu_hz > spi_hz && rate < RATES; cpu_hz /= 2)
        rate++;
    if (rate == RATES) return MCU_ERR_CONFIG;
    spi->registers = registers;
    /* Every other rate is the one below with its clock doubled; the slowest, 1/128, is the exception. */
    registers->spcr =
        (uint8_t)(AVR_SPCR_SPE | AVR_SPCR_MSTR | mode * AVR_SPCR_CPHA | (rate < RATES - 1 ? rate / 2 : 3));
    registers->spsr = rate % 2 || rate == RATES - 1 ? 0 : AVR_SPSR_SPI2X;
    return 0;
}

static int wait_sent(volatile struct avr_spi_registers *registers)
{
    for (uint16_t looks = LOOKS_MAX; looks; looks--)
        if (registers->spsr & AVR_SPSR_SPIF) return 0;
    return MCU_ERR_TIMEOUT;
}

static int avr_spi_write(void *ctx, const uint8_t *data, size_t n_b)
{
    volatile struct avr_spi_registers *const registers = ((struct avr_spi *)ctx)->registers;

    for (const uint8_t *const end = data + n_b; data < end;) {
        registers->spdr = *data++;
        int err = wait_sent(registers);
        if (err) return err;
    }
    return 0;
}

struct bus avr_spi_bus(struct avr_spi *spi)
{
    return (struct bus){.ctx = spi, .write = avr_spi_write};
}
