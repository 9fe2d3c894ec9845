/* SPDX-License-Identifier: MIT
 *
 * Clocks of SiFive's FE310: 256 MHz from a crystal of 16 MHz, or the ring oscillator where that does not start.
 * Registers: FE310-G000 Manual, chapter 6, "Clock Generation (PRCI)", and "SPI" (SCKDIV: SCK is the clock by twice the
 * divider and one).
 *
 * The flash that instructions come from is read at 14.2 MHz, by SCKDIV = 8, which is what SiFive's own start-up code
 * sets for 256 MHz (sifive/freedom-e-sdk, bsp/env/freedom-e300-hifive1/init.c), and all others found. Its command after
 * a reset, 03h, may have 50 MHz by its data sheet (IS25LP128, "Normal Read"), but nobody says when the FE310 samples
 * what comes back: 3, an eighth, may well do, and is not known to. Not tried on hardware. */
#ifndef HAL_MCU_FE310_PRCI_H
#define HAL_MCU_FE310_PRCI_H

#include "mcu/fe310_spi.h"

HAL_C_BEGIN

struct fe310_prci {
    volatile uint32_t hfrosccfg, hfxosccfg, pllcfg, plloutdiv;
};

#define FE310_PRCI ((struct fe310_prci *)UINT32_C(0x10008000))

/* `flash` is the SPI that instructions come through, `clock` one that does not depend on the processor's rate. Returns
 * the rate that became of it; the ring oscillator's is the most that it may be. */
uint32_t fe310_prci_init(struct fe310_prci *prci, struct fe310_spi_registers *flash, const struct clock *clock);

HAL_C_END

#endif
