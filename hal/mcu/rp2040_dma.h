/* SPDX-License-Identifier: MIT
 *
 * A bus that sends by DMA: a channel of the RP2040, or of an RP2350 (rp2350_dma.h), feeds the PL022's FIFO while the
 * processor paints the next line. write() returns when the channel has begun, and the next write() or flush() waits for
 * it. What is short is polled: it would have left before a channel is set up and looked after. Manual: RP2040
 * Datasheet, 2.5 (DMA) and 4.4 (SPI). Not tried on hardware. */
#ifndef HAL_MCU_RP2040_DMA_H
#define HAL_MCU_RP2040_DMA_H

#include "mcu/pl022.h"

HAL_C_BEGIN

/* A channel's registers; behind them come the same under other names, which start it by another of them. */
struct rp2040_dma_channel_registers {
    uint32_t read_addr, write_addr, trans_count, ctrl_trig;
    uint32_t aliases[12];
};

struct rp2040_dma_registers {
    struct rp2040_dma_channel_registers ch[12];
    uint32_t reserved[64];
    uint32_t intr, inte0, intf0, ints0;
    uint32_t reserved1, inte1, intf1, ints1;
    uint32_t timer[4];
    uint32_t multi_chan_trigger, sniff_ctrl, sniff_data, reserved2;
    uint32_t fifo_levels, chan_abort, n_channels;
};

#define RP2040_DMA_REGISTERS ((volatile struct rp2040_dma_registers *)UINT32_C(0x50000000))
#define RP2040_SPI0_REGISTERS ((volatile struct pl022_registers *)UINT32_C(0x4003C000))

enum {
    RP2040_DREQ_SPI0_TX = 16, /* 2.5.3.1 */
    RP2040_DMA_MIN_B = 16,    /* less is polled: two FIFOs */
};

/* Where later chips of the family have other bits, they are here, too. */
struct rp2040_dma {
    volatile struct rp2040_dma_channel_registers *channel;
    volatile uint32_t *chan_abort;
    struct pl022 *spi;
    uint32_t start; /* what CTRL_TRIG is written to begin */
    uint32_t busy;  /* its bit */
    uint32_t mask;  /* the channel's bit where each has one */
};

/* Takes the channel, which must not be in use, for the SPI, which is set up. */
void rp2040_dma_init(struct rp2040_dma *dma, volatile struct rp2040_dma_registers *registers, uint8_t channel,
                     struct pl022 *spi, uint8_t dreq);

/* *dma must outlive the bus. Its calls return MCU_ERR_TIMEOUT when bytes do not leave, MCU_ERR_BUS when memory could
 * not be read; the channel has then been stopped. */
struct bus rp2040_dma_bus(struct rp2040_dma *dma);

HAL_C_END

#endif
