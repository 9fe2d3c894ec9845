/* SPDX-License-Identifier: MIT */
#include "mcu/stm32f1_rcc.h"

#include "mcu/stm32_clock.h"

#define HSI_HZ UINT32_C(8000000)
#define HSE_HZ UINT32_C(8000000)
#define APB1_MAX_HZ UINT32_C(36000000)
#define WAIT_STATE_HZ UINT32_C(24000000) /* one more for each of these begun beyond the first: PM0075 3.1 */

enum {
    CFGR_HPRE = 0xF << 4,
    CFGR_PPRE1 = 7 << 8,
    CFGR_PPRE2 = 7 << 11,
    CFGR_PLL = 0x3F << 16, /* PLLSRC, PLLXTPRE, PLLMUL */
    CFGR_PPRE1_2 = 4 << 8,
    CFGR_PLLSRC_HSE = 1 << 16,
    CFGR_PLLMUL_SHIFT = 18, /* 0: twice */
    ACR_LATENCY = 7,
    ACR_PRFTBE = 1 << 4,
};

static void configure(struct stm32f1_rcc *rcc, uint32_t bits)
{
    rcc->cfgr = (rcc->cfgr & ~(uint32_t)(CFGR_HPRE | CFGR_PPRE1 | CFGR_PPRE2 | CFGR_PLL)) | bits;
}

static void reset(struct stm32f1_rcc *rcc)
{
    stm32_clock_reset(&rcc->cr, &rcc->cfgr);
    configure(rcc, 0);
}

/* An F100 has no wait states, and no bits for them: zero is what is left. */
static bool set_latency(volatile uint32_t *flash_acr, uint32_t cpu_hz)
{
    const uint32_t latency = (cpu_hz - 1) / WAIT_STATE_HZ;

    *flash_acr = latency | ACR_PRFTBE;
    return (*flash_acr & ACR_LATENCY) == latency;
}

static bool run_by_pll(struct stm32f1_rcc *rcc, volatile uint32_t *flash_acr, uint32_t cpu_hz)
{
    const uint32_t halve_apb1 = cpu_hz > APB1_MAX_HZ ? CFGR_PPRE1_2 : 0;

    if (!stm32_clock_start(&rcc->cr, STM32_HSE_ON)) return false;
    configure(rcc, (cpu_hz / HSE_HZ - 2) << CFGR_PLLMUL_SHIFT | CFGR_PLLSRC_HSE | halve_apb1);
    if (!stm32_clock_start(&rcc->cr, STM32_PLL_ON)) return false;
    return set_latency(flash_acr, cpu_hz) && stm32_clock_select(&rcc->cfgr, STM32_BY_PLL);
}

uint32_t stm32f1_rcc_init(struct stm32f1_rcc *rcc, volatile uint32_t *flash_acr, uint32_t cpu_hz)
{
    reset(rcc);
    if (run_by_pll(rcc, flash_acr, cpu_hz)) return cpu_hz;
    reset(rcc);
    return HSI_HZ;
}

void stm32f1_rcc_reset(struct stm32f1_rcc *rcc, uint32_t apb2)
{
    rcc->apb2rstr |= apb2;
    rcc->apb2rstr &= ~apb2;
}

void stm32f1_rcc_enable(struct stm32f1_rcc *rcc, uint32_t apb2)
{
    rcc->apb2enr |= apb2;
    (void)rcc->apb2enr;
}
