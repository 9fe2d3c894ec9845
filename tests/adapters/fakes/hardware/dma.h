/* SPDX-License-Identifier: MIT
 *
 * A fake of the Pico SDK: DMA. */
#ifndef FAKE_HARDWARE_DMA_H
#define FAKE_HARDWARE_DMA_H

#include "hardware/spi.h"

typedef struct {
    volatile uint32_t transfer_count;
} dma_channel_hw_t;
typedef enum dma_channel_transfer_size { DMA_SIZE_8 = 0, DMA_SIZE_16 = 1, DMA_SIZE_32 = 2 } dma_channel_transfer_size_t;
typedef struct {
    uint dreq;
    dma_channel_transfer_size_t size;
} dma_channel_config_t;
typedef dma_channel_config_t dma_channel_config;

int dma_claim_unused_channel(bool required);
dma_channel_hw_t *dma_channel_hw_addr(uint channel);

static inline dma_channel_config_t dma_channel_get_default_config(uint channel)
{
    const dma_channel_config_t config = {0x3f, DMA_SIZE_32};
    (void)channel;
    return config;
}

static inline void channel_config_set_dreq(dma_channel_config_t *c, uint dreq)
{
    c->dreq = dreq;
}

static inline void channel_config_set_transfer_data_size(dma_channel_config_t *c, dma_channel_transfer_size_t size)
{
    c->size = size;
}

static inline void dma_channel_configure(uint channel, const dma_channel_config_t *config, volatile void *write_addr,
                                         const volatile void *read_addr, uint32_t transfer_count, bool trigger)
{
    (void)channel, (void)read_addr;
    if (config->dreq != 16 || config->size != DMA_SIZE_8 || write_addr != &spi0->hw.dr || transfer_count || trigger)
        wires_complain("Pico: DMA that does not feed the SPI byte by byte at its pace");
}

static inline void dma_channel_transfer_from_buffer_now(uint channel, const volatile void *read_addr,
                                                        uint32_t transfer_count)
{
    (void)channel;
    wires_dma((const uint8_t *)read_addr, transfer_count);
}

static inline void dma_channel_wait_for_finish_blocking(uint channel)
{
    (void)channel;
    wires_dma_wait();
}

#endif
