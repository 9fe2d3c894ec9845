/* SPDX-License-Identifier: MIT
 *
 * Clocks and resets of Stellaris LM3S parts of the Fury class: 50 MHz from a crystal of 8 MHz.
 * Manual: LM3S6965 data sheet, chapter 5 (System Control), 5.3 (Initialization and Configuration), 5.5 (Register
 * Descriptions). Not tried on hardware. */
#ifndef HAL_MCU_LM3S_CLOCKS_H
#define HAL_MCU_LM3S_CLOCKS_H

#include "bus.h"

HAL_C_BEGIN

struct lm3s_system_registers {
    uint32_t did0, did1, dc0;
    uint32_t reserved0;
    uint32_t dc1, dc2, dc3, dc4;
    uint32_t reserved1[4];
    uint32_t pborctl, ldopctl;
    uint32_t reserved2[2];
    uint32_t srcr[3]; /* 0x040: a bit set holds a peripheral in reset */
    uint32_t reserved3;
    uint32_t ris, imc, misc, resc; /* 0x050 */
    uint32_t rcc, pllcfg;          /* 0x060 */
    uint32_t reserved4[2];
    uint32_t rcc2; /* 0x070 */
    uint32_t reserved5[35];
    uint32_t rcgc[3]; /* 0x100: a bit set clocks a peripheral */
};

#define LM3S_SYSTEM_REGISTERS ((volatile struct lm3s_system_registers *)UINT32_C(0x400FE000))

/* Bits of RCGC1 and SRCR1, RCGC2 and SRCR2. */
#define LM3S_1_SSI0 (UINT32_C(1) << 4)
#define LM3S_2_GPIO_A (UINT32_C(1) << 0)
#define LM3S_2_GPIO_C (UINT32_C(1) << 2)
#define LM3S_2_GPIO_E (UINT32_C(1) << 4)
#define LM3S_2_GPIO_F (UINT32_C(1) << 5)

#define LM3S_SYSTEM_HZ UINT32_C(50000000)

/* Runs the processor and its peripherals at LM3S_SYSTEM_HZ, whatever they ran at before; on revision A2 of the silicon,
 * which DID0 tells, with the core at 2.75 V. MCU_ERR_TIMEOUT: the PLL does not lock, for want of its crystal; all runs
 * on from the oscillator that there is. */
HAL_MUST_CHECK int lm3s_clocks_init(volatile struct lm3s_system_registers *system);

/* Clocks the peripherals whose bits are set, of the group 0, 1 or 2, and puts them where they were after power-on. */
void lm3s_peripherals_start(volatile struct lm3s_system_registers *system, uint8_t group, uint32_t mask);

HAL_C_END

#endif
