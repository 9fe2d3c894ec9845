/* SPDX-License-Identifier: MIT
 *
 * Clocks of the STM32F405: 168 MHz from a crystal of 4 to 26 whole MHz, or the internal 16 MHz where it does not start.
 * Registers: RM0090 7.3 (RCC) and 3.9 (FLASH_ACR). */
#ifndef HAL_MCU_STM32F4_RCC_H
#define HAL_MCU_STM32F4_RCC_H

#include "c_linkage.h"

#include <stdint.h>

HAL_C_BEGIN

struct stm32f4_rcc {
    volatile uint32_t cr, pllcfgr, cfgr, cir;
    volatile uint32_t ahb1rstr, ahb2rstr, ahb3rstr, reserved_1c;
    volatile uint32_t apb1rstr, apb2rstr, reserved_28, reserved_2c;
    volatile uint32_t ahb1enr, ahb2enr, ahb3enr, reserved_3c;
    volatile uint32_t apb1enr, apb2enr;
};

#define STM32F4_RCC ((struct stm32f4_rcc *)UINT32_C(0x40023800))
#define STM32F4_FLASH_ACR ((volatile uint32_t *)UINT32_C(0x40023C00))

/* Bits of RCC_AHB1ENR and RCC_APB2ENR, and of the registers that reset. */
enum stm32f4_ahb1 { STM32F4_GPIOA_ON = 1 << 0, STM32F4_GPIOC_ON = 1 << 2, STM32F4_DMA2_ON = 1 << 22 };
enum stm32f4_apb2 { STM32F4_SPI1_ON = 1 << 12 };

/* What became of it. */
struct stm32f4_clocks {
    uint32_t cpu_hz, apb1_hz, apb2_hz;
};

struct stm32f4_clocks stm32f4_rcc_init(struct stm32f4_rcc *rcc, volatile uint32_t *flash_acr, uint32_t hse_hz);

/* Gives peripherals their clock: bits of both registers, added to those that are on. */
void stm32f4_rcc_enable(struct stm32f4_rcc *rcc, uint32_t ahb1, uint32_t apb2);

/* Has peripherals, which have their clock, forget all that a boot loader or an earlier start left, whatever they were
 * about. First those of AHB1: a DMA stream is off before what it feeds. */
void stm32f4_rcc_reset(struct stm32f4_rcc *rcc, uint32_t ahb1, uint32_t apb2);

HAL_C_END

#endif
