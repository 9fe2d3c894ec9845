/* SPDX-License-Identifier: MIT
 *
 * The crystal's 16 MHz are halved, multiplied by 64, which is within the oscillator's 384 to 768 MHz, and halved. */
#include "mcu/fe310_prci.h"

#include "mcu/wait.h"

#define ON (UINT32_C(1) << 30)           /* of both oscillators */
#define READY (UINT32_C(1) << 31)        /* of both, and the PLL's LOCK */
#define HFROSC_MAX_HZ UINT32_C(20000000) /* 72 MHz by 5, and what a ring may be off */
#define PLL_HZ UINT32_C(256000000)

enum {
    HFROSC_FIELDS = 0x1F << 16 | 0x3F,
    HFROSC_AFTER_RESET = 16 << 16 | 4, /* trimmed to the middle, divided by 5 */
    PLL_FIELDS = 0x70FF7,              /* BYPASS, REFSEL, SEL, Q, F, R */
    PLL_R_2 = 1,
    PLL_F_64 = 31 << 4,
    PLL_Q_2 = 1 << 10,
    PLL_SEL = 1 << 16,
    PLL_REFSEL_HFXOSC = 1 << 17,
    PLL_BYPASS = 1 << 18,
    PLLOUT_DIV_BY_1 = 1 << 8,
    FLASH_SCKDIV = 8, /* 256 MHz / (2 * (8 + 1)), 14.2 MHz: fe310_prci.h */
    LOCK_US = 100,    /* for so long LOCK may say anything */
};

/* 30 ms and more at 14 MHz. */
#define LOOKS_MAX UINT32_C(100000)

static void set_fields(volatile uint32_t *reg, uint32_t mask, uint32_t value)
{
    *reg = (*reg & ~mask) | value;
}

static int start(volatile uint32_t *oscillator)
{
    *oscillator |= ON;
    return mcu_wait(oscillator, READY, READY, LOOKS_MAX);
}

/* As after a reset. A boot loader may have stopped it; there is nothing else to run by if it never becomes ready. */
static void run_by_ring(struct fe310_prci *prci)
{
    set_fields(&prci->hfrosccfg, HFROSC_FIELDS, HFROSC_AFTER_RESET);
    (void)start(&prci->hfrosccfg);
    set_fields(&prci->pllcfg, PLL_SEL, 0);
}

/* The PLL begins to lock when it is no longer passed by. */
static int start_pll(struct fe310_prci *prci, const struct clock *clock)
{
    set_fields(&prci->plloutdiv, 0x13F, PLLOUT_DIV_BY_1);
    set_fields(&prci->pllcfg, PLL_FIELDS, PLL_BYPASS | PLL_REFSEL_HFXOSC | PLL_Q_2 | PLL_F_64 | PLL_R_2);
    set_fields(&prci->pllcfg, PLL_BYPASS, 0);
    int err = clock_delay(clock, LOCK_US);
    return err ? err : mcu_wait(&prci->pllcfg, READY, READY, LOOKS_MAX);
}

uint32_t fe310_prci_init(struct fe310_prci *prci, struct fe310_spi_registers *flash, const struct clock *clock)
{
    run_by_ring(prci);
    flash->sckdiv = FLASH_SCKDIV; /* before the PLL is selected: instructions come through it */
    if (start(&prci->hfxosccfg) || start_pll(prci, clock)) return HFROSC_MAX_HZ;
    prci->pllcfg |= PLL_SEL;
    return PLL_HZ;
}
