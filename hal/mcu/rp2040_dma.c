/* SPDX-License-Identifier: MIT */
#include "mcu/rp2040_dma.h"

#include "mcu/wait.h"

/* CHx_CTRL_TRIG, 2.5.7. DATA_SIZE = 0: bytes. A channel that is chained to itself starts no other. */
#define CTRL_EN UINT32_C(1)
#define CTRL_INCR_READ (UINT32_C(1) << 4)
#define CTRL_CHAIN_TO(channel) ((uint32_t)(channel) << 11)
#define CTRL_TREQ_SEL(dreq) ((uint32_t)(dreq) << 15)
#define CTRL_IRQ_QUIET (UINT32_C(1) << 21)
#define CTRL_BUSY (UINT32_C(1) << 24)
#define CTRL_ERRORS (UINT32_C(7) << 29) /* WRITE_ERROR and READ_ERROR, which ones clear, and AHB_ERROR, their sum */

/* The looks at a channel while its count stands still: a byte's time at the slowest rate that a panel is driven at,
 * 100 kHz, is 10,000 cycles. */
enum { LOOKS_MAX = 1 << 14 };

/* Disabled first, or it would go on to the next byte. */
static int stop(const struct rp2040_dma *dma)
{
    dma->channel->ctrl_trig &= ~CTRL_EN;
    *dma->chan_abort = dma->mask;
    const int err = mcu_wait(dma->chan_abort, dma->mask, 0, LOOKS_MAX);
    return err ? err : MCU_ERR_TIMEOUT;
}

/* Until all bytes are in the FIFO. No time that is needed is known, only that bytes must go on leaving. A function of
 * its own, so that who counts cycles can tell waiting from work. */
static __attribute__((noinline)) int rp2040_dma_wait(const struct rp2040_dma *dma)
{
    volatile struct rp2040_dma_channel_registers *const channel = dma->channel;
    uint32_t before = channel->trans_count, looks = 0;

    while (channel->ctrl_trig & dma->busy) {
        const uint32_t left = channel->trans_count;
        looks = left == before ? looks + 1 : 0;
        if (looks == LOOKS_MAX) return stop(dma);
        before = left;
    }
    if (!(channel->ctrl_trig & CTRL_ERRORS)) return 0;
    channel->ctrl_trig = CTRL_ERRORS;
    return MCU_ERR_BUS;
}

static void start(const struct rp2040_dma *dma, const uint8_t *data, size_t n_b)
{
    volatile struct rp2040_dma_channel_registers *const channel = dma->channel;

    channel->read_addr = (uint32_t)(uintptr_t)data;
    channel->write_addr = (uint32_t)(uintptr_t)&dma->spi->registers->dr;
    channel->trans_count = (uint32_t)n_b;
    __asm__ volatile("" ::: "memory"); /* what was painted is in memory */
    channel->ctrl_trig = dma->start;
}

static int dma_write(void *ctx, const uint8_t *data, size_t n_b)
{
    const struct rp2040_dma *dma = ctx;
    int err = rp2040_dma_wait(dma);

    if (err) return err;
    if (n_b < RP2040_DMA_MIN_B) return pl022_write(dma->spi, data, n_b);
    start(dma, data, n_b);
    return 0;
}

static int dma_flush(void *ctx)
{
    const struct rp2040_dma *dma = ctx;
    int err = rp2040_dma_wait(dma);

    return err ? err : pl022_flush(dma->spi);
}

static size_t dma_left_b(void *ctx)
{
    const struct rp2040_dma *dma = ctx;

    return dma->channel->ctrl_trig & dma->busy ? dma->channel->trans_count : 0;
}

void rp2040_dma_init(struct rp2040_dma *dma, volatile struct rp2040_dma_registers *registers, uint8_t channel,
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

struct bus rp2040_dma_bus(struct rp2040_dma *dma)
{
    return (struct bus){.ctx = dma, .write = dma_write, .flush = dma_flush, .left_b = dma_left_b};
}
