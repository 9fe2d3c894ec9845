/* SPDX-License-Identifier: MIT */
#include "hardware/dma.h"

spi_inst_t fake_spi0;

int dma_claim_unused_channel(bool required)
{
    static int claimed;

    if (claimed++ && required) wires_complain("Pico: a second channel is claimed");
    return 3;
}

dma_channel_hw_t *dma_channel_hw_addr(uint channel)
{
    static dma_channel_hw_t hw;

    if (channel != 3) wires_complain("Pico: a channel that was not claimed");
    hw.transfer_count = (uint32_t)wires_dma_left_b();
    return &hw;
}
