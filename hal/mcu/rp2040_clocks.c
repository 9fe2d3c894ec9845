/* SPDX-License-Identifier: MIT */
#include "mcu/rp2040_clocks.h"

#include "mcu/wait.h"

/* The crystal oscillator, 2.16.7. STARTUP.DELAY counts 256 cycles each: 1 ms. */
#define XOSC_CTRL_FREQ_RANGE_1_15_MHZ UINT32_C(0xAA0)
#define XOSC_CTRL_ENABLE (UINT32_C(0xFAB) << 12)
#define XOSC_STATUS_STABLE (UINT32_C(1) << 31)
#define XOSC_STARTUP_DELAY UINT32_C(47)

/* The PLL, 2.18.4: 12 MHz / 1 * 125 = 1500 MHz, which the two dividers behind it make 125 MHz. */
#define PLL_REFDIV UINT32_C(1)
#define PLL_FBDIV UINT32_C(125)
#define PLL_CS_LOCK (UINT32_C(1) << 31)
#define PLL_PWR_PD UINT32_C(1)
#define PLL_PWR_POSTDIVPD (UINT32_C(1) << 3)
#define PLL_PWR_VCOPD (UINT32_C(1) << 5)

/* Clocks, 2.15.7: sources of the glitchless multiplexers, and how SELECTED tells them. */
#define CLK_REF_SRC_XOSC UINT32_C(2)
#define CLK_SRC UINT32_C(3) /* clk_sys has bit 0 of it alone */
#define CLK_SYS_SRC_REF UINT32_C(0)
#define CLK_SYS_SRC_AUX UINT32_C(1)         /* AUXSRC = 0: PLL_SYS */
#define CLK_PERI_ENABLE (UINT32_C(1) << 11) /* AUXSRC = 0: clk_sys */

/* The longest wait is the crystal's, 1 ms and some more, on the ring oscillator's 12 MHz at most. */
#define LOOKS (UINT32_C(1) << 16)

int rp2040_release(volatile struct rp2040_resets_registers *resets, uint32_t mask)
{
    resets->reset &= ~mask;
    return mcu_wait(&resets->reset_done, mask, mask, LOOKS);
}

int rp2040_reset(volatile struct rp2040_resets_registers *resets, uint32_t mask)
{
    resets->reset |= mask;
    return rp2040_release(resets, mask);
}

static int start_crystal(volatile struct rp2040_xosc_registers *xosc)
{
    xosc->startup = XOSC_STARTUP_DELAY;
    xosc->ctrl = XOSC_CTRL_ENABLE | XOSC_CTRL_FREQ_RANGE_1_15_MHZ;
    return mcu_wait(&xosc->status, XOSC_STATUS_STABLE, XOSC_STATUS_STABLE, LOOKS);
}

int rp2040_pll_start(volatile struct rp2040_pll_registers *pll, volatile struct rp2040_resets_registers *resets,
                     uint32_t reset, uint32_t prim)
{
    int err = rp2040_reset(resets, reset);

    if (err) return err;
    pll->cs = PLL_REFDIV;
    pll->fbdiv_int = PLL_FBDIV;
    pll->pwr &= ~(PLL_PWR_PD | PLL_PWR_VCOPD);
    err = mcu_wait(&pll->cs, PLL_CS_LOCK, PLL_CS_LOCK, LOOKS);
    if (err) return err;
    pll->prim = prim;
    pll->pwr &= ~PLL_PWR_POSTDIVPD;
    return 0;
}

/* SELECTED has one bit for each source. AUXSRC stays: its multiplexer is not free of glitches. */
static int switch_to(volatile struct rp2040_clock_registers *clock, uint32_t source)
{
    const uint32_t selected = UINT32_C(1) << source;

    clock->ctrl = (clock->ctrl & ~CLK_SRC) | source;
    return mcu_wait(&clock->selected, selected, selected, LOOKS);
}

/* Away from the PLL while it changes. */
int rp2040_clocks_start(const struct rp2040_clocks *at, const struct rp2040_clock_facts *facts)
{
    volatile struct rp2040_clocks_registers *const clocks = at->clocks;
    int err = start_crystal(at->xosc);

    if (!err) err = switch_to(&clocks->sys, CLK_SYS_SRC_REF);
    if (!err) err = switch_to(&clocks->ref, CLK_REF_SRC_XOSC);
    if (!err) err = rp2040_pll_start(at->pll_sys, at->resets, facts->reset_pll_sys, facts->pll_prim);
    if (err) return err;
    clocks->sys.ctrl = CLK_SYS_SRC_REF;
    clocks->sys.div = facts->div_1;
    clocks->peri.ctrl = CLK_PERI_ENABLE;
    return switch_to(&clocks->sys, CLK_SYS_SRC_AUX);
}

int rp2040_clocks_init(const struct rp2040_clocks *at)
{
    static const struct rp2040_clock_facts FACTS = {
        .reset_pll_sys = RP2040_RESET_PLL_SYS,
        .pll_prim = RP2040_PLL_PRIM(6, 2),
        .div_1 = UINT32_C(1) << 8,
    };

    return rp2040_clocks_start(at, &FACTS);
}
