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

typedef uint64_t absolute_time_t;

static inline absolute_time_t get_absolute_time(void)
{
    return wires_now_us();
}

static inline uint32_t to_ms_since_boot(absolute_time_t time)
{
    return (uint32_t)(time / 1000);
}

static inline void tight_loop_contents(void) {}

#endif
