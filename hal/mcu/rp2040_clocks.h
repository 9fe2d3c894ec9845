/* SPDX-License-Identifier: MIT
 *
 * Clocks and resets of the RP2040: from the ring oscillator that it starts with to 125 MHz from a crystal of 12 MHz.
 * Manual: RP2040 Datasheet, 2.14 (resets), 2.15 (clocks), 2.16 (XOSC), 2.18 (PLL). Not tried on hardware. */
#ifndef HAL_MCU_RP2040_CLOCKS_H
#define HAL_MCU_RP2040_CLOCKS_H

#include "bus.h"

HAL_C_BEGIN

struct rp2040_resets_registers {
    uint32_t reset; /* a bit set holds a peripheral in reset */
    uint32_t wdsel;
    uint32_t reset_done;
};

struct rp2040_xosc_registers {
    uint32_t ctrl, status, dormant, startup;
    uint32_t reserved[3];
    uint32_t count;
};

struct rp2040_pll_registers {
    uint32_t cs, pwr, fbdiv_int, prim;
};

struct rp2040_clock_registers {
    uint32_t ctrl, div, selected;
};

struct rp2040_clocks_registers {
    struct rp2040_clock_registers gpout[4], ref, sys, peri, usb, adc, rtc;
};

#define RP2040_RESETS_REGISTERS ((volatile struct rp2040_resets_registers *)UINT32_C(0x4000C000))
#define RP2040_XOSC_REGISTERS ((volatile struct rp2040_xosc_registers *)UINT32_C(0x40024000))
#define RP2040_PLL_SYS_REGISTERS ((volatile struct rp2040_pll_registers *)UINT32_C(0x40028000))
#define RP2040_CLOCKS_REGISTERS ((volatile struct rp2040_clocks_registers *)UINT32_C(0x40008000))

struct rp2040_clocks {
    volatile struct rp2040_resets_registers *resets;
    volatile struct rp2040_xosc_registers *xosc;
    volatile struct rp2040_pll_registers *pll_sys;
    volatile struct rp2040_clocks_registers *clocks;
};

/* Bits of RESETS, 2.14.3. */
#define RP2040_RESET_DMA (UINT32_C(1) << 2)
#define RP2040_RESET_IO_BANK0 (UINT32_C(1) << 5)
#define RP2040_RESET_PADS_BANK0 (UINT32_C(1) << 8)
#define RP2040_RESET_PLL_SYS (UINT32_C(1) << 12)
#define RP2040_RESET_SPI0 (UINT32_C(1) << 16)

#define RP2040_SYS_HZ UINT32_C(125000000)

/* Takes the peripherals of the mask out of reset, where all are after power-on; who is out keeps its state.
 * MCU_ERR_TIMEOUT: one does not come out, for want of its clock. */
HAL_MUST_CHECK int rp2040_release(volatile struct rp2040_resets_registers *resets, uint32_t mask);

/* Puts them into reset first. */
HAL_MUST_CHECK int rp2040_reset(volatile struct rp2040_resets_registers *resets, uint32_t mask);

/* PLL_SYS's register PRIM: divides by both, which are 1 to 7. */
#define RP2040_PLL_PRIM(first, second) ((UINT32_C(first) << 16) | (UINT32_C(second) << 12))

/* Resets a PLL, by its bit of RESETS, and lets it run: 1500 MHz from the crystal, divided by `prim`. MCU_ERR_TIMEOUT:
 * it does not lock. */
HAL_MUST_CHECK int rp2040_pll_start(volatile struct rp2040_pll_registers *pll,
                                    volatile struct rp2040_resets_registers *resets, uint32_t reset, uint32_t prim);

/* What later chips of the family have otherwise. */
struct rp2040_clock_facts {
    uint32_t reset_pll_sys; /* its bit of RESETS */
    uint32_t pll_prim;      /* dividers behind 1500 MHz: RP2040_PLL_PRIM() */
    uint32_t div_1;         /* of a clock's register DIV: divide by 1 */
};

/* Runs clk_sys and clk_peri at 1500 MHz as the facts divide them; otherwise as rp2040_clocks_init(). */
HAL_MUST_CHECK int rp2040_clocks_start(const struct rp2040_clocks *at, const struct rp2040_clock_facts *facts);

/* Runs clk_sys and clk_peri at RP2040_SYS_HZ; whatever they ran at before, so also when called again. MCU_ERR_TIMEOUT:
 * the crystal or the PLL does not come up; the processor then runs on at some slower rate. */
HAL_MUST_CHECK int rp2040_clocks_init(const struct rp2040_clocks *at);

HAL_C_END

#endif
