/* SPDX-License-Identifier: MIT
 *
 * Bytes to a chip that tells commands from data by a pin, and the pins beside: what every family of panels needs. The
 * level of D/C is remembered, because each change costs a report on a USB bridge; after an error nobody knows it. */
#ifndef HAL_WIRE_H
#define HAL_WIRE_H

#include "bus.h"

struct wire {
    struct bus bus;
    struct pin dc;
    uint8_t level; /* of D/C, as far as known */
};

/* Forgets D/C's level, and waits for what is on its way: no byte of an abandoned frame may meet a reset. */
HAL_MUST_CHECK int wire_begin(struct wire *wire);

/* Commands leave before the return, so they may live on the stack; data as struct bus has it. */
HAL_MUST_CHECK int wire_command(struct wire *wire, const uint8_t *command, size_t n_b);
HAL_MUST_CHECK int wire_data(struct wire *wire, const uint8_t *data, size_t n_b);
HAL_MUST_CHECK int wire_flush(const struct wire *wire);

/* Pulls reset low, and waits until the chip listens again. */
HAL_MUST_CHECK int wire_reset(const struct pin *reset, const struct clock *clock, uint32_t after_us);

/* A pin that need not be wired: nothing happens then. */
HAL_MUST_CHECK int wire_set(const struct pin *pin, bool high);

#endif
