/* SPDX-License-Identifier: MIT
 *
 * SiFive HiFive1: see README.md for its pins and clocks. */
#include "board.h"

#include "mcu/fe310_gpio.h"
#include "mcu/fe310_prci.h"
#include "mcu/fe310_spi.h"
#include "mcu/mtime.h"

static const struct fe310_pin reset = {.port = FE310_GPIO, .bit = 0};
static const struct fe310_pin dc = {.port = FE310_GPIO, .bit = 1};
static const struct fe310_pin select = {.port = FE310_GPIO, .bit = 2};
static const struct fe310_pin mosi = {.port = FE310_GPIO, .bit = 3};
static const struct fe310_pin sck = {.port = FE310_GPIO, .bit = 5};
static const struct fe310_pin led = {.port = FE310_GPIO, .bit = 22, .inverted = true};
static const struct fe310_pin backlight = {.port = FE310_GPIO, .bit = 23};

static struct mtime mtime;
static struct fe310_spi spi;

/* Modules without chip select want a clock that idles high. */
enum { SPI_MODE = 3 };

/* The panel is selected when SPI has begun: what it may have taken for a bit before is forgotten then. */
static void take_pins(struct board *board)
{
    board->led = fe310_gpio_output(&led, false);
    board->dc = fe310_gpio_output(&dc, false);
    board->reset = fe310_gpio_output(&reset, true);
    board->backlight = fe310_gpio_output(&backlight, false);
    board->select = fe310_gpio_output(&select, true);
    fe310_gpio_lend(&sck);
    fe310_gpio_lend(&mosi);
}

int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    mtime = (struct mtime){.low = FE310_MTIME, .rate_hz = MTIME_HZ};
    board->clock = mtime_clock(&mtime);
    take_pins(board);
    const uint32_t cpu_hz = fe310_prci_init(FE310_PRCI, FE310_QSPI0, &board->clock);
    int err = fe310_spi_init(&spi, FE310_QSPI1, cpu_hz, spi_hz < SPI_MAX_HZ ? spi_hz : SPI_MAX_HZ,
                             spi_mode_of(spi_modes, SPI_MODE));
    if (err) return err;
    board->bus = fe310_spi_bus(&spi);
    return pin_set(&board->select, false);
}
