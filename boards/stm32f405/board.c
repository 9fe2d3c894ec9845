/* SPDX-License-Identifier: MIT
 *
 * Adafruit Feather STM32F405 Express, and what else has an STM32F405: see README.md for its pins and clocks. */
#include "board.h"

#include "mcu/stm32_dma.h"
#include "mcu/stm32_spi.h"
#include "mcu/stm32f4_gpio.h"
#include "mcu/stm32f4_rcc.h"
#include "mcu/systick.h"

enum { SPI1_FUNCTION = 5, SPI1_STREAM = 3, SPI1_CHANNEL = 3 };

/* Modules without chip select want a clock that idles high. */
enum { SPI_MODE = 3 };

static const struct stm32f4_pin select = {.port = STM32F4_GPIOA, .bit = 4};
static const struct stm32f4_pin sck = {.port = STM32F4_GPIOA, .bit = 5};
static const struct stm32f4_pin dc = {.port = STM32F4_GPIOA, .bit = 6};
static const struct stm32f4_pin mosi = {.port = STM32F4_GPIOA, .bit = 7};
static const struct stm32f4_pin reset = {.port = STM32F4_GPIOC, .bit = 4};
static const struct stm32f4_pin backlight = {.port = STM32F4_GPIOC, .bit = 5};
static const struct stm32f4_pin led = {.port = STM32F4_GPIOC, .bit = 1};

static struct systick systick;
static struct stm32_spi spi;
static struct stm32_dma dma;

/* The panel is selected when SPI has begun: what it may have taken for a bit before is forgotten then. */
static void take_pins(struct board *board)
{
    board->led = stm32f4_gpio_output(&led, false);
    board->dc = stm32f4_gpio_output(&dc, false);
    board->reset = stm32f4_gpio_output(&reset, true);
    board->backlight = stm32f4_gpio_output(&backlight, false);
    board->select = stm32f4_gpio_output(&select, true);
    stm32f4_gpio_lend(&sck, SPI1_FUNCTION);
    stm32f4_gpio_lend(&mosi, SPI1_FUNCTION);
}

/* An emulator may have no DMA: then the processor sends every byte. */
static struct bus take_bus(void)
{
    if (stm32_dma_init(&dma, STM32_DMA2, SPI1_STREAM, SPI1_CHANNEL, &spi)) return stm32_spi_bus(&spi);
    return stm32_dma_bus(&dma);
}

int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    const struct stm32f4_clocks clocks = stm32f4_rcc_init(STM32F4_RCC, STM32F4_FLASH_ACR, HSE_HZ);

    stm32f4_rcc_enable(STM32F4_RCC, STM32F4_GPIOA_ON | STM32F4_GPIOC_ON | STM32F4_DMA2_ON, STM32F4_SPI1_ON);
    stm32f4_rcc_reset(STM32F4_RCC, STM32F4_DMA2_ON, STM32F4_SPI1_ON);
    take_pins(board);
    int err = systick_init(&systick, SYSTICK_REGISTERS, clocks.cpu_hz);
    if (err) return err;
    board->clock = systick_clock(&systick);
    err = stm32_spi_init(&spi, STM32_SPI1, clocks.apb2_hz, spi_hz, spi_mode_of(spi_modes, SPI_MODE));
    if (err) return err;
    board->bus = take_bus();
    return pin_set(&board->select, false);
}
