/* SPDX-License-Identifier: MIT
 *
 * A struct bus by the Pico SDK's hardware_spi and hardware_dma: write() returns while DMA sends. Between frames it is
 * others'. Pins and clock: limner_pico.h. */
#ifndef LIMNER_PICO_BUS_H
#define LIMNER_PICO_BUS_H
#include "board.h"
#include "hardware/dma.h"
#include "hardware/gpio.h"
#include "hardware/spi.h"

enum { LIMNER_NO_PIN = 255 };

struct limner_pico_bus {
    spi_inst_t *spi;
    uint8_t sck, tx, cs, dma; /* dma: private, a channel that is claimed at first */
    bool is_claimed;
};

static inline int limner_pico_flush(void *ctx)
{
    const struct limner_pico_bus *const wires = (const struct limner_pico_bus *)ctx;
    dma_channel_wait_for_finish_blocking(wires->dma);
    while (spi_is_busy(wires->spi))
        tight_loop_contents();
    while (spi_is_readable(wires->spi)) /* for who reads the bus next */
        (void)spi_get_hw(wires->spi)->dr;
    if (wires->cs != LIMNER_NO_PIN) gpio_put(wires->cs, true);
    return 0;
}

static inline int limner_pico_write(void *ctx, const uint8_t *data, size_t n_b)
{
    const struct limner_pico_bus *const wires = (const struct limner_pico_bus *)ctx;
    dma_channel_wait_for_finish_blocking(wires->dma);
    if (wires->cs != LIMNER_NO_PIN) gpio_put(wires->cs, false);
    dma_channel_transfer_from_buffer_now(wires->dma, data, (uint32_t)n_b);
    return 0;
}

static inline size_t limner_pico_left_b(void *ctx)
{
    return dma_channel_hw_addr(((const struct limner_pico_bus *)ctx)->dma)->transfer_count;
}

static inline struct bus limner_pico_bus(struct limner_pico_bus *wires, uint32_t spi_hz, uint8_t spi_modes)
{
    const uint8_t mode = spi_mode_of(spi_modes, 3); /* in which the PL022 makes no pauses */
    const struct bus bus = {wires, limner_pico_write, limner_pico_flush, limner_pico_left_b, 0};
    if (!wires->is_claimed) wires->dma = (uint8_t)dma_claim_unused_channel(true), wires->is_claimed = true;
    dma_channel_config config = dma_channel_get_default_config(wires->dma);
    channel_config_set_transfer_data_size(&config, DMA_SIZE_8);
    channel_config_set_dreq(&config, spi_get_dreq(wires->spi, true));
    dma_channel_configure(wires->dma, &config, &spi_get_hw(wires->spi)->dr, NULL, 0, false);
    spi_init(wires->spi, spi_hz);
    spi_set_format(wires->spi, 8, (spi_cpol_t)(mode >> 1), (spi_cpha_t)(mode & 1), SPI_MSB_FIRST);
    gpio_set_function(wires->sck, GPIO_FUNC_SPI), gpio_set_function(wires->tx, GPIO_FUNC_SPI);
    return bus;
}
#endif
