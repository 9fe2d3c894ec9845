/* SPDX-License-Identifier: MIT */
#include "mcu/lm3s_clocks.h"

#include "mcu/wait.h"

/* Fields of RCC. */
#define RCC_SYSDIV(divisor) ((uint32_t)((divisor)-1) << 23) /* of half of the PLL's 400 MHz */
#define RCC_USESYSDIV (UINT32_C(1) << 22)
#define RCC_PWRDN (UINT32_C(1) << 13)
#define RCC_BYPASS (UINT32_C(1) << 11)
#define RCC_XTAL_8_MHZ (UINT32_C(0xE) << 6)
#define RCC_OSCSRC_MAIN (UINT32_C(0) << 4)
#define RCC_OSCSRC_INTERNAL (UINT32_C(1) << 4)
#define RCC_IOSCDIS (UINT32_C(1) << 1)

/* DID0: format 1, class 1 (Fury), and which revision of the silicon. */
#define DID0_WHICH UINT32_C(0x70FFFFFF)
#define DID0_FURY_A2 UINT32_C(0x10010002)
#define LDO_2_75_V UINT32_C(0x1B)

#define PLL_LOCKED (UINT32_C(1) << 6) /* in RIS, and cleared in MISC */

/* The PLL says that it has locked after 4608 periods of the crystal's 8 MHz, which needs 10 ms at most to start. Until
 * then the processor runs from the internal oscillator, 12 MHz and a third: a look takes four cycles or more. */
enum { LOOKS_PER_US = 16 / 4, PLL_LOOKS = (10000 + 4608 / 8) * LOOKS_PER_US };

/* Revision A2's PLL works reliably from 2.75 V on alone, where 2.5 is the default: an erratum for which the maker's own
 * programs (StellarisWare, REVISION_IS_A2) do the same. What the PLL takes to lock is more than the voltage takes. */
static void raise_core_voltage(volatile struct lm3s_system_registers *system)
{
    if ((system->did0 & DID0_WHICH) == DID0_FURY_A2) system->ldopctl = LDO_2_75_V;
}

/* In the order of 5.3, with the PLL off before, so that it locks anew. */
int lm3s_clocks_init(volatile struct lm3s_system_registers *system)
{
    const uint32_t off = RCC_PWRDN | RCC_BYPASS | RCC_XTAL_8_MHZ;
    const uint32_t slow = RCC_BYPASS | RCC_XTAL_8_MHZ | RCC_SYSDIV(4) | RCC_USESYSDIV;

    system->rcc2 = 0; /* RCC alone counts */
    system->rcc = off | RCC_OSCSRC_INTERNAL;
    raise_core_voltage(system);
    system->misc = PLL_LOCKED;
    system->rcc = off | RCC_OSCSRC_MAIN;
    system->rcc = slow | RCC_OSCSRC_MAIN;
    int err = mcu_wait(&system->ris, PLL_LOCKED, PLL_LOCKED, PLL_LOOKS);
    if (err) return err;
    system->rcc = (slow & ~RCC_BYPASS) | RCC_OSCSRC_MAIN;
    return 0;
}

/* A peripheral may be touched three cycles of the system after it was clocked: the reads take them. */
void lm3s_peripherals_start(volatile struct lm3s_system_registers *system, uint8_t group, uint32_t mask)
{
    system->rcgc[group] |= mask;
    system->srcr[group] |= mask;
    (void)system->srcr[group];
    system->srcr[group] &= ~mask;
    (void)system->srcr[group];
}
