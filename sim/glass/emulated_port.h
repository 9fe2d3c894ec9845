/* SPDX-License-Identifier: MIT
 *
 * The pins of an emulated chip: what takes a port's bytes, levels and waits, and hands the chip commands and data,
 * which D/C tells apart. Time is the sum of all waits, or what somebody sets it to. */
#ifndef SIM_EMULATED_PORT_H
#define SIM_EMULATED_PORT_H

#include "port.h"

#include <stdarg.h>

/* A rectangle of a chip's memory. */
struct emulated_place {
    uint16_t x_px, y_px, w_px, h_px;
};

/* All of it may be read; the chip's functions get `chip`. */
struct emulated_port {
    void *chip;
    void (*command)(void *chip, uint8_t byte);
    void (*data)(void *chip, uint8_t byte);
    void (*reset)(void *chip, uint64_t pulse_us); /* it was low for so long (UINT64_MAX: unknown), and is high again;
                                                     of a chip that has none: NULL */
    void (*lost)(void *chip, size_t n_b);         /* bytes came while reset was low: they are lost */
    void (*select)(void *chip, bool high);        /* of a chip whose driver selects it itself; else NULL */
    bool (*edge)(void *chip, uint64_t *at_us);    /* when its next tearing-effect edge comes; false: none does */
    bool deferred;          /* what is written is read only by the next write or flush, as with DMA */
    const uint8_t *pending; /* deferred bytes */
    size_t pending_b;
    bool dc_high, reset_low, backlight_low;
    uint64_t reset_low_us; /* since when */
    uint64_t now_us;
    bool timeless;    /* nobody tells the time: no wait is too short */
    bool foreign;     /* to be set after init: what comes was not written by this project; see emulated_port_notes() */
    unsigned notices; /* of foreign streams: all, and the text of the last */
    char notice[160];
    uint64_t bus_b;  /* bytes received */
    uint64_t stores; /* by the chip, which tells each: pixels, bytes of several or lines, as its memory takes them */
    struct emulated_place stored; /* the last of them */
};

/* For the chip: whether it is too soon for what may happen from at_us on. */
bool emulated_port_is_before(const struct emulated_port *port, uint64_t at_us);

/* For the chip, about something that glass would bear: a command that is not modelled, vendors' registers, arguments
 * that the chip ignores, a supply in another order, waits that are short. From a foreign stream that is a notice, kept
 * and counted here. false: it is a complaint, which is the chip's own to keep; `args` were not touched. */
__attribute__((format(printf, 2, 0))) bool emulated_port_notes(struct emulated_port *port, const char *format,
                                                               va_list args);

/* For the chip: it stored something. */
void emulated_port_store(struct emulated_port *port, struct emulated_place place);

/* What a driver's configuration takes. */
struct bus emulated_port_bus(struct emulated_port *port);
struct pin emulated_port_dc(struct emulated_port *port);
struct pin emulated_port_reset(struct emulated_port *port);
struct pin emulated_port_backlight(struct emulated_port *port);
struct pin emulated_port_select(struct emulated_port *port);
struct edge emulated_port_tearing(struct emulated_port *port);
struct clock emulated_port_clock(struct emulated_port *port);

/* All of these together that the chip has, but for the tearing-effect output, which few modules lead out. */
struct port emulated_port_whole(struct emulated_port *port);

#endif
