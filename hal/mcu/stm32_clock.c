/* SPDX-License-Identifier: MIT */
#include "mcu/stm32_clock.h"

#include "mcu/wait.h"

enum { CFGR_SW = 3, CFGR_SWS = 3 << 2, CFGR_SWS_SHIFT = 2 };

/* 25 ms and more at 16 MHz; crystals take 2, PLLs 0.3. */
#define LOOKS_MAX UINT32_C(100000)

bool stm32_clock_start(volatile uint32_t *cr, enum stm32_clock_on on)
{
    const uint32_t ready = (uint32_t)on << 1;

    *cr |= (uint32_t)on;
    return !mcu_wait(cr, ready, ready, LOOKS_MAX);
}

bool stm32_clock_select(volatile uint32_t *cfgr, enum stm32_clock_source source)
{
    *cfgr = (*cfgr & ~(uint32_t)CFGR_SW) | (uint32_t)source;
    return !mcu_wait(cfgr, CFGR_SWS, (uint32_t)source << CFGR_SWS_SHIFT, LOOKS_MAX);
}

/* What was stopped is called ready for some cycles more: who started it again would believe that. */
static void stop(volatile uint32_t *cr, enum stm32_clock_on on)
{
    *cr &= ~(uint32_t)on;
    (void)!mcu_wait(cr, (uint32_t)on << 1, 0, LOOKS_MAX);
}

/* The selected clock cannot be stopped, nor be one that is not ready: the order matters. */
void stm32_clock_reset(volatile uint32_t *cr, volatile uint32_t *cfgr)
{
    stm32_clock_start(cr, STM32_HSI_ON);
    stm32_clock_select(cfgr, STM32_BY_HSI);
    stop(cr, STM32_PLL_ON);
    stop(cr, STM32_HSE_ON);
}
