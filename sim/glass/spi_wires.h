/* SPDX-License-Identifier: MIT
 *
 * The wires of a display, as a logic analyser saw them: levels in, bytes and changes out, in the order of a chip that
 * takes a bit with each edge of the clock while it is selected, and D/C with the last bit of a byte. What can only come
 * of a capture that missed something is an error. */
#ifndef SIM_SPI_WIRES_H
#define SIM_SPI_WIRES_H

#include "glass/channels.h"

#include <stdint.h>

/* A bit a wire, 1 << enum capture_wire. */
struct wire_levels {
    uint8_t high, unknown;
};

/* Each returns false to stop: what follows is not looked at. */
struct wire_events {
    void *ctx;
    bool (*byte)(void *ctx, uint64_t now_ns, uint8_t byte, struct error *err);
    bool (*level)(void *ctx, uint64_t now_ns, enum capture_wire wire, bool high, struct error *err);
};

/* Private but for what is set at first. */
struct spi_wires {
    struct wire_events events;
    uint8_t wired;         /* wires that were captured; the clock, MOSI and either D/C or select are */
    bool takes_falling;    /* bits come with the falling edge: SPI modes 1 and 2 */
    bool rests_high;       /* the clock: SPI modes 2 and 3 */
    bool is_running;       /* the capture begins anywhere: what comes before the first command is left out */
    bool waits_for_reset;  /* what comes before the display's reset is */
    uint64_t sample_ns;    /* between two samples; 0: edges have times of their own */
    struct wire_levels at; /* now */
    bool has_begun, is_aligned, is_heard;
    uint8_t byte, n_bits;
    uint64_t byte_ns, pause_ns; /* when the last byte came, left out or not, and how long after the one before it */
    uint64_t bytes, clock_edges, other_edges; /* these came while the display was not selected */
    uint64_t edge_ns, shortest_ns; /* the clock's last edge; the shortest time between two since the last boundary */
};

/* The levels from now on. An error does not tell the time. */
bool spi_wires_take(struct spi_wires *wires, uint64_t now_ns, struct wire_levels levels, struct error *err);

#endif
