/* SPDX-License-Identifier: MIT
 *
 * Clocks of STM32F103 and F100: a multiple of a crystal of 8 MHz, or the internal 8 MHz where it does not start.
 * Registers: RM0008 7.3 (RCC) and 3.3.3 (FLASH_ACR, PM0075); RM0041 6.3 (F100). */
#ifndef HAL_MCU_STM32F1_RCC_H
#define HAL_MCU_STM32F1_RCC_H

#include "c_linkage.h"

#include <stdint.h>

HAL_C_BEGIN

struct stm32f1_rcc {
    volatile uint32_t cr, cfgr, cir, apb2rstr, apb1rstr, ahbenr, apb2enr, apb1enr;
};

#define STM32F1_RCC ((struct stm32f1_rcc *)UINT32_C(0x40021000))
#define STM32F1_FLASH_ACR ((volatile uint32_t *)UINT32_C(0x40022000))

/* Bits of RCC_APB2ENR and RCC_APB2RSTR. */
enum stm32f1_apb2 {
    STM32F1_GPIOA_ON = 1 << 2,
    STM32F1_GPIOB_ON = 1 << 3,
    STM32F1_GPIOC_ON = 1 << 4,
    STM32F1_SPI1_ON = 1 << 12
};

/* cpu_hz: 16, 24 ... 72 MHz, on an F100 up to 24. Returns the rate that became of it, which is that of APB2 as well. */
uint32_t stm32f1_rcc_init(struct stm32f1_rcc *rcc, volatile uint32_t *flash_acr, uint32_t cpu_hz);

/* Gives peripherals their clock, beside those that have it. */
void stm32f1_rcc_enable(struct stm32f1_rcc *rcc, uint32_t apb2);

/* Has peripherals, which have their clock, forget all that a boot loader or an earlier start left, whatever they were
 * about. */
void stm32f1_rcc_reset(struct stm32f1_rcc *rcc, uint32_t apb2);

HAL_C_END

#endif
