/* SPDX-License-Identifier: MIT */
#include "mcu/esp32c3_spi.h"

#include "mcu/wait.h"

#define CMD_UPDATE (UINT32_C(1) << 23)
#define CMD_USER (UINT32_C(1) << 24) /* sends; until all has left */
#define CLOCK_UNDIVIDED (UINT32_C(1) << 31)
#define USER_SENDS (UINT32_C(1) << 27)      /* that alone: neither command, address nor dummy */
#define MISC_IDLES_HIGH (UINT32_C(1) << 29) /* modes 2 and 3 */
#define USER_LATE_EDGE (UINT32_C(1) << 9)   /* modes 1 and 2 */
#define DMA_CONF_EMPTY (UINT32_C(1) << 30)  /* the queue between the registers and the wire */

enum {
    CLK_GATE_ON = 3, /* registers and master; bit 2 would take the PLL's 80 MHz instead of the crystal */
    MISC_NO_SELECTS = 0x3F,
    DIVIDER_MAX = 64,
    PREDIVIDER_MAX = 16,
    PREDIVIDER_AT = 18,
    DIVIDER_AT = 12,
    HIGH_AT = 6
};

/* 64 bytes take 512 * 1024 of the crystal's cycles at most, and a look four at least. */
#define LOOKS_MAX UINT32_C(200000)

/* High for half of a period, rounded down. 0: no such rate. */
static uint32_t clock_of(uint32_t clock_hz, uint32_t spi_hz)
{
    const uint32_t by = spi_hz ? (clock_hz - 1) / spi_hz + 1 : UINT32_MAX;

    if (by == 1) return CLOCK_UNDIVIDED;
    if (by > DIVIDER_MAX * PREDIVIDER_MAX) return 0;
    const uint32_t pre = (by - 1) / DIVIDER_MAX + 1;
    const uint32_t n = (by - 1) / pre + 1;
    return (pre - 1) << PREDIVIDER_AT | (n - 1) << DIVIDER_AT | (n / 2 - 1) << HIGH_AT | (n - 1);
}

static int update(struct esp32c3_spi_registers *registers)
{
    registers->cmd = CMD_UPDATE;
    return mcu_wait(&registers->cmd, CMD_UPDATE, 0, LOOKS_MAX);
}

int esp32c3_spi_init(struct esp32c3_spi *spi, struct esp32c3_spi_registers *registers, uint32_t clock_hz,
                     uint32_t spi_hz, uint8_t mode)
{
    const uint32_t clock = clock_of(clock_hz, spi_hz);

    *spi = (struct esp32c3_spi){.registers = registers};
    if (!clock) return MCU_ERR_CONFIG;
    registers->clk_gate = CLK_GATE_ON;
    registers->slave = 0;
    registers->dma_conf = 0;
    registers->clock = clock;
    registers->user = USER_SENDS | (mode == 1 || mode == 2 ? USER_LATE_EDGE : 0);
    registers->misc = MISC_NO_SELECTS | (mode >= 2 ? MISC_IDLES_HIGH : 0);
    return update(registers);
}

static int flush(void *ctx)
{
    const struct esp32c3_spi *spi = ctx;
    return mcu_wait(&spi->registers->cmd, CMD_USER, 0, LOOKS_MAX);
}

/* The first byte is a word's lowest. What of the last word is behind the end is not sent. */
static void pack(uint32_t *words, const uint8_t *data, size_t n_b)
{
    for (; n_b >= 4; n_b -= 4, data += 4)
        *words++ = (uint32_t)data[0] | (uint32_t)data[1] << 8 | (uint32_t)data[2] << 16 | (uint32_t)data[3] << 24;
    if (n_b) *words = 0;
    for (size_t i = 0; i < n_b; i++)
        *words |= (uint32_t)data[i] << 8 * i;
}

/* Returns when they are on their way. */
static int send(struct esp32c3_spi_registers *registers, const uint32_t *words, size_t n_b)
{
    registers->dma_conf = DMA_CONF_EMPTY;
    registers->dma_conf = 0;
    registers->ms_dlen = (uint32_t)(8 * n_b - 1);
    for (size_t i = 0; 4 * i < n_b; i++)
        registers->w[i] = words[i];
    int err = update(registers);
    if (err) return err;
    registers->cmd = CMD_USER;
    return 0;
}

/* The next ones are packed while the last ones leave. */
static int write(void *ctx, const uint8_t *data, size_t n_b)
{
    struct esp32c3_spi *spi = ctx;

    while (n_b) {
        uint32_t words[ESP32C3_SPI_B / 4];
        const size_t piece_b = n_b < ESP32C3_SPI_B ? n_b : ESP32C3_SPI_B;
        pack(words, data, piece_b);
        int err = flush(spi);
        if (err) return err;
        err = send(spi->registers, words, piece_b);
        if (err) return err;
        data += piece_b;
        n_b -= piece_b;
    }
    return 0;
}

struct bus esp32c3_spi_bus(struct esp32c3_spi *spi)
{
    return (struct bus){.ctx = spi, .write = write, .flush = flush};
}
