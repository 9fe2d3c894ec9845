/* SPDX-License-Identifier: MIT
 *
 * The crystal is divided to 1 MHz, multiplied to 336 and halved; USB's seventh would be 48 MHz. The regulator's scale
 * 1, which 168 MHz need, is what it has after a reset. */
#include "mcu/stm32f4_rcc.h"

#include "mcu/stm32_clock.h"

#define HSI_HZ UINT32_C(16000000)
#define PLL_HZ UINT32_C(168000000)
#define PLLCFGR_RESERVED UINT32_C(0xF0BC8000) /* not all of them are 0, and they are to be kept: RM0090 7.3.2 */

enum {
    PLLN = 336,
    PLLQ = 7,
    PLLCFGR_PLLN_SHIFT = 6,
    PLLCFGR_PLLSRC_HSE = 1 << 22,
    PLLCFGR_PLLQ_SHIFT = 24,
    CFGR_HPRE = 0xF << 4,
    CFGR_PPRE1 = 7 << 10,
    CFGR_PPRE2 = 7 << 13,
    CFGR_PPRE1_4 = 5 << 10, /* 42 MHz, the most of this bus */
    CFGR_PPRE2_2 = 4 << 13, /* 84 MHz, the most of this bus */
    ACR_LATENCY = 7,
    ACR_LATENCY_5 = 5, /* at 2.7 V and more: RM0090 3.5.1 */
    ACR_PRFTEN = 1 << 8,
    ACR_ICEN = 1 << 9,
    ACR_DCEN = 1 << 10,
};

static void divide_buses(struct stm32f4_rcc *rcc, uint32_t dividers)
{
    rcc->cfgr = (rcc->cfgr & ~(uint32_t)(CFGR_HPRE | CFGR_PPRE1 | CFGR_PPRE2)) | dividers;
}

static void reset(struct stm32f4_rcc *rcc)
{
    stm32_clock_reset(&rcc->cr, &rcc->cfgr);
    divide_buses(rcc, 0);
}

/* Wait states first: flash would not keep up. */
static bool run_by_pll(struct stm32f4_rcc *rcc, volatile uint32_t *flash_acr, uint32_t hse_hz)
{
    if (!stm32_clock_start(&rcc->cr, STM32_HSE_ON)) return false;
    rcc->pllcfgr = (rcc->pllcfgr & PLLCFGR_RESERVED) | hse_hz / 1000000u | (uint32_t)PLLN << PLLCFGR_PLLN_SHIFT |
                   PLLCFGR_PLLSRC_HSE | (uint32_t)PLLQ << PLLCFGR_PLLQ_SHIFT;
    if (!stm32_clock_start(&rcc->cr, STM32_PLL_ON)) return false;
    *flash_acr = ACR_LATENCY_5 | ACR_PRFTEN | ACR_ICEN | ACR_DCEN;
    if ((*flash_acr & ACR_LATENCY) != ACR_LATENCY_5) return false;
    divide_buses(rcc, CFGR_PPRE1_4 | CFGR_PPRE2_2);
    return stm32_clock_select(&rcc->cfgr, STM32_BY_PLL);
}

struct stm32f4_clocks stm32f4_rcc_init(struct stm32f4_rcc *rcc, volatile uint32_t *flash_acr, uint32_t hse_hz)
{
    reset(rcc);
    if (run_by_pll(rcc, flash_acr, hse_hz))
        return (struct stm32f4_clocks){.cpu_hz = PLL_HZ, .apb1_hz = PLL_HZ / 4, .apb2_hz = PLL_HZ / 2};
    reset(rcc);
    return (struct stm32f4_clocks){.cpu_hz = HSI_HZ, .apb1_hz = HSI_HZ, .apb2_hz = HSI_HZ};
}

void stm32f4_rcc_reset(struct stm32f4_rcc *rcc, uint32_t ahb1, uint32_t apb2)
{
    rcc->ahb1rstr |= ahb1;
    rcc->ahb1rstr &= ~ahb1;
    rcc->apb2rstr |= apb2;
    rcc->apb2rstr &= ~apb2;
}

/* A peripheral listens two cycles after its clock is on; reading back takes them: ES0182, "Delay after an RCC
 * peripheral clock enabling". */
void stm32f4_rcc_enable(struct stm32f4_rcc *rcc, uint32_t ahb1, uint32_t apb2)
{
    rcc->ahb1enr |= ahb1;
    rcc->apb2enr |= apb2;
    (void)rcc->ahb1enr;
    (void)rcc->apb2enr;
}
