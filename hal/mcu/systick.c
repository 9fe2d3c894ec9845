/* SPDX-License-Identifier: MIT
 *
 * The counter runs freely through its 24 bits, and a wait adds up how far it came between two looks at it. So a wait
 * may be of any length, and begins without a write to the timer. */
#include "mcu/systick.h"

#include "mcu/mcu.h"

#define CSR_ENABLE UINT32_C(1)
#define CSR_CLKSOURCE_PROCESSOR (UINT32_C(1) << 2)
#define COUNTER_MASK UINT32_C(0xFFFFFF)

/* Looks at a counter that stands still before it counts as stopped. It moves with every cycle; emulators may run up to
 * a hundred instructions for one. */
enum { LOOKS_MAX = 4096 };

int systick_init(struct systick *systick, volatile struct systick_registers *registers, uint32_t cpu_hz)
{
    *systick = (struct systick){.registers = registers, .cycles_per_us = (cpu_hz + UINT32_C(999999)) / 1000000u};
    if (cpu_hz == 0) return MCU_ERR_CONFIG;
    registers->csr = 0;
    registers->rvr = COUNTER_MASK;
    registers->cvr = 0;
    registers->csr = CSR_CLKSOURCE_PROCESSOR | CSR_ENABLE;
    return 0;
}

static int systick_wait(const struct systick *systick, uint64_t cycles)
{
    uint32_t before = systick->registers->cvr;
    uint16_t looks = 0;

    for (uint64_t waited = 0; waited < cycles;) {
        const uint32_t now = systick->registers->cvr;
        const uint32_t passed = (before - now) & COUNTER_MASK;
        looks = passed ? 0 : (uint16_t)(looks + 1u);
        if (looks == LOOKS_MAX) return MCU_ERR_TIMEOUT;
        waited += passed;
        before = now;
    }
    return 0;
}

/* The first look may come just before the counter moves: one cycle more. */
static int systick_delay(void *ctx, uint32_t delay_us)
{
    const struct systick *systick = ctx;
    return systick_wait(systick, (uint64_t)delay_us * systick->cycles_per_us + 1u);
}

struct clock systick_clock(struct systick *systick)
{
    return (struct clock){.ctx = systick, .delay = systick_delay};
}
