/* SPDX-License-Identifier: MIT
 *
 * Clocks of SiFive's FE310: 256 MHz from a crystal of 16 MHz, or the ring oscillator where that does not start.
 * Registers: FE310-G000 Manual, chapter 6, "Clock Generation (PRCI)". */
#ifndef HAL_MCU_FE310_PRCI_H
#define HAL_MCU_FE310_PRCI_H

#include "mcu/fe310_spi.h"

struct fe310_prci {
    volatile uint32_t hfrosccfg, hfxosccfg, pllcfg, plloutdiv;
};

#define FE310_PRCI ((struct fe310_prci *)UINT32_C(0x10008000))

/* `flash` is the SPI that instructions come through, `clock` one that does not depend on the processor's rate. Returns
 * the rate that became of it; the ring oscillator's is the most that it may be. */
uint32_t fe310_prci_init(struct fe310_prci *prci, struct fe310_spi_registers *flash, const struct clock *clock);

#endif
