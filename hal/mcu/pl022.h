/* SPDX-License-Identifier: MIT
 *
 * Arm PrimeCell Synchronous Serial Port PL022 as a bus: the SSI of Stellaris parts, the SPI of the RP2040. Polled, with
 * waits that end; what a board adds for DMA it reaches through `registers`.
 * Manual: Arm DDI 0194 (PrimeCell Synchronous Serial Port), chapter 3. Not tried on hardware. */
#ifndef HAL_MCU_PL022_H
#define HAL_MCU_PL022_H

#include "bus.h"
#include "mcu/mcu.h"

HAL_C_BEGIN

/* Names without the manual's SSP. Tests hand over plain memory. */
struct pl022_registers {
    uint32_t cr0;   /* 0x00: SCR, SPH, SPO, FRF, DSS */
    uint32_t cr1;   /* 0x04: SOD, MS, SSE, LBM */
    uint32_t dr;    /* 0x08: writes enter the transmit FIFO, reads take from the receive FIFO */
    uint32_t sr;    /* 0x0c */
    uint32_t cpsr;  /* 0x10: CPSDVSR, even, 2..254 */
    uint32_t imsc;  /* 0x14 */
    uint32_t ris;   /* 0x18 */
    uint32_t mis;   /* 0x1c */
    uint32_t icr;   /* 0x20 */
    uint32_t dmacr; /* 0x24: TXDMAE, RXDMAE; absent where no DMA controller is */
};

enum {
    PL022_SR_TFE = 1u << 0, /* transmit FIFO empty */
    PL022_SR_TNF = 1u << 1, /* transmit FIFO not full */
    PL022_SR_RNE = 1u << 2, /* receive FIFO not empty */
    PL022_SR_RFF = 1u << 3, /* receive FIFO full */
    PL022_SR_BSY = 1u << 4, /* transmitting, or something left to transmit */
    PL022_CR1_SSE = 1u << 1,
    PL022_DMACR_TXDMAE = 1u << 1,
    PL022_FIFO_B = 8,
};

struct pl022_config {
    uint32_t clock_hz; /* SSPCLK */
    uint32_t spi_hz;   /* at most */
    uint8_t mode;      /* SPI's 0..3: bit 1 is the clock's idle level, bit 0 set samples at the second edge */
};

struct pl022 {
    volatile struct pl022_registers *registers;
    uint32_t spi_hz;      /* that it runs at: the fastest rate not above the one asked for */
    uint32_t limit_polls; /* of one wait */
};

/* Sets up a master of 8-bit frames, enabled. What an abandoned transfer left in the FIFO goes out first, so the panel
 * should not be selected. MCU_ERR_CONFIG: the rate cannot be reached by dividing; MCU_ERR_TIMEOUT: it never gets idle.
 */
HAL_MUST_CHECK int pl022_init(struct pl022 *pl022, volatile struct pl022_registers *registers,
                              const struct pl022_config *config);

/* Puts bytes into the FIFO; the last ones are still on their way at the return. MCU_ERR_TIMEOUT: it does not move. */
HAL_MUST_CHECK int pl022_write(struct pl022 *pl022, const uint8_t *data, size_t n_b);

/* Waits until the last byte has left, and empties the receive FIFO. MCU_ERR_TIMEOUT: it never does. */
HAL_MUST_CHECK int pl022_flush(struct pl022 *pl022);

/* The two as a bus; *pl022 must outlive it. */
struct bus pl022_bus(struct pl022 *pl022);

HAL_C_END

#endif
