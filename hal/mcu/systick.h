/* SPDX-License-Identifier: MIT
 *
 * The clock of every Cortex-M: SysTick counts down at the processor's rate, is polled, and interrupts nobody.
 * Registers and behaviour: Armv6-M Architecture Reference Manual, B3.3, "The system timer, SysTick"; Armv7-M has the
 * same.
 *
 *     static struct systick systick;
 *     int err = systick_init(&systick, SYSTICK_REGISTERS, CPU_HZ);
 *     board->clock = systick_clock(&systick); */
#ifndef HAL_MCU_SYSTICK_H
#define HAL_MCU_SYSTICK_H

#include "bus.h"

HAL_C_BEGIN

struct systick_registers {
    uint32_t csr;   /* SYST_CSR: control and status */
    uint32_t rvr;   /* SYST_RVR: what it counts down from, 24 bits */
    uint32_t cvr;   /* SYST_CVR: where it is; any write clears it */
    uint32_t calib; /* SYST_CALIB */
};

#define SYSTICK_REGISTERS ((volatile struct systick_registers *)UINT32_C(0xE000E010))

struct systick {
    volatile struct systick_registers *registers;
    uint32_t cycles_per_us; /* rounded up: a wait may be longer, never shorter */
};

/* Starts the counter. cpu_hz is the processor's rate from now on: after a change of it, call this again.
 * MCU_ERR_CONFIG: a rate of 0. */
HAL_MUST_CHECK int systick_init(struct systick *systick, volatile struct systick_registers *registers, uint32_t cpu_hz);

/* *systick must outlive the clock. Its waits end with MCU_ERR_TIMEOUT where the counter stands still. */
struct clock systick_clock(struct systick *systick);

HAL_C_END

#endif
