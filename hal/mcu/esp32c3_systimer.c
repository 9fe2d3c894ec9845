/* SPDX-License-Identifier: MIT */
#include "mcu/esp32c3_systimer.h"

#include "mcu/wait.h"

#define CONF_COUNTS (UINT32_C(1) << 30)
#define CONF_CLOCK (UINT32_C(1) << 31)
#define OP_VALID (UINT32_C(1) << 29)
#define OP_UPDATE (UINT32_C(1) << 30)

enum { COUNTS_A_US = 16 };

/* A count, or a value after it was asked for, takes a few cycles of the processor. */
#define LOOKS_MAX UINT32_C(1000)

/* The counter is read through a copy, which is made when it is asked for. */
static int now(struct esp32c3_systimer *timer, uint32_t *counts)
{
    timer->unit0_op = OP_UPDATE;
    int err = mcu_wait(&timer->unit0_op, OP_VALID, OP_VALID, LOOKS_MAX);
    *counts = timer->unit0_value_lo;
    return err;
}

static int wait(struct esp32c3_systimer *timer, uint64_t counts)
{
    uint32_t before, looks = 0;
    int err = now(timer, &before);

    for (uint64_t waited = 0; !err && waited < counts;) {
        uint32_t after;
        err = now(timer, &after);
        looks = after == before ? looks + 1 : 0;
        if (looks == LOOKS_MAX) return MCU_ERR_TIMEOUT;
        waited += after - before;
        before = after;
    }
    return err;
}

/* The first count may come at once. */
static int delay(void *ctx, uint32_t delay_us)
{
    return wait(ctx, (uint64_t)delay_us * COUNTS_A_US + 1);
}

struct clock esp32c3_systimer_clock(struct esp32c3_systimer *timer)
{
    timer->conf = CONF_CLOCK | CONF_COUNTS;
    return (struct clock){.ctx = timer, .delay = delay};
}
