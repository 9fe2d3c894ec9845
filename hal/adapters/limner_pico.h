/* SPDX-License-Identifier: MIT
 *
 * A port: Limner's own panels by the Pico SDK's hardware_spi and hardware_dma: write() returns while DMA sends. What is
 * not wired is LIMNER_NO_PIN. Between frames the bus is others'.
 *
 *     static struct limner_pico port = {.spi = spi0, .sck = 18, .tx = 19, .cs = 17, .dc = 16, .reset = 22,
 *                                       .backlight = 20, .select = LIMNER_NO_PIN};
 *     limner_pico_board(&port, &board, MODULE_SPEED_HZ, MODULE_SPI_MODES); // may be called again
 *     int err = module_setup(&panel, &board);                             // of `limner module` */
#ifndef LIMNER_PICO_H
#define LIMNER_PICO_H

#include "board.h"
#include "hardware/dma.h"
#include "hardware/gpio.h"
#include "hardware/spi.h"
#include "pico/time.h"

enum { LIMNER_NO_PIN = 255 };

struct limner_pico {
    spi_inst_t *spi;
    uint8_t sck, tx, cs, dc, reset, backlight, select; /* select: a memory LCD's, whose driver sets it, instead of cs */
    uint8_t dma;                                       /* private: its channel, claimed at first */
    bool is_claimed;
};

static inline int limner_pico_set(void *ctx, bool high)
{
    gpio_put((uint)(uintptr_t)ctx, high);
    return 0;
}

static inline struct pin limner_pico_pin(uint8_t number, bool high)
{
    const struct pin none = {NULL, NULL}, pin = {(void *)(uintptr_t)number, limner_pico_set};
    if (number == LIMNER_NO_PIN) return none;
    gpio_init(number);
    gpio_put(number, high);
    gpio_set_dir(number, GPIO_OUT);
    return pin;
}

static inline int limner_pico_flush(void *ctx)
{
    const struct limner_pico *const port = (const struct limner_pico *)ctx;
    dma_channel_wait_for_finish_blocking(port->dma);
    while (spi_is_busy(port->spi))
        tight_loop_contents();
    while (spi_is_readable(port->spi)) /* for who reads the bus next */
        (void)spi_get_hw(port->spi)->dr;
    if (port->cs != LIMNER_NO_PIN) gpio_put(port->cs, true);
    return 0;
}

static inline int limner_pico_write(void *ctx, const uint8_t *data, size_t n_b)
{
    const struct limner_pico *const port = (const struct limner_pico *)ctx;
    dma_channel_wait_for_finish_blocking(port->dma);
    if (port->cs != LIMNER_NO_PIN) gpio_put(port->cs, false);
    dma_channel_transfer_from_buffer_now(port->dma, data, (uint32_t)n_b);
    return 0;
}

static inline size_t limner_pico_left_b(void *ctx)
{
    return dma_channel_hw_addr(((const struct limner_pico *)ctx)->dma)->transfer_count;
}

static inline int limner_pico_delay(void *ctx, uint32_t delay_us)
{
    (void)ctx;
    sleep_us(delay_us);
    return 0;
}

static inline void limner_pico_board(struct limner_pico *port, struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    const uint8_t mode = spi_mode_of(spi_modes, 3); /* in which the PL022 makes no pauses */
    const struct bus bus = {port, limner_pico_write, limner_pico_flush, limner_pico_left_b, 0};
    const struct clock clock = {NULL, limner_pico_delay};
    if (!port->is_claimed) port->dma = (uint8_t)dma_claim_unused_channel(true), port->is_claimed = true;
    dma_channel_config config = dma_channel_get_default_config(port->dma);
    channel_config_set_transfer_data_size(&config, DMA_SIZE_8);
    channel_config_set_dreq(&config, spi_get_dreq(port->spi, true));
    dma_channel_configure(port->dma, &config, &spi_get_hw(port->spi)->dr, NULL, 0, false);
    spi_init(port->spi, spi_hz);
    spi_set_format(port->spi, 8, (spi_cpol_t)(mode >> 1), (spi_cpha_t)(mode & 1), SPI_MSB_FIRST);
    gpio_set_function(port->sck, GPIO_FUNC_SPI), gpio_set_function(port->tx, GPIO_FUNC_SPI);
    (void)limner_pico_pin(port->cs, true);
    board->dc = limner_pico_pin(port->dc, false), board->reset = limner_pico_pin(port->reset, true);
    board->backlight = limner_pico_pin(port->backlight, false), board->select = limner_pico_pin(port->select, false);
    board->bus = bus, board->clock = clock;
}

#endif
