/* SPDX-License-Identifier: MIT
 *
 * A port: Limner's own panels by the Pico SDK. What is not wired is LIMNER_NO_PIN.
 *
 *     static struct limner_pico port = {.bus = {.spi = spi0, .sck = 18, .tx = 19, .cs = 17},
 *                                       .dc = 16, .reset = 22, .backlight = 20, .select = LIMNER_NO_PIN};
 *     limner_pico_board(&port, &board, MODULE_SPEED_HZ, MODULE_SPI_MODES); // may be called again
 *     int err = module_setup(&panel, &board);                             // of `limner module` */
#ifndef LIMNER_PICO_H
#define LIMNER_PICO_H

#include "limner_pico_bus.h"
#include "pico/time.h"

struct limner_pico {
    struct limner_pico_bus bus;
    uint8_t dc, reset, backlight, select; /* select: a memory LCD's, whose driver sets it, instead of cs */
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

static inline int limner_pico_delay(void *ctx, uint32_t delay_us)
{
    (void)ctx;
    sleep_us(delay_us);
    return 0;
}

static inline void limner_pico_board(struct limner_pico *port, struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    const struct clock clock = {NULL, limner_pico_delay};
    board->bus = limner_pico_bus(&port->bus, spi_hz, spi_modes), board->clock = clock;
    (void)limner_pico_pin(port->bus.cs, true);
    board->dc = limner_pico_pin(port->dc, false), board->reset = limner_pico_pin(port->reset, true);
    board->backlight = limner_pico_pin(port->backlight, false), board->select = limner_pico_pin(port->select, false);
}
#endif
