/* SPDX-License-Identifier: MIT
 *
 * "Blue pill" with an STM32F103C8, or an STM32F100 with the same pins: see README.md for pins and clocks. */
#include "board.h"

#include "mcu/stm32_spi.h"
#include "mcu/stm32f1_gpio.h"
#include "mcu/stm32f1_rcc.h"
#include "mcu/systick.h"

static const struct stm32f1_pin select = {.port = STM32F1_GPIOA, .bit = 4};
static const struct stm32f1_pin sck = {.port = STM32F1_GPIOA, .bit = 5};
static const struct stm32f1_pin dc = {.port = STM32F1_GPIOA, .bit = 6};
static const struct stm32f1_pin mosi = {.port = STM32F1_GPIOA, .bit = 7};
static const struct stm32f1_pin reset = {.port = STM32F1_GPIOB, .bit = 0};
static const struct stm32f1_pin backlight = {.port = STM32F1_GPIOB, .bit = 1};
static const struct stm32f1_pin led = {.port = STM32F1_GPIOC, .bit = 13, .inverted = true};

static struct systick systick;
static struct stm32_spi spi;

/* Modules without chip select want a clock that idles high. */
enum { SPI_MODE = 3 };

/* The panel is selected when SPI has begun: what it may have taken for a bit before is forgotten then. */
static void take_pins(struct board *board)
{
    board->led = stm32f1_gpio_output(&led, false);
    board->dc = stm32f1_gpio_output(&dc, false);
    board->reset = stm32f1_gpio_output(&reset, true);
    board->backlight = stm32f1_gpio_output(&backlight, false);
    board->select = stm32f1_gpio_output(&select, true);
    stm32f1_gpio_lend(&sck);
    stm32f1_gpio_lend(&mosi);
}

int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    const uint32_t cpu_hz = stm32f1_rcc_init(STM32F1_RCC, STM32F1_FLASH_ACR, CPU_HZ);

    stm32f1_rcc_enable(STM32F1_RCC, STM32F1_GPIOA_ON | STM32F1_GPIOB_ON | STM32F1_GPIOC_ON | STM32F1_SPI1_ON);
    stm32f1_rcc_reset(STM32F1_RCC, STM32F1_SPI1_ON);
    take_pins(board);
    int err = systick_init(&systick, SYSTICK_REGISTERS, cpu_hz);
    if (err) return err;
    board->clock = systick_clock(&systick);
    err = stm32_spi_init(&spi, STM32_SPI1, cpu_hz, spi_hz < SPI_MAX_HZ ? spi_hz : SPI_MAX_HZ,
                         spi_mode_of(spi_modes, SPI_MODE));
    if (err) return err;
    board->bus = stm32_spi_bus(&spi);
    return pin_set(&board->select, false);
}
