/* SPDX-License-Identifier: MIT
 *
 * The clock of RISC-V cores in machine mode: mtime, which counts at a rate of its own whatever the processor's is.
 * The RISC-V Instruction Set Manual, volume II, "Machine Timer Registers". */
#ifndef HAL_MCU_MTIME_H
#define HAL_MCU_MTIME_H

#include "bus.h"

HAL_C_BEGIN

#define FE310_MTIME ((const volatile uint32_t *)UINT32_C(0x0200BFF8)) /* FE310-G000 Manual, chapter 9, CLINT */

struct mtime {
    const volatile uint32_t *low; /* the lower half of the counter */
    uint32_t rate_hz;
};

/* *mtime must outlive the clock, whose waits are up to two counts longer than asked for. They end with MCU_ERR_TIMEOUT
 * where the counter stands still. */
struct clock mtime_clock(struct mtime *mtime);

HAL_C_END

#endif
