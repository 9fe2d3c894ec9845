/* SPDX-License-Identifier: MIT
 *
 * A stream is given a part of the message, at most what its counter holds; write() waits for all parts but the last,
 * which the next write() or flush() waits for. Few bytes are sent sooner than a stream is set up. */
#include "mcu/stm32_dma.h"

#include "mcu/wait.h"

#define SXCR_EN UINT32_C(1)
#define SXCR_DIR_FROM_MEMORY (UINT32_C(1) << 6)
#define SXCR_MINC (UINT32_C(1) << 10)
#define SXCR_CHSEL_SHIFT 25
#define ISR_TEIF UINT32_C(8)    /* an error on the bus */
#define ISR_TCIF UINT32_C(32)   /* complete */
#define IFCR_ALL UINT32_C(0x3D) /* of one stream */
#define SPI_CR2_TXDMAEN UINT32_C(2)

enum { PART_MAX_B = UINT16_MAX, POLLED_MAX_B = 16 };

/* Looks at a stream that takes no byte before it counts as stopped; see stm32_spi.c. */
#define LOOKS_MAX UINT32_C(65535)

static uint8_t flags_shift(uint8_t stream)
{
    return (uint8_t)(stream % 4 / 2 * 16 + stream % 2 * 6);
}

/* The controller's addresses have 32 bits, as the processor's. */
static uint32_t address_of(const volatile void *at)
{
    return (uint32_t)(uintptr_t)at;
}

int stm32_dma_init(struct stm32_dma *dma, struct stm32_dma_registers *registers, uint8_t stream, uint8_t channel,
                   const struct stm32_spi *spi)
{
    struct stm32_dma_stream *const chosen = &registers->streams[stream];

    *dma = (struct stm32_dma){.registers = registers, .stream = chosen, .spi = spi};
    dma->isr = &registers->isr[stream / 4];
    dma->ifcr = &registers->ifcr[stream / 4];
    dma->flags_shift = flags_shift(stream);
    chosen->cr = 0;
    int err = mcu_wait(&chosen->cr, SXCR_EN, 0, LOOKS_MAX);
    if (err) return err;
    chosen->par = address_of(&spi->registers->dr);
    if (chosen->par != address_of(&spi->registers->dr)) return MCU_ERR_CONFIG;
    chosen->fcr = 0;
    chosen->cr = (uint32_t)channel << SXCR_CHSEL_SHIFT | SXCR_MINC | SXCR_DIR_FROM_MEMORY;
    return 0;
}

/* What was written to memory must be there before the stream reads it. The SPI asks for data only while a stream sends:
 * a request stays until a stream acknowledges it (RM0090 10.3.2), so what the processor sends would leave one behind.
 */
static void start(struct stm32_dma *dma, const uint8_t *data, uint16_t n_b)
{
    *dma->ifcr = IFCR_ALL << dma->flags_shift;
    dma->stream->m0ar = address_of(data);
    dma->stream->ndtr = n_b;
    __atomic_thread_fence(__ATOMIC_SEQ_CST);
    dma->stream->cr |= SXCR_EN;
    dma->spi->registers->cr2 |= SPI_CR2_TXDMAEN;
    dma->sending = true;
}

static void stop(struct stm32_dma *dma)
{
    dma->stream->cr &= ~SXCR_EN;
    dma->spi->registers->cr2 &= ~SPI_CR2_TXDMAEN;
    dma->sending = false;
}

/* As long as bytes are taken, however many there are. */
static int await_end(const struct stm32_dma *dma)
{
    uint32_t left = dma->stream->ndtr;

    for (uint32_t looks = 0; looks < LOOKS_MAX; looks++) {
        const uint32_t flags = *dma->isr >> dma->flags_shift;
        const uint32_t before = left;
        if (flags & ISR_TEIF) return MCU_ERR_BUS;
        if (flags & ISR_TCIF) return 0;
        left = dma->stream->ndtr;
        if (left != before) looks = 0;
    }
    return MCU_ERR_TIMEOUT;
}

static int finish(struct stm32_dma *dma)
{
    if (!dma->sending) return 0;
    const int err = await_end(dma);
    stop(dma);
    return err;
}

static int write(void *ctx, const uint8_t *data, size_t n_b)
{
    struct stm32_dma *dma = ctx;
    int err = finish(dma);

    if (!err && n_b <= POLLED_MAX_B) return stm32_spi_write(dma->spi, data, n_b);
    while (!err && n_b) {
        const uint16_t part_b = n_b < PART_MAX_B ? (uint16_t)n_b : PART_MAX_B;
        start(dma, data, part_b);
        data += part_b;
        n_b -= part_b;
        if (n_b) err = finish(dma);
    }
    return err;
}

static int flush(void *ctx)
{
    struct stm32_dma *dma = ctx;
    const int err = finish(dma);

    return err ? err : stm32_spi_flush(dma->spi);
}

/* A part's: between two parts of a write() nobody asks. */
static size_t left_b(void *ctx)
{
    const struct stm32_dma *dma = ctx;

    return dma->sending ? dma->stream->ndtr : 0;
}

struct bus stm32_dma_bus(struct stm32_dma *dma)
{
    return (struct bus){.ctx = dma, .write = write, .flush = flush, .left_b = left_b};
}
