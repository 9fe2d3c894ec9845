/* SPDX-License-Identifier: MIT */
#include "mcu/rp2350_dma.h"

/* CHx_CTRL_TRIG. DATA_SIZE = 0: bytes. A channel that is chained to itself starts no other. */
#define CTRL_EN UINT32_C(1)
#define CTRL_INCR_READ (UINT32_C(1) << 4)
#define CTRL_CHAIN_TO(channel) ((uint32_t)(channel) << 13)
#define CTRL_TREQ_SEL(dreq) ((uint32_t)(dreq) << 17)
#define CTRL_IRQ_QUIET (UINT32_C(1) << 23)
#define CTRL_BUSY (UINT32_C(1) << 26)
#define CTRL_ERRORS (UINT32_C(7) << 29) /* ones clear them */

void rp2350_dma_init(struct rp2040_dma *dma, volatile struct rp2350_dma_registers *registers, uint8_t channel,
                     struct pl022 *spi, uint8_t dreq)
{
    *dma = (struct rp2040_dma){
        .channel = &registers->ch[channel],
        .chan_abort = &registers->chan_abort,
        .spi = spi,
        .start = CTRL_EN | CTRL_INCR_READ | CTRL_CHAIN_TO(channel) | CTRL_TREQ_SEL(dreq) | CTRL_IRQ_QUIET | CTRL_ERRORS,
        .busy = CTRL_BUSY,
        .mask = UINT32_C(1) << channel,
    };
    spi->registers->dmacr = PL022_DMACR_TXDMAE;
}
