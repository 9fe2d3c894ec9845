/* SPDX-License-Identifier: MIT */
#include "mcu/avr_timer.h"

#include "mcu/mcu.h"

enum { TCCRB_AN_EIGHTH = 2, LOOKS_MAX = 256 };
#define TICKS_A_SECOND_MAX UINT32_C(255000000)

int avr_timer_init(struct avr_timer *timer, volatile struct avr_timer_registers *registers, uint32_t cpu_hz)
{
    const uint32_t tick_hz = cpu_hz / 8;

    if (tick_hz == 0 || tick_hz > TICKS_A_SECOND_MAX) return MCU_ERR_CONFIG;
    *timer = (struct avr_timer){.registers = registers,
                                .ticks_per_us = (uint8_t)((tick_hz + UINT32_C(999999)) / UINT32_C(1000000))};
    registers->tccra = 0;
    registers->tccrb = TCCRB_AN_EIGHTH;
    return 0;
}

/* The first look may come just before the counter moves: one tick more. */
static int delay(void *ctx, uint32_t delay_us)
{
    const struct avr_timer *timer = ctx;
    uint32_t left = delay_us * timer->ticks_per_us + 1;
    uint16_t before = timer->registers->tcnt;

    for (uint16_t looks = LOOKS_MAX; looks; looks--) {
        const uint16_t now = timer->registers->tcnt, passed = (uint16_t)(now - before);
        if (passed >= left) return 0;
        left -= passed;
        before = now;
        if (passed) looks = LOOKS_MAX;
    }
    return MCU_ERR_TIMEOUT;
}

struct clock avr_timer_clock(struct avr_timer *timer)
{
    return (struct clock){.ctx = timer, .delay = delay};
}
