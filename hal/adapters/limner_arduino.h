/* SPDX-License-Identifier: MIT
 *
 * A port: Limner's own panels by Arduino's SPI library (another bus than SPI: LIMNER_SPI). Between writes it is
 * others'.
 *
 *     static struct limner_arduino port = {10, 9, 8, LIMNER_NO_PIN, LIMNER_NO_PIN}; // cs, dc, reset, backlight, select
 *     limner_arduino_board(&port, &board, MODULE_SPEED_HZ, MODULE_SPI_MODES);       // may be called again
 *     int err = module_setup(&panel, &board);                                      // of `limner module` */
#ifndef LIMNER_ARDUINO_H
#define LIMNER_ARDUINO_H

#include "board.h"

#include <SPI.h>

#ifndef LIMNER_SPI
#define LIMNER_SPI SPI
#endif

enum { LIMNER_NO_PIN = 255 };

struct limner_arduino {
    uint8_t cs, dc, reset, backlight, select; /* select: a memory LCD's, whose driver sets it, instead of cs */
    SPISettings settings;                     /* private */
};

static inline int limner_arduino_set(void *ctx, bool high)
{
    digitalWrite((uint8_t)(uintptr_t)ctx, high ? HIGH : LOW);
    return 0;
}

/* Another level is not seen, but that AVR pulls a high one up before it drives it. */
static inline struct pin limner_arduino_pin(uint8_t number, bool high)
{
    if (number == LIMNER_NO_PIN) return {NULL, NULL};
    digitalWrite(number, high ? HIGH : LOW);
    pinMode(number, OUTPUT);
    digitalWrite(number, high ? HIGH : LOW); /* not every core has kept the first */
    return {(void *)(uintptr_t)number, limner_arduino_set};
}

/* By pieces on the stack, as SPI.transfer() writes what it reads over what it has sent. */
static inline int limner_arduino_write(void *ctx, const uint8_t *data, size_t n_b)
{
    const struct limner_arduino *const port = (const struct limner_arduino *)ctx;
    uint8_t piece[sizeof(void *) > 2 ? 64 : 16];
    LIMNER_SPI.beginTransaction(port->settings);
    if (port->cs != LIMNER_NO_PIN) digitalWrite(port->cs, LOW);
    for (size_t piece_b; n_b; data += piece_b, n_b -= piece_b) {
        piece_b = n_b < sizeof piece ? n_b : sizeof piece;
        memcpy(piece, data, piece_b);
        LIMNER_SPI.transfer(piece, piece_b);
    }
    if (port->cs != LIMNER_NO_PIN) digitalWrite(port->cs, HIGH);
    LIMNER_SPI.endTransaction();
    return 0;
}

/* AVR's delayMicroseconds() counts to 16383; delay() may leave out a part of its first millisecond. */
static inline int limner_arduino_delay(void *, uint32_t delay_us)
{
    delay_us > 10000 ? delay(delay_us / 1000 + 2) : delayMicroseconds(delay_us);
    return 0;
}

/* Lights the board's LED, if it has one. */
static inline void limner_arduino_led(bool lit)
{
#ifdef LED_BUILTIN
    pinMode(LED_BUILTIN, OUTPUT);
    digitalWrite(LED_BUILTIN, lit ? HIGH : LOW);
#endif
    (void)lit;
}

static inline void limner_arduino_board(struct limner_arduino *port, struct board *board, uint32_t spi_hz,
                                        uint8_t spi_modes)
{
    const decltype(SPI_MODE0) modes[] = {SPI_MODE0, SPI_MODE1, SPI_MODE2, SPI_MODE3}; /* AVR's are no 0 to 3 */
    LIMNER_SPI.begin();
    port->settings = SPISettings(spi_hz, MSBFIRST, modes[spi_mode_of(spi_modes, 0)]);
    (void)limner_arduino_pin(port->cs, true);
    board->bus = {port, limner_arduino_write, NULL, NULL, 8}; /* 8: as long as two pins and a transaction take AVR */
    board->dc = limner_arduino_pin(port->dc, false);
    board->reset = limner_arduino_pin(port->reset, true);
    board->backlight = limner_arduino_pin(port->backlight, false);
    board->select = limner_arduino_pin(port->select, false);
    board->clock = {NULL, limner_arduino_delay};
}

#endif
