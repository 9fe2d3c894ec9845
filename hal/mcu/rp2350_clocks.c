/* SPDX-License-Identifier: MIT */
#include "mcu/rp2350_clocks.h"

#include "mcu/wait.h"

/* DIV has 16 fraction bits. */
#define DIV_1 (UINT32_C(1) << 16)

/* CLK_PERI_CTRL. */
#define PERI_BY_PLL_USB (UINT32_C(2) << 5)
#define PERI_ENABLE (UINT32_C(1) << 11)
#define PERI_ENABLED (UINT32_C(1) << 28)

/* A clock stops within a few of its own cycles. */
enum { LOOKS = 1 << 12 };

/* Its source is changed while it stands still. */
static int run_peri(volatile struct rp2040_clock_registers *peri)
{
    peri->ctrl = 0;
    int err = mcu_wait(&peri->ctrl, PERI_ENABLED, 0, LOOKS);
    if (err) return err;
    peri->div = DIV_1;
    peri->ctrl = PERI_BY_PLL_USB;
    peri->ctrl = PERI_BY_PLL_USB | PERI_ENABLE;
    return 0;
}

int rp2350_clocks_init(const struct rp2040_clocks *at, volatile struct rp2040_pll_registers *pll_usb)
{
    static const struct rp2040_clock_facts FACTS = {
        .reset_pll_sys = RP2350_RESET_PLL_SYS,
        .pll_prim = RP2040_PLL_PRIM(5, 2),
        .div_1 = DIV_1,
    };
    int err = rp2040_clocks_start(at, &FACTS);

    if (!err) err = rp2040_pll_start(pll_usb, at->resets, RP2350_RESET_PLL_USB, RP2040_PLL_PRIM(6, 2));
    return err ? err : run_peri(&at->clocks->peri);
}
