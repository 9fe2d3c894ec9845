/* SPDX-License-Identifier: MIT
 *
 * The RP2350's DMA controller, for the bus of rp2040_dma.h: 16 channels, whose registers are the RP2040's; bits of
 * CTRL_TRIG and the requests' numbers differ.
 * Manual: RP2350 Datasheet, 12.6 (DMA); numbers: raspberrypi/pico-sdk, src/rp2350/hardware_regs/include/hardware/regs,
 * dma.h and dreq.h. Not tried on hardware. */
#ifndef HAL_MCU_RP2350_DMA_H
#define HAL_MCU_RP2350_DMA_H

#include "mcu/rp2040_dma.h"

HAL_C_BEGIN

struct rp2350_dma_registers {
    struct rp2040_dma_channel_registers ch[16];
    uint32_t interrupts[16]; /* INTR, INTE0, INTF0, INTS0, and three more sets */
    uint32_t timer[4];
    uint32_t multi_chan_trigger, sniff_ctrl, sniff_data, reserved;
    uint32_t fifo_levels, chan_abort, n_channels;
};

#define RP2350_DMA_REGISTERS ((volatile struct rp2350_dma_registers *)UINT32_C(0x50000000))
#define RP2350_SPI0_REGISTERS ((volatile struct pl022_registers *)UINT32_C(0x40080000))

enum { RP2350_DREQ_SPI0_TX = 24 };

/* Takes the channel, which must not be in use, for the SPI, which is set up; then rp2040_dma_bus(). A transfer has less
 * than 2^28 bytes: the bits above are its mode. */
void rp2350_dma_init(struct rp2040_dma *dma, volatile struct rp2350_dma_registers *registers, uint8_t channel,
                     struct pl022 *spi, uint8_t dreq);

HAL_C_END

#endif
