/* SPDX-License-Identifier: MIT
 *
 * The bounded wait for bits of a register. */
#ifndef HAL_MCU_WAIT_H
#define HAL_MCU_WAIT_H

#include "bus.h"
#include "mcu/mcu.h"

/* Until the bits that mask has are `value`: MCU_ERR_TIMEOUT when they never were in so many looks. A look takes at
 * least four cycles of the processor. */
HAL_MUST_CHECK static inline int mcu_wait(const volatile uint32_t *reg, uint32_t mask, uint32_t value, uint32_t looks)
{
    for (; looks; looks--)
        if ((*reg & mask) == value) return 0;
    return MCU_ERR_TIMEOUT;
}

#endif
