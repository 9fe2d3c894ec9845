/* SPDX-License-Identifier: MIT
 *
 * What a panel needs from a port: a bus that takes bytes, pins with a level, a clock that waits.
 * Three small interfaces, each a context and functions, so that one panel driver serves SPI
 * peripherals with DMA, Linux spidev, USB bridges and emulated chips.
 * Every function returns 0 or a negative code of the port's own; panels pass it on unchanged. */
#ifndef HAL_BUS_H
#define HAL_BUS_H

#include "c_linkage.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define HAL_MUST_CHECK __attribute__((warn_unused_result))
#define HAL_ALONE __attribute__((noinline)) /* a loop that wants all registers for itself */

/* Constants of some size: on AVR flash is another address space, and what is not told so lies in RAM. C++ knows none:
 * there such a pointer is only passed on. */
#if defined(__AVR__) && !defined(__cplusplus)
#define HAL_FLASH __flash
#else
#define HAL_FLASH
#endif

/* Bytes from host to panel. Chip select, clock rate, bit order and the greatest length of a
 * message are the port's own affair: it splits what is too long, and may release chip select
 * between whole bytes. */
struct bus {
    void *ctx; /* passed to both functions */
    /* Sends n_b bytes, in order. The transfer may go on after the return (DMA): the data must stay as
     * it is until the next write() or flush() has returned, with or without an error; an error that
     * comes late is that call's. */
    int (*write)(void *ctx, const uint8_t *data, size_t n_b) HAL_MUST_CHECK;
    /* Returns when the last byte has left, or will not leave. NULL: write() never returns earlier. */
    int (*flush)(void *ctx) HAL_MUST_CHECK;
    /* How many bytes of the last write() are still to be read from memory: for that long the next one would wait. NULL:
     * write() never returns earlier, or the port cannot tell. */
    size_t (*left_b)(void *ctx);
    /* How many bytes could be sent in the time that beginning a write takes, or setting D/C: 0 where a peripheral does
     * it, a report's where each of them is a report. */
    uint16_t message_b;
};

/* An output: data/command, reset, backlight. Levels are electrical. */
struct pin {
    void *ctx;
    int (*set)(void *ctx, bool high) HAL_MUST_CHECK; /* NULL: not wired */
};

struct clock {
    void *ctx;
    /* Returns after delay_us or later. */
    int (*delay)(void *ctx, uint32_t delay_us) HAL_MUST_CHECK;
};

/* An input that tells a moment by rising: tearing effect. */
struct edge {
    void *ctx;
    /* Waits for the next rise: 1 when it came, 0 when none came in timeout_us, or a negative code. NULL: not wired. */
    int (*wait)(void *ctx, uint32_t timeout_us) HAL_MUST_CHECK;
};

HAL_MUST_CHECK static inline int bus_write(const struct bus *bus, const uint8_t *data, size_t n_b)
{
    return bus->write(bus->ctx, data, n_b);
}

static inline size_t bus_left_b(const struct bus *bus)
{
    return bus->left_b ? bus->left_b(bus->ctx) : 0;
}

HAL_MUST_CHECK static inline int bus_flush(const struct bus *bus)
{
    return bus->flush ? bus->flush(bus->ctx) : 0;
}

static inline bool pin_is_wired(const struct pin *pin)
{
    return pin->set != NULL;
}

HAL_MUST_CHECK static inline int pin_set(const struct pin *pin, bool high)
{
    return pin->set(pin->ctx, high);
}

HAL_MUST_CHECK static inline int clock_delay(const struct clock *clock, uint32_t delay_us)
{
    return clock->delay(clock->ctx, delay_us);
}

static inline bool edge_is_wired(const struct edge *edge)
{
    return edge->wait != NULL;
}

HAL_MUST_CHECK static inline int edge_wait(const struct edge *edge, uint32_t timeout_us)
{
    return edge->wait(edge->ctx, timeout_us);
}

#endif
