/* SPDX-License-Identifier: MIT
 *
 * A fake of the Pico SDK with the signatures of its headers (2.2.0, commit a1438dff): time. */
#ifndef FAKE_PICO_TIME_H
#define FAKE_PICO_TIME_H

#include "fake_wires.h"

typedef unsigned int uint;

static inline void sleep_us(uint64_t us)
{
    wires_pass(us);
}

static inline void tight_loop_contents(void) {}

#endif
