/* SPDX-License-Identifier: MIT
 *
 * The wire log: text that says what went over a display's wires, a line an event, in order.
 *
 *     b XX XX ...    bytes that left the SPI, hexadecimal
 *     p NAME 0|1     the level of a wire: dc, reset, select, backlight, cs or led
 *     t NANOSECONDS  since power on, of what follows; optional, but who tells it is held to the chip's waits
 *     # ...          nothing; neither do empty lines */
#ifndef SIM_WIRE_LOG_H
#define SIM_WIRE_LOG_H

#include "glass/listener.h"

/* One line without its newline. An error says what is wrong with it. */
bool wire_log_take(struct listener *listener, const char *line, struct error *err);

#endif
