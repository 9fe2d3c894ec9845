/* SPDX-License-Identifier: MIT
 *
 * A fake of the Pico SDK, for examples. */
#ifndef FAKE_PICO_STDLIB_H
#define FAKE_PICO_STDLIB_H

#include "hardware/gpio.h"

#include "pico/time.h"

bool stdio_init_all(void);
void sleep_ms(uint32_t ms);
void panic(const char *format, ...) __attribute__((noreturn, format(printf, 1, 2)));

#endif
