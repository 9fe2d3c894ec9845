/* SPDX-License-Identifier: MIT
 *
 * A fake of the Pico SDK, for examples. */
#ifndef FAKE_PICO_STDLIB_H
#define FAKE_PICO_STDLIB_H

#include "hardware/gpio.h"

#include "pico/time.h"

#include <stdio.h>
#include <stdlib.h>

bool stdio_init_all(void);
void sleep_ms(uint32_t ms);

/* Stops the program. */
#define panic(...) (fprintf(stderr, __VA_ARGS__), exit(2))

#endif
