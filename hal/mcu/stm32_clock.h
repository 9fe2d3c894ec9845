/* SPDX-License-Identifier: MIT
 *
 * What the clock controllers of STM32F1 and STM32F4 share: oscillators and PLL are started by a bit of RCC_CR and
 * answer in the next one; RCC_CFGR chooses among them. RM0008 7.3.1 and 7.3.2, RM0090 7.3.1 and 7.3.3.
 * All waits end: a crystal that does not start is told, and the processor goes on with what it has. */
#ifndef HAL_MCU_STM32_CLOCK_H
#define HAL_MCU_STM32_CLOCK_H

#include "c_linkage.h"

#include <stdbool.h>
#include <stdint.h>

HAL_C_BEGIN

/* Bits of RCC_CR that start something; the bit above is set when it is ready. */
enum stm32_clock_on { STM32_HSI_ON = 1 << 0, STM32_HSE_ON = 1 << 16, STM32_PLL_ON = 1 << 24 };

/* SW of RCC_CFGR: what the processor runs by. */
enum stm32_clock_source { STM32_BY_HSI = 0, STM32_BY_PLL = 2 };

/* false: it did not become ready. */
bool stm32_clock_start(volatile uint32_t *cr, enum stm32_clock_on on);

/* false: the processor still runs by something else. */
bool stm32_clock_select(volatile uint32_t *cfgr, enum stm32_clock_source source);

/* From wherever a boot loader or an earlier start left it: on the internal oscillator, PLL and crystal off. */
void stm32_clock_reset(volatile uint32_t *cr, volatile uint32_t *cfgr);

HAL_C_END

#endif
