/* SPDX-License-Identifier: MIT
 *
 * Clocks and resets of the RP2350, from a crystal of 12 MHz: 150 MHz for the processor, and 125 MHz for SPI, by the PLL
 * that USB would have. For a PL022 divides by even numbers, and of 150 MHz it has no rate from 37.5 to 75 MHz. Its
 * registers are laid out as the RP2040's (rp2040_clocks.h), at other addresses; bits of RESETS, the PLL's dividers and
 * the fraction of DIV differ. Manual: RP2350 Datasheet, 7.5 (resets), 8.1 (clocks), 8.2 (XOSC), 8.6 (PLL); numbers:
 * raspberrypi/pico-sdk, src/rp2350/hardware_regs/include/hardware/regs, addressmap.h, resets.h, clocks.h. Not tried on
 * hardware. */
#ifndef HAL_MCU_RP2350_CLOCKS_H
#define HAL_MCU_RP2350_CLOCKS_H

#include "mcu/rp2040_clocks.h"

HAL_C_BEGIN

#define RP2350_RESETS_REGISTERS ((volatile struct rp2040_resets_registers *)UINT32_C(0x40020000))
#define RP2350_XOSC_REGISTERS ((volatile struct rp2040_xosc_registers *)UINT32_C(0x40048000))
#define RP2350_PLL_SYS_REGISTERS ((volatile struct rp2040_pll_registers *)UINT32_C(0x40050000))
#define RP2350_PLL_USB_REGISTERS ((volatile struct rp2040_pll_registers *)UINT32_C(0x40058000))
#define RP2350_CLOCKS_REGISTERS ((volatile struct rp2040_clocks_registers *)UINT32_C(0x40010000))

/* Bits of RESETS. */
#define RP2350_RESET_DMA (UINT32_C(1) << 2)
#define RP2350_RESET_IO_BANK0 (UINT32_C(1) << 6)
#define RP2350_RESET_PADS_BANK0 (UINT32_C(1) << 9)
#define RP2350_RESET_PLL_SYS (UINT32_C(1) << 14)
#define RP2350_RESET_PLL_USB (UINT32_C(1) << 15)
#define RP2350_RESET_SPI0 (UINT32_C(1) << 18)

#define RP2350_SYS_HZ UINT32_C(150000000)
#define RP2350_PERI_HZ UINT32_C(125000000)

/* Runs clk_sys at RP2350_SYS_HZ and clk_peri at RP2350_PERI_HZ; otherwise as rp2040_clocks_init(). What is clocked by
 * clk_peri should be in reset. rp2040_release() and rp2040_reset() serve both chips. */
HAL_MUST_CHECK int rp2350_clocks_init(const struct rp2040_clocks *at, volatile struct rp2040_pll_registers *pll_usb);

HAL_C_END

#endif
