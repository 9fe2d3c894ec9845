/* SPDX-License-Identifier: MIT
 *
 * Bytes to a chip that tells commands from data by a pin, and the pins beside: what most families of panels need. The
 * level of D/C is remembered, because each change costs a report on a USB bridge; after an error nobody knows it. So is
 * how much the window in the chip's memory still takes: any command closes it, and so does an error, as nobody knows
 * then how many pixels the chip took. */
#ifndef HAL_WIRE_H
#define HAL_WIRE_H

#include "pixels.h"

HAL_C_BEGIN

struct wire {
    struct bus bus;
    struct pin dc;
    bool args_low;    /* the chip takes a command's arguments with D/C low, as it does the command */
    uint8_t level;    /* of D/C, as far as known */
    bool cut;         /* a command failed, whose arguments the chip may still expect */
    uint32_t left_px; /* pixels that the open window still takes; 0: none is open */
};

/* Forgets D/C's level, closes the window, and waits for what is on its way: no byte of an abandoned frame may meet a
 * reset. Without one the chip may be in the middle of a command that nobody knows of: the last program's. */
HAL_MUST_CHECK int wire_begin(struct wire *wire);

/* Commands leave before the return, so they may live on the stack; data as struct bus has it. */
HAL_MUST_CHECK int wire_command(struct wire *wire, const uint8_t *command, size_t n_b);
HAL_MUST_CHECK int wire_data(struct wire *wire, const uint8_t *data, size_t n_b);
HAL_MUST_CHECK int wire_flush(struct wire *wire);

/* A command and its arguments; or a list of them: command, number of arguments, arguments, repeated. */
HAL_MUST_CHECK int wire_send(struct wire *wire, uint8_t command, const uint8_t *args, size_t n_args);
HAL_MUST_CHECK int wire_send_list(struct wire *wire, const uint8_t *list, size_t list_b);

/* After the commands that open a window of n_px pixels; then the pixels. PANEL_ERR_WINDOW: more than it has left. */
void wire_open(struct wire *wire, uint32_t n_px);
HAL_MUST_CHECK int wire_pixels(struct wire *wire, enum panel_format format, const void *data, size_t n_px);

/* Pulls reset low, and waits until the chip listens again. */
HAL_MUST_CHECK int wire_reset(const struct pin *reset, const struct clock *clock, uint32_t after_us);

/* A pin that need not be wired: nothing happens then. */
HAL_MUST_CHECK int wire_set(const struct pin *pin, bool high);

HAL_C_END

#endif
