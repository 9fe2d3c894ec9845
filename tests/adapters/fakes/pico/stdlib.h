/* SPDX-License-Identifier: MIT
 *
 * A fake of the Pico SDK, for the example alone, which is compiled and not run. */
#ifndef FAKE_PICO_STDLIB_H
#define FAKE_PICO_STDLIB_H

#include "hardware/gpio.h"

bool stdio_init_all(void);
void sleep_ms(uint32_t ms);

#endif
