/* SPDX-License-Identifier: MIT */
#include "mcu/mtime.h"

#include "mcu/mcu.h"

/* Looks at a counter that stands still before it counts as stopped. A count of the slowest, 32768 Hz, is 10000 cycles
 * of the fastest processor, 320 MHz. */
#define LOOKS_MAX UINT32_C(65535)

static int wait(const struct mtime *mtime, uint64_t counts)
{
    uint32_t before = *mtime->low, looks = 0;

    for (uint64_t waited = 0; waited < counts;) {
        const uint32_t now = *mtime->low;
        looks = now == before ? looks + 1 : 0;
        if (looks == LOOKS_MAX) return MCU_ERR_TIMEOUT;
        waited += now - before;
        before = now;
    }
    return 0;
}

/* Rounded up; and the first count may come at once. */
static int delay(void *ctx, uint32_t delay_us)
{
    const struct mtime *mtime = ctx;
    return wait(mtime, ((uint64_t)delay_us * mtime->rate_hz + 999999u) / 1000000u + 1);
}

struct clock mtime_clock(struct mtime *mtime)
{
    return (struct clock){.ctx = mtime, .delay = delay};
}
