/* SPDX-License-Identifier: MIT
 *
 * SPI of the STM32F4 as a bus whose writes go on after they have returned: a stream of a DMA controller feeds the
 * data register. Registers: RM0090 10.5. Not tried on hardware. */
#ifndef HAL_MCU_STM32_DMA_H
#define HAL_MCU_STM32_DMA_H

#include "mcu/stm32_spi.h"

HAL_C_BEGIN

struct stm32_dma_stream {
    volatile uint32_t cr, ndtr, par, m0ar, m1ar, fcr; /* DMA_SxCR ... DMA_SxFCR */
};

struct stm32_dma_registers {
    volatile uint32_t isr[2], ifcr[2]; /* DMA_LISR, DMA_HISR, DMA_LIFCR, DMA_HIFCR */
    struct stm32_dma_stream streams[8];
};

#define STM32_DMA2 ((struct stm32_dma_registers *)UINT32_C(0x40026400))

/* Of one stream. Private. */
struct stm32_dma {
    struct stm32_dma_registers *registers;
    struct stm32_dma_stream *stream;
    volatile uint32_t *isr, *ifcr; /* where the stream's flags are, */
    uint8_t flags_shift;           /* and from which bit on */
    const struct stm32_spi *spi;
    bool sending;
};

/* After stm32_spi_init(), with the controller's clock on. Stream and channel that serve the SPI's transmitter: RM0090
 * 10.3.3 (DMA2: SPI1 has stream 3 or 5, channel 3). MCU_ERR_CONFIG: there is no controller, its registers keep
 * nothing; the SPI can be used as it was. MCU_ERR_TIMEOUT: the stream does not stop what it did before. */
HAL_MUST_CHECK int stm32_dma_init(struct stm32_dma *dma, struct stm32_dma_registers *registers, uint8_t stream,
                                  uint8_t channel, const struct stm32_spi *spi);

/* *dma must outlive the bus. Data must be in flash or in the RAM that the controller reaches, not in CCM.
 * MCU_ERR_TIMEOUT: the stream or the SPI has stopped; MCU_ERR_BUS: the controller could not read the data. */
struct bus stm32_dma_bus(struct stm32_dma *dma);

HAL_C_END

#endif
